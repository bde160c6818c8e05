#include "mpc/closed_dynamics.hpp"

#include <algorithm>

#include "burnish/contact/loops.hpp"

namespace burnish {

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_held_always(const ProblemSpec& problem, const std::string& contact) {
  return std::all_of(problem.stages.begin(), problem.stages.end(),
                     [&](const Stage& stage) { return has(stage.contacts, contact); });
}

}  // namespace

std::vector<ContactSpec> supports_of(const MpcSpec& spec) {
  std::vector<ContactSpec> result;
  for (const ContactSpec& contact : spec.problem.contacts)
    if (has(spec.supports, contact.name) && !has(spec.resting_supports, contact.name) &&
        is_held_always(spec.problem, contact.name))
      result.push_back(contact);
  return result;
}

ContactDynamics closed_dynamics(const Model& model, std::vector<ContactSpec> supports) {
  for (ContactSpec& support : supports) support.with_gains(0.0, 0.0);
  std::vector<ContactSpec> held = with_loops(model, std::move(supports), {0.0, 0.0});
  if (held.empty()) return ContactDynamics(model);
  return ContactDynamics(model, held, {.mu = 1e-9});
}

}  // namespace burnish
