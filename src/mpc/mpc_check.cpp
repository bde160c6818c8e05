#include "mpc/mpc_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/mpc/knot_times.hpp"
#include "mpc/descriptions.gen.hpp"

namespace burnish {
namespace {

/// Returns the duration of the horizon. Throws Error unless all stages have the same step or all
/// knots have their own steps, because knots keep their steps while stages move along the horizon.
double duration_of(const ProblemSpec& problem) {
  if (problem.stages.empty()) throw Error("MPC: the problem has no stages; wanted at least one");
  const bool own = std::all_of(problem.horizon.begin(), problem.horizon.end(),
                               [](const HorizonSegment& segment) { return segment.step > 0.0; });
  for (const Stage& stage : problem.stages) {
    if (stage.impact)
      throw Error("MPC: stage " + in_quotes(stage.name) +
                  " is an impact; wanted stages with a time step");
    if (!own && stage.step != problem.stages[0].step)
      throw Error("MPC: stage " + in_quotes(stage.name) + " has a step of " + number(stage.step) +
                  " s; wanted the step of the other stages, " + number(problem.stages[0].step) +
                  " s, or horizon segments with their own steps");
  }
  const KnotTimes times(knot_steps(problem));
  return times.after(times.knots());
}

int ticks_per_update(const MpcSpec& spec) {
  // Shortest tick period [s]. It limits the memory of the flight recorder, which has a row for each
  // tick of the last second.
  constexpr double min_period = 1e-5;
  if (!(spec.tick_period >= min_period))
    throw Error("MPC: tick_period is " + number(spec.tick_period) + " s; wanted at least " +
                number(min_period) + " s");
  const double ratio = spec.update_period / spec.tick_period;
  if (!(ratio > 0.5) || !(ratio < 1e9) || std::abs(ratio - std::round(ratio)) > 1e-6)
    throw Error("MPC: update_period is " + number(spec.update_period) +
                " s; wanted a multiple of tick_period, " + number(spec.tick_period) + " s");
  return static_cast<int>(std::lround(ratio));
}

void check_limits(const SafetyLimits& limits, double tick_period) {
  check_ranges(description_of(&limits), &limits,
               [](const std::string& entry) { return "MPC: the limit " + entry; });
  if (!(limits.stale > tick_period))
    throw Error("MPC: limits.stale is " + number(limits.stale) +
                " s; wanted more than tick_period, " + number(tick_period) + " s");
}

/// Checks the tools: frames must exist, each tool must be stated once, and forces must be known.
void check_tools(const MpcSpec& spec) {
  const Model& model = spec.problem.model;
  std::vector<std::string> frames, seen;
  for (const Frame& frame : model.frames) frames.push_back(frame.name);
  for (const ToolSpec& tool : spec.tools) {
    const std::string what = "MPC: tool " + in_quotes(tool.frame);
    if (!model.has_frame(tool.frame))
      throw Error(what + " is not a frame of the robot" + did_you_mean(tool.frame, frames));
    if (!tool.base.empty() && !model.has_frame(tool.base))
      throw Error(what + " presses on a surface of " + in_quotes(tool.base) +
                  ", which is not a frame of the robot" + did_you_mean(tool.base, frames));
    if (std::find(seen.begin(), seen.end(), tool.frame) != seen.end())
      throw Error("MPC: tools has two entries for frame " + in_quotes(tool.frame) +
                  "; wanted one entry");
    seen.push_back(tool.frame);
    for (const ContactSpec& contact : spec.problem.contacts)
      if ((contact.tool == tool.frame || contact.name == tool.frame) &&
          std::find(spec.supports.begin(), spec.supports.end(), contact.name) !=
              spec.supports.end())
        throw Error(what + " is also the frame or the name of support " + in_quotes(contact.name) +
                    "; wanted a tool or a support");
    if (!tool.normal_base.allFinite() || !(tool.normal_base.norm() > 0.0))
      throw Error(what + " has a normal that is not finite or has length 0; wanted a direction");
    check_ranges(description_of(&tool), &tool,
                 [&](const std::string& entry) { return what + ": " + entry; });
    if (wrench_column(spec, tool.frame) >= 0) continue;
    if (spec.tools.size() > 1)
      throw Error(what + " has no force sensor, and a force can be estimated only for a single " +
                  "tool; wanted a force sensor at each of the " +
                  std::to_string(spec.tools.size()) + " tools (touches)");
    if (spec.model_error.kind != ModelErrorKind::Torque)
      throw Error(what +
                  " has no force sensor, so its force is estimated from torques, which requires an "
                  "estimate of the torque error; wanted model_error.kind torque, or a force sensor "
                  "at the tool (touches)");
  }
}

/// Checks the touches: each must be a frame of the robot, stated once.
void check_touches(const MpcSpec& spec) {
  const Model& model = spec.problem.model;
  std::vector<std::string> frames, seen;
  for (const Frame& frame : model.frames) frames.push_back(frame.name);
  for (const TouchSensor& touch : spec.touches) {
    if (!model.has_frame(touch.frame))
      throw Error("MPC: touch " + in_quotes(touch.frame) + " is not a frame of the robot" +
                  did_you_mean(touch.frame, frames));
    if (std::find(seen.begin(), seen.end(), touch.frame) != seen.end())
      throw Error("MPC: touches has two entries for frame " + in_quotes(touch.frame) +
                  "; wanted one entry");
    seen.push_back(touch.frame);
  }
}

/// Returns the support's contact. Throws Error if the problem has none.
const ContactSpec& contact_of(const ProblemSpec& problem, const std::string& support) {
  std::vector<std::string> names;
  for (const ContactSpec& contact : problem.contacts) {
    if (contact.name == support) return contact;
    names.push_back(contact.name);
  }
  throw Error("MPC: support " + in_quotes(support) + " is not a contact of the problem" +
              did_you_mean(support, names));
}

std::string wanted_sensor(const ContactSpec& contact) {
  return "a sensor of force" + std::string(contact.directions.has_angular() ? " and moment" : "") +
         " at " + in_quotes(contact.tool) + " (touches)";
}

/// Checks each support: it must be in contact in every stage, or its wrench must be measured.
void check_supports(const MpcSpec& spec) {
  const ProblemSpec& problem = spec.problem;
  for (const std::string& support : spec.supports) {
    const ContactSpec& contact = contact_of(problem, support);
    const bool is_measured = wrench_column(spec, contact.tool) >= 0;
    for (const TouchSensor& touch : touch_sensors(spec))
      if (touch.frame == contact.tool && touch.sensor == WrenchSensor::Force &&
          contact.directions.has_angular())
        throw Error("MPC: the sensor at " + in_quotes(touch.frame) +
                    " measures no moment, but "
                    "support " +
                    in_quotes(support) + " also holds rotations; wanted " + wanted_sensor(contact) +
                    ", or sensor none");
    for (const Stage& stage : problem.stages)
      if (!is_measured &&
          std::find(stage.contacts.begin(), stage.contacts.end(), support) == stage.contacts.end())
        throw Error("MPC: stage " + in_quotes(stage.name) +
                    " does not contain the contact of support " + in_quotes(support) +
                    "; wanted this support in every stage, or " + wanted_sensor(contact));
  }
}

/// Checks the contacts of stages: each must be a support or a loop, or be at a tool.
void check_contacts(const MpcSpec& spec) {
  const ProblemSpec& problem = spec.problem;
  for (const Stage& stage : problem.stages)
    for (const std::string& name : stage.contacts) {
      const auto contact = std::find_if(problem.contacts.begin(), problem.contacts.end(),
                                        [&](const ContactSpec& each) { return each.name == name; });
      if (contact == problem.contacts.end()) continue;  // the problem refuses the stage
      const bool is_support =
          std::find(spec.supports.begin(), spec.supports.end(), name) != spec.supports.end();
      const bool is_at_tool =
          std::any_of(spec.tools.begin(), spec.tools.end(),
                      [&](const ToolSpec& tool) { return tool.frame == contact->tool; });
      if (is_support || is_at_tool || is_loop(problem.model, *contact)) continue;
      throw Error(
          "MPC: contact " + in_quotes(name) + " of stage " + in_quotes(stage.name) +
          " is neither at a tool nor a support, so its force would count as a torque error; "
          "wanted a tool at frame " +
          in_quotes(contact->tool) + " (tools), or " + in_quotes(name) + " in supports");
    }
}

/// Checks the resting supports: each must be a support with a measured wrench.
void check_resting(const MpcSpec& spec) {
  for (const std::string& resting : spec.resting_supports) {
    if (std::find(spec.supports.begin(), spec.supports.end(), resting) == spec.supports.end())
      throw Error("MPC: resting support " + in_quotes(resting) + " is not one of the supports" +
                  did_you_mean(resting, spec.supports));
    const ContactSpec& contact = contact_of(spec.problem, resting);
    if (wrench_column(spec, contact.tool) < 0)
      throw Error("MPC: the force of resting support " + in_quotes(resting) +
                  " is not measured; wanted " + wanted_sensor(contact));
  }
}

void check_torque_limit(const MpcSpec& spec) {
  const Eigen::VectorXd& limit = spec.torque_limit;
  if (limit.size() == 0) return;
  if (limit.size() != spec.problem.model.nv)
    throw Error("MPC: torque_limit has " + std::to_string(limit.size()) + " entries; wanted " +
                std::to_string(spec.problem.model.nv) + ", or none");
  for (Eigen::Index k = 0; k < limit.size(); ++k)
    if (!(limit[k] >= 0.0))
      throw Error("MPC: torque_limit of " +
                  in_quotes(spec.problem.model.v_name(static_cast<int>(k))) + " is " +
                  number(limit[k]) + "; wanted at least 0");
}

void check_delays(const MpcSpec& spec) {
  if (!(spec.solver_delay >= 0.0) ||
      (spec.timing == PlanTiming::Fixed && spec.solver_delay > spec.update_period))
    throw Error("MPC: solver_delay is " + number(spec.solver_delay) +
                " s; wanted between 0 and update_period, " + number(spec.update_period) + " s");
  constexpr double max_delay = 0.1;  // largest delay [s]
  for (const auto& [name, delay] :
       {std::pair("command", spec.command_delay), {"measurement", spec.measurement_delay}})
    if (!(delay >= 0.0 && delay <= max_delay))
      throw Error("MPC: " + std::string(name) + "_delay is " + number(delay) +
                  " s; wanted between 0 and " + number(max_delay) + " s");
}

}  // namespace

int checked_ticks_per_update(const MpcSpec& spec) {
  const int ticks = ticks_per_update(spec);
  if (spec.problem.torque_model && spec.problem.torque_model->is_held())
    throw Error(
        "MPC: the torque model 'held' does not work with MPC, because it keeps torques constant "
        "over each step of a plan, but the controller changes torques at every tick; wanted a "
        "torque model with a cut-off, or no torque model");
  if (!spec.problem.force_states.empty())
    throw Error(
        "MPC: force_states do not work with MPC, because they are the forces of the previous step, "
        "but plans start at ticks, which are shorter than steps; wanted no force_states");
  if (!(spec.settle >= 0.0) || !std::isfinite(spec.settle))
    throw Error("MPC: settle is " + number(spec.settle) + " s; wanted at least 0");
  if (!(spec.slowdown > 0.0) || !std::isfinite(spec.slowdown))
    throw Error("MPC: slowdown is " + number(spec.slowdown) + "; wanted a positive number");
  check_delays(spec);
  const double horizon = duration_of(spec.problem);
  if (!(horizon > 2.0 * spec.update_period))
    throw Error("MPC: the horizon is " + number(horizon) +
                " s; wanted more than two update periods of " + number(spec.update_period) + " s");
  // Largest number of knots; chosen by hand. A larger plan takes 0.1 s or more, which is too long
  // for a controller.
  constexpr long knot_limit = 10'000;
  if (const auto knots = static_cast<long>(knot_steps(spec.problem).size()); knots > knot_limit)
    throw Error("MPC: the horizon of " + number(horizon) + " s has " + std::to_string(knots) +
                " knots; wanted at most " + std::to_string(knot_limit) +
                ": a shorter horizon, or a longer step");
  if (spec.first_iterations < 1 || spec.jump_iterations < 1 || spec.solver.max_iterations < 1)
    throw Error(
        "MPC: the smallest of first_iterations, jump_iterations and solver.max_iterations is " +
        std::to_string(
            std::min({spec.first_iterations, spec.jump_iterations, spec.solver.max_iterations})) +
        "; wanted at least 1");
  for (const auto& [name, count] : {std::pair("max_factorizations", spec.max_factorizations),
                                    {"first_max_factorizations", spec.first_max_factorizations}})
    if (count < 1)
      throw Error("MPC: " + std::string(name) + " is " + std::to_string(count) +
                  "; wanted at least 1");
  check_torque_limit(spec);
  check_tools(spec);
  check_touches(spec);
  check_supports(spec);
  check_contacts(spec);
  check_resting(spec);
  check_ranges(description_of(&spec.fallback), &spec.fallback,
               [](const std::string& entry) { return "MPC: the fallback's " + entry; });
  check_limits(spec.limits, spec.tick_period);
  return ticks;
}

}  // namespace burnish
