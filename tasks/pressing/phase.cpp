#include "base/to_size.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish {

const std::vector<std::string>& phase_names() {
  static const std::vector<std::string> names{"reach", "approach", "ramp",
                                              "track", "retreat",  "home"};
  return names;
}

std::string name_of(Phase phase) { return phase_names()[to_size(number_of(phase))]; }

}  // namespace burnish
