#include "pressing/task_checks.hpp"

#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"

namespace burnish::pressing {

void check_durations(const std::vector<std::pair<std::string, double>>& durations) {
  constexpr double max_duration = 1e4;  // longest permitted duration [s]
  for (const auto& [entry, time] : durations)
    if (!(time <= max_duration))
      throw EntryError(
          entry, "it takes " + number(time) + " s; wanted at most " + number(max_duration) + " s");
}

void check_contact_step(double step, const std::string& named, double kd) {
  if (step * kd < 2.0) return;
  throw EntryError("controller.step",
                   "it is " + number(step) + " s and " + named + " is " + number(kd) +
                       " 1/s: errors of the contact grow with such steps; wanted a step below " +
                       number(2.0 / kd) + " s, or better at most " + number(0.5 / kd) + " s");
}

void check_plan_times(const PlanTimes& times) {
  const double ticks = times.tick_rate / times.update_rate;
  if (!(ticks >= 1.0 - 1e-9) || std::abs(ticks - std::round(ticks)) > 1e-6)
    throw EntryError("controller.update_rate",
                     "it is " + number(times.update_rate) + " Hz and tick_rate is " +
                         number(times.tick_rate) +
                         " Hz; wanted a whole number of ticks per update");
  if (times.solver_delay > 1.0 / times.update_rate + 1e-12)
    throw EntryError("controller.solver_delay",
                     "it is " + number(times.solver_delay) + " s; wanted at most the " +
                         number(1.0 / times.update_rate) + " s between two updates");
  if (times.step * times.knots > times.horizon + 1e-9)
    throw EntryError("controller.knots", number(times.knots) + " knots of at least " +
                                             number(times.step) +
                                             " s are longer than the horizon of " +
                                             number(times.horizon) + " s; wanted fewer knots");
}

void note_friction(const std::string& key, double friction, double usual,
                   const Disturbances& disturbances, std::vector<std::string>& notes) {
  const std::optional<double>& instead = disturbances.surface_friction;
  if (!instead || *instead == friction || friction == usual) return;
  notes.push_back(key + " of " + number(friction) +
                  " has no effect: disturbances.surface_friction of " + number(*instead) +
                  " replaces it; set disturbances.surface_friction to none to use " + key);
}

void note_delays(const AssumedDelays& controller, const Disturbances& disturbances,
                 std::vector<std::string>& notes) {
  constexpr double tolerance = 2e-3;  // unmodelled delay that arms tolerate [s]
  const double actual = disturbances.command_delay + disturbances.measurement_delay;
  const double assumed = controller.command + controller.measurement;
  if (std::abs(actual - assumed) <= tolerance + 1e-9) return;
  notes.push_back("commands and measurements are " + number(1e3 * actual) +
                  " ms late in all (disturbances.command_delay, measurement_delay), but the "
                  "controller assumes " +
                  number(1e3 * assumed) +
                  " ms (controller.command_delay, measurement_delay); set equal delays unless the "
                  "difference is intended");
}

}  // namespace burnish::pressing
