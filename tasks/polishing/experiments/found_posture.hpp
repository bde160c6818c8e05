// Storage of a start posture in the robot, so that runs do not repeat the posture search.
#pragma once

#include "burnish/robots/robot.hpp"
#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// Returns the joint values of q (nq entries) by joint name, without joints that follow others.
Posture posture_of(const Model& model, const Eigen::VectorXd& q);

/// Adds `q` to the postures of the robot and selects it in the task.
void start_from(const Eigen::VectorXd& q, Robot& robot, Task& task);

}  // namespace burnish::polishing
