#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

std::vector<std::string> touches_of(const MpcSpec& spec) {
  std::vector<std::string> frames;
  if (!spec.tool.empty()) frames.push_back(spec.tool);
  if (!spec.support_sensors) return frames;
  for (const std::string& support : spec.supports)
    for (const ContactSpec& contact : spec.problem.contacts)
      if (contact.name == support) frames.push_back(contact.tool);
  return frames;
}

}  // namespace burnish
