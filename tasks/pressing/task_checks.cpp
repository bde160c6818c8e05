#include "pressing/task_checks.hpp"

#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"

namespace burnish::pressing {

void check_durations(const std::vector<std::pair<std::string, double>>& durations) {
  constexpr double longest = 1e4;  // s
  for (const auto& [entry, time] : durations)
    if (!(time <= longest))
      throw EntryError(entry,
                       "it takes " + number(time) + " s; wanted at most " + number(longest) + " s");
}

void check_contact_step(double step, const std::string& named, double kd) {
  if (step * kd < 2.0) return;
  throw EntryError("controller.step",
                   "it is " + number(step) + " s and " + named + " " + number(kd) +
                       " 1/s: errors of the contact grow in such steps, and it is not held; wanted "
                       "a step below " +
                       number(2.0 / kd) + " s, or better of at most " + number(0.5 / kd) + " s");
}

void check_plan_times(const PlanTimes& times) {
  const double ticks = times.tick_rate / times.update_rate;
  if (!(ticks >= 1.0 - 1e-9) || std::abs(ticks - std::round(ticks)) > 1e-6)
    throw EntryError("controller.update_rate",
                     "it is " + number(times.update_rate) + " Hz and tick_rate " +
                         number(times.tick_rate) +
                         " Hz; wanted a whole number of ticks per update");
  if (times.solver_delay > 1.0 / times.update_rate + 1e-12)
    throw EntryError("controller.solver_delay",
                     "it is " + number(times.solver_delay) + " s; wanted at most the " +
                         number(1.0 / times.update_rate) + " s between two updates");
  if (times.step * times.knots > times.horizon + 1e-9)
    throw EntryError("controller.knots", number(times.knots) + " knots of " + number(times.step) +
                                             " s at least are longer than the horizon of " +
                                             number(times.horizon) + " s; wanted fewer");
}

void note_friction(const std::string& key, double friction, double usual,
                   const Disturbances& disturbances, std::vector<std::string>& notes) {
  const std::optional<double>& instead = disturbances.surface_friction;
  if (!instead || *instead == friction || friction == usual) return;
  notes.push_back(key + " of " + number(friction) +
                  " has no effect: disturbances.surface_friction of " + number(*instead) +
                  " stands in its place; set that to none for the surface's own");
}

void note_delays(const KnownDelays& known, const Disturbances& disturbances,
                 std::vector<std::string>& notes) {
  constexpr double tolerated = 2e-3;  // s, that arms tolerate unknown
  const double there = disturbances.command_delay + disturbances.measurement_delay;
  const double told = known.command + known.measurement;
  if (std::abs(there - told) <= tolerated + 1e-9) return;
  notes.push_back("commands and measurements are " + number(1e3 * there) +
                  " ms late (disturbances.command_delay, measurement_delay), and the controller "
                  "knows of " +
                  number(1e3 * told) +
                  " ms (controller.command_delay, measurement_delay): state both alike unless that "
                  "is the experiment");
}

}  // namespace burnish::pressing
