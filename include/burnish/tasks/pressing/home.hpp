// Home: where a run begins if not at the start of its task, and the joint-space move to the start.
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
/// @described pressing
struct HomeSpec {
  /// of the robot, that a run begins at; none: the run begins at its task's start @code posture of
  /// the robot that a run begins at; empty: the run begins at its task's start @word none
  std::string posture = {};
  /// {joint: rad (m), ...} in place of the posture's; without one the others are as at the start
  /// @code rad (m) by joint, in place of the posture's; without a posture the others are as at the
  /// start
  std::map<std::string, double> joints = {};
  /// of the joints' velocity limits, highest speed on the way, 0.01 to 1
  double speed_ratio = 0.3;
  /// [s]; auto: the shortest that keeps speed_ratio and 0.8 of the effort limits, at least 1 s, > 0
  /// @code s; none: the shortest that keeps speed_ratio and 0.8 of the effort limits, at least 1 s
  /// @word auto
  std::optional<double> duration = {};

  bool is_stated() const { return !posture.empty() || !joints.empty(); }
};

/// Move in joint space from where a run begins to its task's start, straight from corner to corner
/// and at rest at each.
/// @described pressing
/// From q_i to q_i+1 it is q(t) = q_i (+) s(t / duration_i) (q_i+1 (-) q_i), s(x) = 10 x^3 - 15 x^4
/// + 6 x^5. Continuous joints turn in the direction of the smaller angle.
struct HomeMove {
  /// nq each: home, the start lifted off the surface where the straight way would touch it, the
  /// start
  std::vector<Eigen::VectorXd> corners = {};
  std::vector<double> durations = {};  ///< [s], from each corner to the next
  double settle = 0.5;                 ///< [s] at rest after it, until the task begins
  std::string farthest_joint = {};     ///< entry of v that moves most
  double farthest = 0.0;               ///< rad (m), how far

  double duration() const;  ///< time from home to the start, without `settle` [s]
};

/// Controller that tracks the move and then hands over to `then`, which must outlive it. The
/// tracking law is computed torque with integral action, within the effort limits:
/// tau = M (a + kp e + kd de/dt + ki * integral of e) + b, with three poles at 20 rad/s.
/// It hands over duration() + `settle` after its first tick, or up to 2 s later, as soon as all
/// joints are within 0.01 rad (m) of the start; in any case after these 2 s. Until then
/// Command::phase is Phase::Home, and no faults are detected. For a
/// measurement that is not a valid state, the previous command is repeated and Command::status
/// gives the reason.
/// `tool`: frame whose planned position is Command::p_target_world; `normal_world`: normal of the
/// surface. Throws Error for an unknown frame, fewer than two corners, a wrong number of durations
/// and configurations of the wrong size.
std::unique_ptr<Controller> make_home_controller(const Model& model, const HomeMove& move,
                                                 const std::string& tool,
                                                 const Eigen::Vector3d& normal_world,
                                                 Controller& then);

}  // namespace burnish
