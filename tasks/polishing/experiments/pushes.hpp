// Search for the largest push at the torso that a standing robot survives, by direction. The force
// of each push depends on the outcomes of earlier runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {

/// Direction of pushes, with all pushes tried in this direction.
struct PushDirection {
  double angle = 0.0;  ///< Angle in the horizontal plane, from straight ahead to the left [deg].
  struct Trial {
    double force;    ///< Force of the push [N].
    RunFigures run;  ///< Figures of the run, with the measurements of push_run().
    bool survived;   ///< True if the run reached the end of the path without a fault or a fall.
  };
  std::vector<Trial> tried = {};

  /// Returns the largest survived push; 0 if none was survived [N].
  double largest_survived() const;
  /// Returns the smallest push that was not survived; infinite if all were survived [N].
  double smallest_lost() const;
};

/// Force of the first push in every direction; chosen by hand [N].
inline constexpr double first_push = 120.0;
/// Largest push of the search; chosen by hand [N].
inline constexpr double largest_push = 480.0;

/// Returns `count` evenly spaced horizontal directions, without trials.
std::vector<PushDirection> push_directions(int count);

/// Returns the next push to try, a multiple of `step` [N]. The search begins with first_push,
/// doubles the push up to largest_push while all pushes are survived, and then bisects. Returns
/// nothing if the search is finished, or if the last run was not made.
std::optional<double> next_push(const PushDirection& direction, double step);

/// Returns a run in which a push of 0.3 s acts at `frame` of the standing robot, after a third of
/// the path. The verdict of the task is off, because only survival counts.
BatchRun push_run(const ExperimentSpec& spec, const Task& task, const std::string& frame,
                  double angle, double force);
/// Adds the outcome of a run to a direction.
void note_push(double force, const RunFigures& run, PushDirection& direction);

/// Returns a table with a row per direction: the outcome of the first push, the largest survived
/// push, and the outcome of the smallest push that the robot did not survive.
ResultTable pushes_table(const std::vector<PushDirection>& directions);
Figure pushes_figure(const std::vector<PushDirection>& directions);

}  // namespace burnish::polishing
