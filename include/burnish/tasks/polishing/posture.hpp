// A starting posture for a surface of any orientation, found rather than given.
#pragma once

#include <cstdint>

#include "burnish/tasks/polishing/reach.hpp"

namespace burnish::polishing {

/// In a task, in place of a posture's name: let find_posture() find one.
inline constexpr const char* searched_posture = "search";

struct PostureOptions {
  int random_starts = 48;      ///< besides the robot's named postures and the middle of the limits
  std::uint64_t seed = 0;      ///< of those
  double tilt_limit = 1.0;     ///< rad between the pressing axis and the normal's opposite
  double joint_margin = 0.15;  ///< rad (m) that joints keep from their limits at the start
  /// m between the last link, for which stand three points on the line from its joint to the tool,
  /// and the robot's body, for which stand the lines between the joints before that one and the
  /// origins of all links that neither the last two joints carry nor what hangs on them. Of parts
  /// of the arm that are near each other along it, as in a compact wrist, no more is wanted than
  /// `bend` times the arm's length between them. Coarse: no collision check.
  double body_distance = 0.25;
  double bend = 0.55;  ///< see body_distance; of two equal links it lets 67 degrees between them
  int checked = 48;    ///< best candidates whose whole path is looked at
  ReachOptions reach = {};
};

/// With the limits that a task has for it.
PostureOptions posture_options(const Task& task);

struct FoundPosture {
  Eigen::VectorXd q;   ///< nq
  double score = 0.0;  ///< lower is better
  double tilt = 0.0;   ///< rad between the pressing axis and the normal's opposite
  ReachReport reach;   ///< of the task from there
  int candidates = 0;  ///< postures that met all conditions at the start
};

/// The direction of the -z of a tool at a placement, which it presses in where that points from the
/// robot to the tip; see pressing_direction().
Eigen::Vector3d pressing_axis(const Eigen::Isometry3d& tool_placement);

/// The direction, in its own frame, that a task's tool presses in, of length one: what the task
/// says; of a frame that the settings of the robot add z or -z, whichever points away from the
/// joint that carries it (-z if neither does); and of a link or a joint of the description the axis
/// of that joint, away from the robot, or the line from the joint to the tool where the tool lies
/// beside the axis rather than on it.
Eigen::Vector3d pressing_direction(const Task& task, const Model& model);

/// A posture of `robot` from which the task can be done, the same one for the same input. Damped
/// least squares from many starts, each with three weights, turns the pressing axis against the
/// normal, draws joints to the middle of their ranges and, where the surface has a point, puts the
/// tool `clearance` above it. Of the ends that meet the limits of the options and from which
/// check_reach() finds nothing in the way, it is the one with the lowest
///   score = tilt + (largest share of a torque limit that statics take along the path)
///         + 0.1 rad / (smallest distance to a joint limit along the path)
///         + 0.1 m / (smallest singular value of the tool's translational Jacobian at the start).
/// Throws Error with one sentence if there is none: which condition the nearest posture fails, or
/// what is in the best one's way.
FoundPosture find_posture(const Task& task, const Robot& robot, const PostureOptions& options = {});

}  // namespace burnish::polishing
