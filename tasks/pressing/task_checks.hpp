// Consistency checks of task entries: durations, ticks, plans, delays.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/sim/disturbances.hpp"

namespace burnish::pressing {

/// Throws EntryError for a duration above 1e4 s. `durations`: pairs of an entry's name and its
/// duration [s].
void check_durations(const std::vector<std::pair<std::string, double>>& durations);

/// Throws EntryError for `controller.step` if the step of plans [s] is at least 2 / kd, because
/// contact errors would then grow from knot to knot. `kd`: damping of the contact [1/s]; `named`:
/// entry that states `kd`.
void check_contact_step(double step, const std::string& named, double kd);

/// Rates and times of plans and of their knots.
struct PlanTimes {
  double tick_rate, update_rate;       ///< Rates [Hz].
  double solver_delay, horizon, step;  ///< Times [s].
  int knots;
};
/// Throws EntryError for `controller` in three cases: updates fall between ticks, the delay exceeds
/// the time between two updates, or the knots do not fit into the horizon.
void check_plan_times(const PlanTimes& times);

template <class Task>
PlanTimes plan_times_of(const Task& task) {
  return {task.tick_rate, task.update_rate, task.solver_delay, task.horizon, task.step, task.knots};
}

/// Adds a note if a stated `friction` of the surface has no effect because the disturbances state
/// another friction. `key`: key of `friction` in task files, such as "surface.friction"; `usual`:
/// default of this key.
void note_friction(const std::string& key, double friction, double usual,
                   const Disturbances& disturbances, std::vector<std::string>& notes);

/// Delays that the controller assumes [s].
struct AssumedDelays {
  double command, measurement;
};
/// Adds a note if the sum of the assumed delays differs from the sum of the plant's delays by more
/// than 2 ms.
void note_delays(const AssumedDelays& controller, const Disturbances& disturbances,
                 std::vector<std::string>& notes);

}  // namespace burnish::pressing
