#include "mpc/mpc_check.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "burnish/mpc/knot_times.hpp"
#include "mpc/descriptions.gen.hpp"

namespace burnish {
namespace {

/// A knot keeps its step while stages pass over it.
double duration_of(const ProblemSpec& problem) {
  if (problem.stages.empty()) throw Error("MPC: the problem has no stages");
  const bool own = std::all_of(problem.horizon.begin(), problem.horizon.end(),
                               [](const HorizonSegment& segment) { return segment.step > 0.0; });
  for (const Stage& stage : problem.stages) {
    if (stage.impact)
      throw Error("MPC: stage " + in_quotes(stage.name) + " is an impact; wanted steps of time");
    if (!own && stage.step != problem.stages[0].step)
      throw Error("MPC: stage " + in_quotes(stage.name) + " has a step of " + number(stage.step) +
                  " s; wanted that of the others, " + number(problem.stages[0].step) +
                  " s, or segments of the horizon that state steps of their own");
  }
  const KnotTimes times(knot_steps(problem));
  return times.after(times.knots());
}

int ticks_per_update(const MpcSpec& spec) {
  constexpr double shortest = 1e-5;  // s: the record of the last second has a row for each
  if (!(spec.tick_period >= shortest))
    throw Error("MPC: a tick of " + number(spec.tick_period) + " s; wanted at least " +
                number(shortest) + " s");
  const double ratio = spec.update_period / spec.tick_period;
  if (!(ratio > 0.5) || !(ratio < 1e9) || std::abs(ratio - std::round(ratio)) > 1e-6)
    throw Error("MPC: an update period of " + number(spec.update_period) +
                " s; wanted a multiple of the tick of " + number(spec.tick_period) + " s");
  return static_cast<int>(std::lround(ratio));
}

void check_limits(const SafetyLimits& limits, double tick_period) {
  check_ranges(description_of(&limits), &limits,
               [](const std::string& entry) { return "MPC: the limit " + entry; });
  if (!(limits.stale > tick_period))
    throw Error("MPC: measurements are stale after " + number(limits.stale) +
                " s; wanted longer than the tick of " + number(tick_period) + " s");
}

/// What the robot stands on is held in every stage, or else measured.
void check_supports(const MpcSpec& spec) {
  const ProblemSpec& problem = spec.problem;
  std::vector<std::string> names;
  for (const ContactSpec& contact : problem.contacts) names.push_back(contact.name);
  for (const std::string& support : spec.supports) {
    if (std::find(names.begin(), names.end(), support) == names.end())
      throw Error("MPC: support " + in_quotes(support) + " is no contact of the problem" +
                  did_you_mean(support, names));
    for (const Stage& stage : problem.stages)
      if (!spec.support_sensors &&
          std::find(stage.contacts.begin(), stage.contacts.end(), support) == stage.contacts.end())
        throw Error("MPC: stage " + in_quotes(stage.name) + " does without support " +
                    in_quotes(support) +
                    "; wanted supports in every stage, or support_sensors that measure them");
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
                  number(limit[k]) + "; wanted a number of at least 0");
}

void check_delays(const MpcSpec& spec) {
  if (!(spec.solver_delay >= 0.0) ||
      (spec.timing == PlanTiming::Fixed && spec.solver_delay > spec.update_period))
    throw Error("MPC: a solver delay of " + number(spec.solver_delay) +
                " s; wanted between 0 and the update period of " + number(spec.update_period) +
                " s");
  constexpr double longest = 0.1;  // s
  for (const auto& [name, delay] :
       {std::pair("command", spec.command_delay), {"measurement", spec.measurement_delay}})
    if (!(delay >= 0.0 && delay <= longest))
      throw Error("MPC: a " + std::string(name) + " delay of " + number(delay) +
                  " s; wanted between 0 and " + number(longest) + " s");
}

}  // namespace

int checked_ticks_per_update(const MpcSpec& spec) {
  const int ticks = ticks_per_update(spec);
  if (spec.problem.torque_model && spec.problem.torque_model->is_held())
    throw Error(
        "MPC: torques are held over the steps of a plan, and ticks are shorter; wanted a torque "
        "model with a cut-off, whose rates are those of any time, or none");
  if (!spec.problem.remembered_forces.empty())
    throw Error(
        "MPC: forces of the step before are those of a plan's step, and ticks are shorter; wanted "
        "no remembered_forces");
  if (!spec.normal_world.allFinite() || !(spec.normal_world.norm() > 0.0))
    throw Error("MPC: the normal is not finite or has no length; wanted a direction");
  if (!(spec.settle >= 0.0) || !std::isfinite(spec.settle))
    throw Error("MPC: settling for " + number(spec.settle) + " s; wanted a number of at least 0");
  if (!(spec.slowdown > 0.0) || !std::isfinite(spec.slowdown))
    throw Error("MPC: a slowdown of " + number(spec.slowdown) + "; wanted a positive number");
  check_delays(spec);
  const double horizon = duration_of(spec.problem);
  if (!(horizon > 2.0 * spec.update_period))
    throw Error("MPC: a horizon of " + number(horizon) +
                " s; wanted longer than two update periods of " + number(spec.update_period) +
                " s");
  // A plan of so many knots takes a tenth of a second and more: no controller waits for it.
  constexpr long most_knots = 10'000;
  if (const auto knots = static_cast<long>(knot_steps(spec.problem).size()); knots > most_knots)
    throw Error("MPC: a horizon of " + number(horizon) + " s has " + std::to_string(knots) +
                " knots; wanted at most " + std::to_string(most_knots) +
                ": a shorter horizon, or a longer step");
  if (spec.first_iterations < 1 || spec.jump_iterations < 1 || spec.solver.max_iterations < 1)
    throw Error("MPC: a solve of " +
                std::to_string(std::min(
                    {spec.first_iterations, spec.jump_iterations, spec.solver.max_iterations})) +
                " iterations; wanted at least 1");
  for (const auto& [name, factors] :
       {std::pair("max_factors", spec.max_factors), {"first_factors", spec.first_factors}})
    if (factors < 1)
      throw Error("MPC: " + std::string(name) + " is " + std::to_string(factors) +
                  "; wanted at least 1");
  check_torque_limit(spec);
  check_supports(spec);
  if (!spec.force_sensor && spec.model_error.kind != ModelErrorKind::Torque)
    throw Error(
        "MPC: without a force sensor the force is told from torques, whose model error has to be "
        "known; wanted model_error.kind torque");
  check_ranges(description_of(&spec.fallback), &spec.fallback,
               [](const std::string& entry) { return "MPC: the fallback's " + entry; });
  check_limits(spec.limits, spec.tick_period);
  if (!(spec.contact_threshold >= 0.0))
    throw Error("MPC: a contact threshold of " + number(spec.contact_threshold) +
                " N; wanted a number that is not negative");
  return ticks;
}

}  // namespace burnish
