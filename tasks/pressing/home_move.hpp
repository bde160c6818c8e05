// The move from where a run begins to its task's start: made from what a task states, and checked.
#pragma once

#include <optional>

#include "burnish/robots/robot.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// Way and its first two derivatives by x, from rest to rest over x = 0 to 1.
struct Quintic {
  double s, ds, ds2;
};
inline Quintic quintic(double x) {
  if (x <= 0.0) return {0.0, 0.0, 0.0};
  if (x >= 1.0) return {1.0, 0.0, 0.0};
  return {x * x * x * (10.0 + x * (6.0 * x - 15.0)), 30.0 * x * x * (1.0 - x) * (1.0 - x),
          60.0 * x * (1.0 - x) * (1.0 - 2.0 * x)};
}
constexpr double quintic_speed = 1.875;  ///< largest ds

/// Returns the move; nullopt where no home is stated. Where check_home_move() finds that the
/// straight way touches the surface, it goes over the start lifted along the normal, by the first
/// of 0.05, 0.1 and 0.2 m that helps. Throws EntryError, "home", for a posture or joint that the
/// robot does not have, values beyond a joint's limits, robots with loops or a floating base;
/// "home.duration" for one in which a joint would exceed its velocity limit.
std::optional<HomeMove> home_move(const HomeSpec& home, const Robot& robot,
                                  const Eigen::VectorXd& q_start, const SceneSpec& scene);

/// Looks at the move by steps of 0.02 rad (m): the tool and the arm (as ReachWalk has it) stay
/// outside the surface, and at rest torques stay within ReachOptions::torque_share. ReachReport::s
/// is 0 throughout. `scene`: fixed in the world.
ReachReport check_home_move(const HomeMove& move, const Model& model, const SceneSpec& scene,
                            const ReachOptions& options);

/// Longest time from the beginning of a run until its task begins [s]; 0 without a move.
double time_from_home(const std::optional<HomeMove>& move);

}  // namespace burnish::pressing
