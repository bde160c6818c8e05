// Static checks before a run: whether an arm can press where a task requires it, and from which
// posture.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

namespace burnish {

/// Resolution and required margins of check_reach().
/// @described pressing
struct ReachOptions {
  double spacing = 5e-3;       ///< Distance between two checked points [m]
  double tolerance = 1e-4;     ///< Largest position error of the tool [m]
  double joint_margin = 0.02;  ///< Smallest distance of joints from their limits [rad (m)]
  /// Largest static torque, as a fraction of the effort limits
  /// @more The rest of the torque is left for motion and feedback.
  double torque_share = 0.8;
  /// Radius of the segments that represent the arm in the collision check [m]
  /// @more See check_reach().
  double link_radius = 0.03;
};

/// Kind of problem that check_reach() finds.
/// @described pressing
enum class ReachProblem {
  None,
  Position,   ///< no posture brings the tool to the point, even without joint limits
  Joint,      ///< the tool reaches the point only with a joint beyond its limit
  Torque,     ///< holding the tool at the point needs more torque than a joint may use
  Collision,  ///< the arm or the tool would touch the surface where it must not
};

/// Result of a reach check: the first problem on the path of the tool, and the smallest margins
/// over all checked points.
/// @described pressing
struct ReachReport {
  ReachProblem problem = ReachProblem::None;  ///< Kind of the first problem
  /// Problem in one sentence, with place, joint, value and allowed value; empty without a problem
  std::string text;
  /// Distance along the path from its start to the problem [m]; negative if the problem comes
  /// before the path
  /// @more The path of a task that holds a point has length zero.
  double s = 0.0;
  /// Position of the tool at the problem, in the world [m]
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  /// Joint that causes the problem
  /// @more The name is empty for the kind `Position`, and if the tool's own link would touch the
  /// surface.
  std::string joint;
  /// Value that violates `limit`
  /// @more The value depends on the kind of the problem. `Position`: position error of the tool, in
  /// m. `Joint`: position of the joint, in rad (m). `Torque`: torque of the joint, in Nm (N).
  /// `Collision`: distance from the surface, in m.
  double value = 0.0;
  double limit = 0.0;  ///< Allowed value, in the unit of `value`

  int points = 0;  ///< Number of checked points
  /// Length of the path [m]
  /// @more For a path that repeats itself, this is the length of one turn.
  double path_length = 0.0;
  double joint_margin = 0.0;   ///< Smallest distance of a joint from its limit [rad (m)]
  std::string tightest_joint;  ///< Joint with the smallest distance from its limit
  double torque_share = 0.0;   ///< Largest static torque, as a fraction of the joint's effort limit
  /// Joint with the largest static torque, as a fraction of its effort limit
  std::string tightest_torque;
  /// Standard deviation of the estimated force per standard deviation of joint torques [1/m]
  /// @more The force along the normal is estimated from joint torques with independent errors. The
  /// value, in N per Nm, is the largest of all points on the surface. It matters for tasks without
  /// a force sensor.
  double force_per_torque = 0.0;
  std::string force_joint;  ///< Joint that contributes most to force_per_torque
  /// Smallest distance between the surface and the arm, except the tool's link [m]
  /// @more The distance is infinite if only the tool's link moves.
  double clearance = 0.0;
  std::string tightest_clearance;  ///< Joint of the arm that comes closest to the surface

  bool ok() const { return problem == ReachProblem::None; }
};

/// Conditions on a starting posture that find_posture() searches for.
/// @described pressing
struct PostureLimits {
  double tilt = 1.0;  ///< Largest angle between tool axis and surface normal [rad], >= 0
  /// Smallest distance of joints from their limits at the start [rad], >= 0
  /// @more The unit is m for prismatic joints.
  double joint_margin = 0.15;
  /// Smallest distance of the last link from the robot's body [m], >= 0
  /// @more Parts that are close to each other along the arm may have a smaller distance.
  double body_distance = 0.25;
};

/// Word that a task states in place of a posture's name, so that find_posture() finds a posture.
inline constexpr const char* searched_posture = "search";

/// Options of find_posture(): start points of the search and conditions on its result.
/// @described pressing
struct PostureOptions {
  /// Number of random start points
  /// @more The robot's named postures and the middle of the joint limits are start points too.
  int random_starts = 48;
  std::uint64_t seed = 0;  ///< Seed of the random start points
  /// Largest angle between the tool's pressing direction and the direction into the surface [rad]
  double tilt_limit = 1.0;
  double joint_margin = 0.15;  ///< Smallest distance of joints from limits at the start [rad (m)]
  /// Smallest distance between the last link and the robot's body [m]
  /// @more Three points between the last joint and the tool represent the last link. The body is
  /// represented by the lines between the earlier joints of the arm, and by the origins of all
  /// links that the last two joints do not carry. Between two places on the arm, a distance of
  /// `body_distance_fraction` times the arm's length between them is enough, as in a compact wrist.
  /// The test is coarse and does not replace a collision check.
  double body_distance = 0.25;
  /// Upper limit of body_distance for two places on the arm, as a fraction of the arm's length
  /// between them
  /// @more With 0.55, two links of equal length may enclose an angle as small as 67 degrees.
  double body_distance_fraction = 0.55;
  int checked = 48;  ///< Number of candidates whose whole path is checked, best first
  /// Options of the reach check
  ReachOptions reach = {};
};

/// Posture that find_posture() found.
/// @described pressing @result
struct FoundPosture {
  Eigen::VectorXd q;   ///< Configuration, nq
  double score = 0.0;  ///< Score of the posture; lower is better
  /// Angle between the tool's pressing direction and the direction into the surface [rad]
  double tilt = 0.0;
  ReachReport reach;   ///< Reach check of the task from this posture
  int candidates = 0;  ///< Number of postures that met all conditions at the start
};

/// Returns the direction of the -z axis of a tool in the world. `tool_placement` is the placement
/// of the tool in the world. If -z points from the robot to the tip, the tool presses in this
/// direction; see polishing::pressing_direction().
Eigen::Vector3d pressing_axis(const Eigen::Isometry3d& tool_placement);

}  // namespace burnish
