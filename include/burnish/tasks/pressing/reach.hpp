// Whether an arm can press where a task wants it to, and from which posture, found out before
// anything moves.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

namespace burnish {

/// How check_reach() looks, and how much room it asks for.
/// @described pressing
struct ReachOptions {
  double spacing = 5e-3;       ///< [m] between two points that are looked at
  double tolerance = 1e-4;     ///< [m] that the tool may be off
  double joint_margin = 0.02;  ///< [rad (m)] that joints keep from their limits
  /// Of the effort limits that statics may take: the rest is for motion and feedback.
  double torque_share = 0.8;
  double link_radius = 0.03;  ///< [m], how thick links are taken to be; see check_reach()
};

/// What is in the way.
/// @described pressing
enum class ReachProblem {
  None,
  Position,   ///< no posture puts the tool there, whatever the limits
  Joint,      ///< the only postures found are beyond a joint's limit
  Torque,     ///< holding the tool there takes more than a joint's effort limit
  Collision,  ///< the arm itself would touch the surface
};

/// The first thing in the way of a task, and how much room there is elsewhere.
/// @described pressing
struct ReachReport {
  ReachProblem problem = ReachProblem::None;
  /// One sentence: where, which joint, what came and what is allowed; empty without a problem.
  std::string text;
  /// [m] along the path in contact where the problem is; negative: so far before the path's start,
  /// on the way to it. A point that is held is a path without length.
  double s = 0.0;
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< of the tool there, m
  std::string joint;                                  ///< empty for Position
  /// [m] that the tool is off, rad (m) of the joint, Nm (N), m of the joint's origin from the
  /// surface.
  double value = 0.0;
  double limit = 0.0;  ///< what is allowed, in the same unit

  int points = 0;             ///< that were looked at
  double path_length = 0.0;   ///< [m], once around where the path repeats itself
  double joint_margin = 0.0;  ///< [rad (m)], smallest of all points
  std::string tightest_joint;
  double torque_share = 0.0;  ///< of the effort limit, largest of all points
  std::string tightest_torque;
  /// [1/m]: N along the normal per Nm that every joint's torque is wrong by, independent of each
  /// other, as told without a force sensor; largest of all points on the surface
  double force_per_torque = 0.0;
  std::string force_joint;  ///< the joint that has most part in it there
  /// [m] between the surface and the arm without its tool link, smallest of all points; infinite
  /// where nothing but the tool link moves.
  double clearance = 0.0;
  std::string tightest_clearance;  ///< joint there

  bool ok() const { return problem == ReachProblem::None; }
};

/// What a posture that is searched has to keep to; see find_posture().
/// @described pressing
struct PostureLimits {
  double tilt = 1.0;  ///< [rad] between the tool's axis and the normal, >= 0
  /// [rad] that joints keep from their limits at the start, >= 0 @more m of prismatic joints
  double joint_margin = 0.15;
  /// [m] between the last link and the robot's body; less where the arm is short, >= 0
  double body_distance = 0.25;
};

/// In a task, in place of a posture's name: let find_posture() find one.
inline constexpr const char* searched_posture = "search";

/// How find_posture() searches.
/// @described pressing
struct PostureOptions {
  int random_starts = 48;      ///< besides the robot's named postures and the middle of the limits
  std::uint64_t seed = 0;      ///< of those
  double tilt_limit = 1.0;     ///< [rad] between the pressing axis and the normal's opposite
  double joint_margin = 0.15;  ///< [rad (m)] that joints keep from their limits at the start
  /// [m] between the last link, for which stand three points on the line from its joint to the
  /// tool, and the robot's body, for which stand the lines between the joints before that one and
  /// the origins of all links that neither the last two joints carry nor what hangs on them. Of
  /// parts of the arm that are near each other along it, as in a compact wrist, no more is wanted
  /// than `bend` times the arm's length between them. Coarse: no collision check.
  double body_distance = 0.25;
  double bend = 0.55;  ///< see body_distance; of two equal links it lets 67 degrees between them
  int checked = 48;    ///< best candidates whose whole path is looked at
  ReachOptions reach = {};
};

/// What find_posture() found.
/// @described pressing @result
struct FoundPosture {
  Eigen::VectorXd q;   ///< nq
  double score = 0.0;  ///< lower is better
  double tilt = 0.0;   ///< [rad] between the pressing axis and the normal's opposite
  ReachReport reach;   ///< of the task from there
  int candidates = 0;  ///< postures that met all conditions at the start
};

/// The direction of the -z of a tool at a placement, which it presses in where that points from the
/// robot to the tip; see polishing::pressing_direction().
Eigen::Vector3d pressing_axis(const Eigen::Isometry3d& tool_placement);

}  // namespace burnish
