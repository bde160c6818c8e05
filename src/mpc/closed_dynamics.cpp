#include "mpc/closed_dynamics.hpp"

#include <algorithm>

#include "burnish/contact/loops.hpp"

namespace burnish {

std::vector<ContactSpec> supports_of(const MpcSpec& spec) {
  std::vector<ContactSpec> result;
  for (const ContactSpec& contact : spec.problem.contacts)
    if (std::find(spec.supports.begin(), spec.supports.end(), contact.name) != spec.supports.end())
      result.push_back(contact);
  return result;
}

bool carries(const MpcSpec& spec, const ContactSpec& contact) {
  return is_loop(spec.problem.model, contact) ||
         std::find(spec.supports.begin(), spec.supports.end(), contact.name) != spec.supports.end();
}

ContactDynamics closed_dynamics(const Model& model, std::vector<ContactSpec> supports) {
  for (ContactSpec& support : supports) support.with_gains(0.0, 0.0);
  std::vector<ContactSpec> held = with_loops(model, std::move(supports), {0.0, 0.0});
  if (held.empty()) return ContactDynamics(model);
  return ContactDynamics(model, held, {.mu = 1e-9});
}

}  // namespace burnish
