#include "mpc/estimator_specs.hpp"

#include <algorithm>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "mpc/closed_dynamics.hpp"
#include "mpc/ground_figures.hpp"
#include "mpc/plan_inputs.hpp"

namespace burnish {
namespace {

/// Returns the frames of all supports, in the order of Measurement::support_wrenches; empty if the
/// specification has no wrench sensors.
std::vector<std::string> measured_frames(const MpcSpec& spec) {
  std::vector<std::string> frames;
  if (!spec.support_sensors) return frames;
  for (const std::string& support : spec.supports)
    for (const ContactSpec& contact : spec.problem.contacts)
      if (contact.name == support) frames.push_back(contact.tool);
  return frames;
}

}  // namespace

LoopTimes loop_times(const MpcSpec& spec) {
  return {.tick_period = spec.tick_period,
          .update_period = spec.update_period,
          .solver_delay = spec.solver_delay,
          .command_delay = spec.command_delay,
          .measurement_delay = spec.measurement_delay};
}

StageContacts stage_contacts(const MpcSpec& spec) {
  StageContacts result{.all = {},
                       .supports = {},
                       .rotations = {},
                       .following = contacts_on_surface(spec.problem.contacts),
                       .with_friction = contacts_with_friction(spec.problem.contacts)};
  const ProblemSpec& problem = spec.problem;
  const auto contains = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const ContactSpec& contact : problem.contacts)
    result.rotations.push_back(contact.reference.rotation_over_time);
  for (const Stage& stage : problem.stages) {
    RobotState::ActiveContacts &all = result.all.emplace_back(),
                               &supports = result.supports.emplace_back();
    for (const ContactSpec& contact : problem.contacts) {
      const bool holds = contains(stage.contacts, contact.name);
      const bool carries = is_loop(problem.model, contact) || contains(spec.supports, contact.name);
      all.push_back(holds ? 1 : 0);
      supports.push_back(holds && carries ? 1 : 0);
    }
  }
  return result;
}

ErrorEstimateSpec error_estimate_spec(const MpcSpec& spec) {
  const ProblemSpec& problem = spec.problem;
  ErrorEstimateSpec result{.model = problem.model,
                           .options = spec.model_error,
                           .torque_cutoff = {},
                           .normal_world = spec.normal_base,
                           .contact_threshold = spec.contact_threshold,
                           .force_sensor = spec.force_sensor,
                           .supports = supports_of(problem, spec.supports),
                           .held = with_loops(problem.model, supports_of(problem, spec.supports)),
                           .measured = measured_frames(spec),
                           .contacts = stage_contacts(spec),
                           .friction = {},
                           .times = loop_times(spec)};
  if (problem.torque_model) result.torque_cutoff = problem.torque_model->cutoff;
  if (!result.contacts.with_friction.empty()) {
    const int contact = result.contacts.with_friction.front();
    result.friction = spec.friction_estimate;
    result.planned_speed = problem.contacts[to_size(contact)].friction->fade_speed();
  }
  return result;
}

std::vector<GripSpec> grip_specs(const MpcSpec& spec) {
  std::vector<GripSpec> result;
  for (const ContactSpec& contact : supports_of(spec.problem, spec.supports)) {
    const auto at = std::find(spec.supports.begin(), spec.supports.end(), contact.name);
    const GroundFigures figures = ground_figures(spec.problem, contact.name);
    result.push_back(
        {.name = contact.name,
         .frame = contact.tool,
         .sensor = spec.support_sensors ? static_cast<int>(at - spec.supports.begin()) : -1,
         .friction = figures.friction,
         .half_x = figures.half_x,
         .half_y = figures.half_y});
  }
  return result;
}

}  // namespace burnish
