// Plan and check of the move from a robot's home posture to the start of a task.
#pragma once

#include <optional>

#include "burnish/robots/robot.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// Returns the move from home to the start posture; nullopt if the task states no home. The move is
/// straight in joint space unless check_home_move() finds that the robot would touch the surface.
/// In that case, the move passes through a corner: the start posture, lifted along the normal by
/// 0.05, 0.1 or 0.2 m, the first of these that passes the check. If none passes, the move is
/// straight.
/// Throws EntryError for "home" (an unknown posture or joint, values beyond a joint's limits, a
/// robot with loops or a floating base) and for "home.duration" (a joint would exceed its velocity
/// limit).
std::optional<HomeMove> home_move(const HomeSpec& home, const Robot& robot,
                                  const Eigen::VectorXd& q_start, const SceneSpec& scene);

/// Checks the move in steps of 0.02 rad (m), measured at the joint that moves most. The tool and
/// the arm, as ReachWalk models them, must stay outside the surface. Holding torques must stay
/// below ReachOptions::torque_share of their limits. ReachReport::s is always 0. `scene` must be
/// fixed in the world.
ReachReport check_home_move(const HomeMove& move, const Model& model, const SceneSpec& scene,
                            const ReachOptions& options);

/// Returns an upper bound of the time from the start of a run to the start of its task [s]; 0
/// without a move from home.
double time_from_home(const std::optional<HomeMove>& move);

}  // namespace burnish::pressing
