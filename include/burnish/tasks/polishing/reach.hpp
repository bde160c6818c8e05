// Whether the arm can do a task at all, found out before anything moves.
#pragma once

#include <string>

#include "burnish/tasks/polishing/stages.hpp"

namespace burnish::polishing {

struct ReachOptions {
  double spacing = 5e-3;       ///< m between two points that are looked at
  double tolerance = 1e-4;     ///< m that the tool may be off
  double joint_margin = 0.02;  ///< rad (m) that joints keep from their limits
  /// Of the effort limits that statics may take: the rest is for motion and feedback.
  double torque_share = 0.8;
  double link_radius = 0.03;  ///< m, how thick links are taken to be; see check_reach()
};

/// What is in the way.
enum class ReachProblem {
  None,
  Position,   ///< no posture puts the tool there, whatever the limits
  Joint,      ///< the only postures found are beyond a joint's limit
  Torque,     ///< holding the tool there takes more than a joint's effort limit
  Collision,  ///< the arm itself would touch the surface
};

/// The first thing in the way, and how much room there is elsewhere.
struct ReachReport {
  ReachProblem problem = ReachProblem::None;
  /// One sentence: where, which joint, what came and what is allowed; empty without a problem.
  std::string text;
  /// m along the path in contact where the problem is; negative: so far before the path's start,
  /// on the way to it.
  double s = 0.0;
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();  ///< of the tool there, m
  std::string joint;                                  ///< empty for Position
  /// m that the tool is off, rad (m) of the joint, Nm (N), m of the joint's origin from the
  /// surface.
  double value = 0.0;
  double limit = 0.0;  ///< what is allowed, in the same unit

  int points = 0;             ///< that were looked at
  double path_length = 0.0;   ///< m, once around where the path repeats itself
  double joint_margin = 0.0;  ///< rad (m), smallest of all points
  std::string tightest_joint;
  double torque_share = 0.0;  ///< of the effort limit, largest of all points
  std::string tightest_torque;
  /// m between the surface and the arm without its tool link, smallest of all points; infinite
  /// where nothing but the tool link moves.
  double clearance = 0.0;
  std::string tightest_clearance;  ///< joint there

  bool ok() const { return problem == ReachProblem::None; }
};

/// Walks from the start to the surface and along the whole path. At every point: a posture by
/// damped least squares from the one before, the tool's position first, then its orientation at
/// the start and the starting posture; joint limits; the torques that hold the robot still there
/// with the task's force (on the path) and without, tau = b(q, 0) - J^T f n, against the effort
/// limits; and the arm outside the surface and the material behind it, which is as wide as the
/// surface (Task::extent) and as deep as can be. For that the arm is a skeleton of straight
/// segments, `link_radius` thick, between the origins of the joints that carry the tool. Joints
/// fixed to the world and the tool link, which is to come near, do not count, nor does a last joint
/// whose origin the tip is at.
///
/// It knows the nominal robot and surface, no motion, no shapes of links, and no collisions of the
/// robot with itself or with anything but the surface. Throws Error for a path that is none.
ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options = {});

}  // namespace burnish::polishing
