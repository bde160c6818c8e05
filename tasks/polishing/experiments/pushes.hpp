// The largest push at the torso that a standing robot bears, by direction: a search in which every
// run depends on those before it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {

/// A direction and what was tried in it.
struct PushDirection {
  double angle = 0.0;  ///< degrees in the horizontal plane, from straight ahead to the left
  struct Tried {
    double force;    ///< N
    RunFigures run;  ///< with what `measure` of push_run() adds
    bool survived;   ///< it polished on to the path's end without fault, and did not fall
  };
  std::vector<Tried> tried = {};

  /// N, 0 where none was survived.
  double largest_survived() const;
  /// N, infinite where all were survived.
  double smallest_lost() const;
};

/// The push of all directions that comes first, N.
inline constexpr double first_push = 120.0;
/// What is looked for is no larger than this, N.
inline constexpr double largest_push = 480.0;

/// As many as there are, all around, none of them tried.
std::vector<PushDirection> push_directions(int count);

/// N, to be tried next: the first one, twice as much as long as all are survived, then the middle
/// of what is survived and what is not, in whole steps. None where these are a step apart, and
/// where the last one was not made.
std::optional<double> next_push(const PushDirection& direction, double step);

/// A push for 0.3 s at a frame of the standing robot, from a third of the path on. The verdict of
/// the task is off: what is asked is whether it goes on.
BatchRun push_run(const ExperimentSpec& spec, const Task& task, const std::string& frame,
                  double angle, double force);
/// Notes the outcome of such a run.
void note_push(double force, const RunFigures& run, PushDirection& direction);

/// A row per direction: what came of the first push, the largest that is survived, and what came of
/// the smallest that is not.
ResultTable pushes_table(const std::vector<PushDirection>& directions);
Figure pushes_figure(const std::vector<PushDirection>& directions);

}  // namespace burnish::polishing
