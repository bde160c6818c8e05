// A run that begins away from its task's start, and the move in joint space from there.
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/mpc/controller.hpp"

namespace burnish {

/// Posture at which a run begins. From there the robot moves to the start of its task.
struct HomeSpec {
  /// posture of the robot that a run begins at; empty: the run begins at its task's start
  std::string posture = {};
  /// rad (m) by joint, in place of the posture's; without a posture the others are as at the start
  std::map<std::string, double> joints = {};
  double speed_ratio = 0.3;  ///< of the joints' velocity limits, highest speed on the way
  /// s; none: the shortest that keeps speed_ratio and 0.8 of the effort limits, at least 1 s
  std::optional<double> duration = {};

  bool is_stated() const { return !posture.empty() || !joints.empty(); }
};

/// Move in joint space, straight from corner to corner and at rest at each: from q_i to q_i+1 it is
/// q(t) = q_i (+) s(t / duration_i) (q_i+1 (-) q_i) with s(x) = 10 x^3 - 15 x^4 + 6 x^5. Continuous
/// joints take the shorter way around.
struct HomeMove {
  /// nq each: home, the start lifted off the surface where the straight way would touch it, the
  /// start
  std::vector<Eigen::VectorXd> corners = {};
  std::vector<double> durations = {};  ///< s, from each corner to the next
  double settle = 0.5;                 ///< s at rest after it, until the task begins
  std::string farthest_joint = {};     ///< entry of v that moves most
  double farthest = 0.0;               ///< rad (m), how far

  double duration() const;  ///< s, without `settle`
};

/// Controller that makes the move and then hands over to `then`, which must outlive it. The joints
/// are held by tau = M (a + kp e + kd de/dt + ki * integral of e) + b with poles at 20 rad/s,
/// within the effort limits. The move ends `settle` after its duration, or up to 2 s later, when
/// all joints are within 0.01 rad (m) of the start. Its Command::phase is Phase::Home. A
/// measurement that is not a state gives the command before again with the status that says so.
/// `tool`: frame whose position is Command::p_target_world; `normal_world`: of the surface. Throws
/// Error for an unknown frame, less than two corners and configurations of the wrong size.
std::unique_ptr<Controller> make_home_controller(const Model& model, const HomeMove& move,
                                                 const std::string& tool,
                                                 const Eigen::Vector3d& normal_world,
                                                 Controller& then);

}  // namespace burnish
