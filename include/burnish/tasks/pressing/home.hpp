// Home posture, in which a run can begin, and the joint-space move from home to the start of the
// task.
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

/// Home posture, in which a run begins. The robot moves from home to the start of its task.
/// @described pressing
struct HomeSpec {
  /// Named posture in which the run begins (`none`: the starting posture of the task)
  /// @word none
  std::string posture = {};
  /// Joint positions that differ from the named posture, in rad (m): {joint: position, ...}
  /// @more If no posture is named, all other joints have their positions at the start of the task.
  std::map<std::string, double> joints = {};
  /// Highest joint speed of the move from home, as a fraction of the velocity limits, 0.01 to 1
  double speed_ratio = 0.3;
  /// Duration of the move (automatic: as short as the limits allow, at least 1 s) [s], > 0
  /// @more The limits are speed_ratio times the velocity limits and 0.8 times the effort limits.
  /// @word auto
  std::optional<double> duration = {};

  bool is_stated() const { return !posture.empty() || !joints.empty(); }
};

/// Move in joint space from home, where a run begins, to the start of the task. The move leads
/// through configurations called corners. The joints move straight from each corner to the next and
/// stop at each corner.
/// @described pressing
/// From corner q_i to corner q_i+1 the move is q(t) = q_i (+) s(t / duration_i) (q_i+1 (-) q_i),
/// with s(x) = 10 x^3 - 15 x^4 + 6 x^5. (+) and (-) add and subtract on the configuration space.
/// Continuous joints turn in the direction of the smaller angle.
struct HomeMove {
  /// Configurations at the corners, nq each: home first, the start of the task last
  /// @more If a straight move would touch the surface, a corner in between lifts the tool off the
  /// surface.
  std::vector<Eigen::VectorXd> corners = {};
  std::vector<double> durations = {};  ///< Durations of the moves from each corner to the next [s]
  double settle = 0.5;                 ///< Time at rest between the move and the task [s]
  std::string farthest_joint = {};     ///< Name of the entry of v that moves farthest
  double farthest = 0.0;               ///< Distance that the joint `farthest_joint` moves [rad (m)]

  double duration() const;  ///< Returns the duration of the whole move, without `settle` [s].
};

/// Creates a controller that tracks `move` and then hands over to the controller `then`. The
/// controller `then` must outlive the new controller. The new controller uses computed torque with
/// integral action, within the effort limits: tau = M (a + kp e + kd de/dt + ki * integral of e) +
/// b, with three poles at 20 rad/s. e is the position error of the joints, a the acceleration of
/// the move, M the mass matrix and b the bias torques.
///
/// The handover is due at the time HomeMove::duration() + HomeMove::settle after the first tick. If
/// a joint is then farther than 0.01 rad (m) from the end of the move, the handover waits until all
/// joints are within this distance, at most 2 s. Before the handover Command::phase is Phase::Home,
/// and no faults are detected. If a measurement is invalid, the previous command is repeated, and
/// Command::status gives the reason.
///
/// `tool` is the frame whose planned position is ToolCommand::p_target_world, and `normal_world`
/// the normal of the surface. Throws Error for an unknown frame, fewer than two corners, a wrong
/// number of durations, or configurations of the wrong size.
std::unique_ptr<Controller> make_home_controller(const Model& model, const HomeMove& move,
                                                 const std::string& tool,
                                                 const Eigen::Vector3d& normal_world,
                                                 Controller& then);

}  // namespace burnish
