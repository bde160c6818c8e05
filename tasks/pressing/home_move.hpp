// The move from home to the start of a task: planned from a HomeSpec, and checked.
#pragma once

#include <optional>

#include "burnish/robots/robot.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// Returns the move; nullopt if no home is stated. If check_home_move() finds that the straight
/// path touches the surface, the move passes a corner above the start, lifted along the normal. The
/// lift is the first of 0.05, 0.1 and 0.2 m for which the check passes; if none does, the move is
/// straight. Throws EntryError for "home" (an unknown posture or joint, values beyond a joint's
/// limits, a robot with loops or a floating base) and for "home.duration" (a duration in which a
/// joint would exceed its velocity limit).
std::optional<HomeMove> home_move(const HomeSpec& home, const Robot& robot,
                                  const Eigen::VectorXd& q_start, const SceneSpec& scene);

/// Checks the move in steps of 0.02 rad (m) of the joint that moves most. The tool and the arm, as
/// ReachWalk models them, must stay outside the surface. Holding torques must stay within
/// ReachOptions::torque_share. ReachReport::s is always 0. `scene` must be fixed in the world.
ReachReport check_home_move(const HomeMove& move, const Model& model, const SceneSpec& scene,
                            const ReachOptions& options);

/// Upper bound of the time from the beginning of a run until its task begins [s]; 0 without a move.
double time_from_home(const std::optional<HomeMove>& move);

}  // namespace burnish::pressing
