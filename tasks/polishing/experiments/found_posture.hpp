// A start that was searched for, kept with the robot so that no run searches it again.
#pragma once

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// The model's posture by its joints; followers are left out. `q`: nq.
Posture posture_of(const Model& model, const Eigen::VectorXd& q);

/// Adds the start to the robot's postures and makes it the task's.
void start_from(const Eigen::VectorXd& q, Robot& robot, Task& task);

}  // namespace burnish::polishing
