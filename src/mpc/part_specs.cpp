#include "mpc/part_specs.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/contact/loops.hpp"
#include "mpc/closed_dynamics.hpp"
#include "mpc/ground_figures.hpp"
#include "mpc/plan_inputs.hpp"

namespace burnish {
namespace {

/// Returns the index of the tool with the given frame; -1: none.
int tool_at(const MpcSpec& spec, const std::string& frame) {
  const auto tool = std::find_if(spec.tools.begin(), spec.tools.end(),
                                 [&](const ToolSpec& each) { return each.frame == frame; });
  return tool == spec.tools.end() ? -1 : static_cast<int>(tool - spec.tools.begin());
}

/// Returns the frames of the columns of MeasurementGate::wrenches().
std::vector<std::string> measured_frames(const MpcSpec& spec) {
  std::vector<std::string> frames;
  for (const TouchSensor& touch : touch_sensors(spec))
    if (tool_at(spec, touch.frame) < 0 && touch.sensor != WrenchSensor::None)
      frames.push_back(touch.frame);
  return frames;
}

/// Returns the time steps of the knots that a plan keeps. These knots cover the longest time for
/// which a plan is followed: until a fault after too many failed updates.
std::vector<double> plan_steps(const MpcSpec& spec) {
  // With other kinds of PlanTiming, the computing time has no limit, so that all knots are kept.
  if (spec.timing != PlanTiming::Fixed) return knot_steps(spec.problem);
  const double updates = 2.0 + spec.limits.failed_solves;
  const double time = updates * spec.update_period + spec.solver_delay;
  std::vector<double> steps = knot_steps(spec.problem);
  const KnotTimes times(steps);
  // With uneven knots, one step more is kept, because knots may move by half a step to a change of
  // phase.
  const double extra = times.is_even() ? 1.0 : 2.0;
  const double knots = std::ceil(times.place(time)) + extra;
  steps.resize(to_size(std::min<double>(knots, times.knots())));
  return steps;
}

/// Returns the column of a frame in MeasurementGate::wrenches(); -1: no sensor.
int sensor_of(const MpcSpec& spec, const std::string& frame) {
  const std::vector<std::string> frames = measured_frames(spec);
  const auto at = std::find(frames.begin(), frames.end(), frame);
  return at == frames.end() ? -1 : static_cast<int>(at - frames.begin());
}

/// Returns the soles of supports with sensors, from the pressure limits in the first stage.
std::vector<SoleLimits::Sole> soles_of(const MpcSpec& spec) {
  std::vector<SoleLimits::Sole> soles;
  const ProblemSpec& problem = spec.problem;
  if (problem.stages.empty()) return soles;
  for (const std::string& support : spec.supports) {
    const auto contact =
        std::find_if(problem.contacts.begin(), problem.contacts.end(),
                     [&](const ContactSpec& given) { return given.name == support; });
    if (contact == problem.contacts.end()) continue;
    const int sensor = sensor_of(spec, contact->tool);
    if (sensor < 0) continue;
    for (const Constraint& rows : problem.stages.front().constraints) {
      const auto* sole = std::get_if<residual::CenterOfPressure>(&rows.residual);
      if (sole == nullptr || sole->contact != support) continue;
      soles.push_back({contact->tool, sensor, sole->half_x, sole->half_y});
      break;
    }
  }
  return soles;
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
                       .tools = {},
                       .surfaces = tools_of_surfaces(spec),
                       .frictions = tools_of_friction(spec)};
  const ProblemSpec& problem = spec.problem;
  const auto contains = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const ContactSpec& contact : problem.contacts) {
    result.rotations.push_back(contact.reference.rotation_over_time);
    result.tools.push_back(tool_at(spec, contact.tool));
  }
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
                           .tools = {},
                           .force_sensor = true,
                           .supports = supports_of(spec),
                           .held = with_loops(problem.model, supports_of(spec)),
                           .measured = measured_frames(spec),
                           .contacts = stage_contacts(spec),
                           .times = loop_times(spec)};
  if (problem.torque_model) result.torque_cutoff = problem.torque_model->cutoff;
  for (std::size_t i = 0; i < spec.tools.size(); ++i) {
    const ToolSpec& tool = spec.tools[i];
    if (wrench_column(spec, tool.frame) < 0) result.force_sensor = false;
    result.tools.push_back(
        {.normal_world = tool.normal_base, .contact_threshold = tool.contact_threshold});
    const std::vector<int>& frictions = result.contacts.frictions;
    const auto contact = std::find(frictions.begin(), frictions.end(), static_cast<int>(i));
    if (contact == frictions.end()) continue;
    result.tools.back().friction = tool.friction;
    result.tools.back().planned_speed =
        problem.contacts[to_size(contact - frictions.begin())].friction->fade_speed();
  }
  return result;
}

std::vector<GripSpec> grip_specs(const MpcSpec& spec) {
  std::vector<GripSpec> result;
  for (const ContactSpec& contact : supports_of(spec)) {
    const GroundFigures figures = ground_figures(spec.problem, contact.name);
    result.push_back({.name = contact.name,
                      .frame = contact.tool,
                      .sensor = sensor_of(spec, contact.tool),
                      .friction = figures.friction,
                      .half_x = figures.half_x,
                      .half_y = figures.half_y});
  }
  return result;
}

GateSpec gate_spec(const MpcSpec& spec) {
  const ProblemSpec& problem = spec.problem;
  std::vector<ToolFrames> tools;
  for (const ToolSpec& tool : spec.tools) tools.push_back({tool.frame, tool.base});
  return {.model = problem.model,
          .contacts = contacts_at(problem.contacts, problem.start_time),
          .tools = std::move(tools),
          .q_start = problem.initial_state.head(problem.model.nq),
          .touches = touch_sensors(spec),
          .limits = spec.limits,
          .tick_period = spec.tick_period};
}

PolicySpec policy_spec(const MpcSpec& spec) {
  return {.steps = plan_steps(spec), .feedback = spec.feedback, .tick_period = spec.tick_period};
}

HoldingSpec holding_spec(const MpcSpec& spec) {
  const Model& model = spec.problem.model;
  HoldingSpec result{.model = model,
                     .q_start = spec.problem.initial_state.head(model.nq),
                     .fallback = spec.fallback,
                     .tick_period = spec.tick_period,
                     .bad = spec.limits.bad,
                     .supports = supports_of(spec),
                     .sensors = {},
                     .soles = soles_of(spec)};
  for (const ContactSpec& contact : result.supports)
    result.sensors.push_back(sensor_of(spec, contact.tool));
  return result;
}

}  // namespace burnish
