// What numbers of tasks on feet have to be together: durations, ticks, plans.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/sim/disturbances.hpp"

namespace burnish::pressing {

/// Entries and the s that they take. Throws EntryError for one that takes longer than 1e4 s.
void check_durations(const std::vector<std::pair<std::string, double>>& durations);

/// Throws EntryError, of `controller.step`, for plans in whose steps (s) a contact that is held
/// with the damping kd (1/s) of the entry `named` does not come to rest: errors grow from 2 / kd
/// on.
void check_contact_step(double step, const std::string& named, double kd);

/// When plans are made, and over which knots that grow.
struct PlanTimes {
  double tick_rate, update_rate;       ///< Hz
  double solver_delay, horizon, step;  ///< s
  int knots;
};
/// Throws EntryError, of the section `controller`, for updates between ticks, plans that would be
/// used after the next one, and knots that do not fit into the horizon.
void check_plan_times(const PlanTimes& times);

/// Those of a task.
template <class Task>
PlanTimes plan_times_of(const Task& task) {
  return {task.tick_rate, task.update_rate, task.solver_delay, task.horizon, task.step, task.knots};
}

/// Adds a sentence where a friction of the surface that is not its default has no effect, because
/// disturbances say another. `key`: such as "surface.friction".
void note_friction(const std::string& key, double friction, double usual,
                   const Disturbances& disturbances, std::vector<std::string>& notes);

/// Delays that the controller knows of, s.
struct KnownDelays {
  double command, measurement;
};
/// Adds a sentence where they are off those of the plant by more than they may be unknown.
void note_delays(const KnownDelays& known, const Disturbances& disturbances,
                 std::vector<std::string>& notes);

}  // namespace burnish::pressing
