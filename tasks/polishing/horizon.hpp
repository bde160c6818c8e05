// Knots of the plans (MPC horizons) of a task.
#pragma once

#include <cmath>

#include "burnish/ocp/problem_spec.hpp"
#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

inline HorizonSegment horizon_of(const Task& task, const std::string& stage) {
  if (task.knots > 0)
    return {.stage = stage, .knots = task.knots, .step = task.step, .duration = task.horizon};
  return {.stage = stage, .knots = static_cast<int>(std::lround(task.horizon / task.step))};
}

}  // namespace burnish::polishing
