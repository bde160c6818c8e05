#include "mpc/closed_dynamics.hpp"

#include "burnish/contact/loops.hpp"

namespace burnish {

ContactDynamics closed_dynamics(const Model& model) {
  if (model.loops.empty()) return ContactDynamics(model);
  return ContactDynamics(model, loop_contacts(model, {0.0, 0.0}), {.mu = 1e-9});
}

}  // namespace burnish
