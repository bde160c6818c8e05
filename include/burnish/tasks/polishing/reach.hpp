// Checks before a run: whether the arm can do a task, and from which starting posture.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/polishing/stages.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::polishing {

using burnish::FoundPosture;
using burnish::PostureOptions;
using burnish::pressing_axis;
using burnish::ReachOptions;
using burnish::ReachProblem;
using burnish::ReachReport;
using burnish::searched_posture;

/// Checks by statics whether the arm can do a task. The check walks from the start to the surface
/// and along the whole path. At every point it computes a posture by damped least squares from the
/// previous posture. The tool's position has priority over the orientation and the posture, which
/// should stay as at the start. Three conditions are checked at every point:
/// - Joints stay within their limits, with the margin ReachOptions::joint_margin.
/// - The holding torques tau = b(q, 0) - J^T f n are at most the fraction
///   ReachOptions::torque_share of the effort limits. n is the normal of the surface and f the
///   force. All points are checked with f = 0. Points on the path are also checked with the largest
///   target force.
/// - The arm stays outside the surface and the material behind it. The material is as wide as the
///   surface (Task::extent) and infinitely deep.
///
/// For the condition on the arm and the surface, straight segments of radius `link_radius`
/// represent the arm. The segments connect the origins of the joints that carry the tool. Joints
/// attached to the world and the tool's own link are left out. The last joint is left out if the
/// tip lies at the origin of the last joint.
///
/// The check uses the nominal robot and surface. It does not include motion, shapes of links, or
/// collisions of the robot with itself and with other objects. Returns an empty report if the robot
/// carries the surface itself (Task::surface_frame). Throws Error for an invalid path.
ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options = {});

/// Checks the joint-space move from Task::home to the start of the task, in steps of 0.02 rad. The
/// tool and the arm must stay outside the surface; the arm is modelled as in check_reach(). Holding
/// torques must be at most ReachOptions::torque_share times the effort limits.
///
/// If there is a problem, and a move from another named posture avoids it, the text of the report
/// suggests the other posture. Returns an empty report if the task states no home.
ReachReport check_home(const Task& task, const Setting& setting, const ReachOptions& options = {});

/// Named posture from which the joints can move straight to the start of a task without a problem.
/// @described polishing @result
struct FreeHome {
  std::string posture;    ///< Name of the posture in the robot's settings
  double duration = 0.0;  ///< Duration of the move [s]
};
/// Returns the named postures from which check_home() finds no problem. Postures with a shorter
/// motion to the task's start come first. The task's starting posture is left out. The list is
/// empty if the robot stands on its feet or carries the surface; such tasks cannot have a home.
std::vector<FreeHome> free_homes(const Task& task, const Setting& setting,
                                 const ReachOptions& options = {});

/// Returns options for find_posture() with the limits of Task::search.
PostureOptions posture_options(const Task& task);

/// Returns the unit vector along which the tool presses, in the tool's frame. If Task::tool_axis
/// has a value, the result is Task::tool_axis. Otherwise the result depends on the frame of the
/// tool:
/// - If the robot's settings add the frame: its axis z or -z.
/// - If the frame is a link or joint of the robot's description: the axis of the last joint that
///   carries the tool. If the tool lies beside this axis: the line from that joint to the tool.
///
/// The sign is chosen so that the vector points away from the robot. Three offsets are tried: from
/// the last joint to the tool, from the second-last joint to the last joint, and from the last
/// joint to the centre of mass of the last link. The first offset with a component of at least 1 mm
/// along the vector determines the sign.
Eigen::Vector3d pressing_direction(const Task& task, const Model& model);

/// Searches for a posture of `robot` from which the task can be done. The same input gives the same
/// posture.
///
/// Damped least squares runs from many start points, with three sets of weights each. The method
/// aligns the pressing axis with the direction into the surface and moves joints towards the middle
/// of their ranges. If the task states a point of the surface, the method also moves the tool to
/// the distance `clearance` above the point.
///
/// A result is a candidate if it meets the limits in `options`. Candidates are dropped if
/// check_reach() or the check of the move from home finds a problem. The function returns the
/// candidate with the lowest
///   score = tilt + (largest ratio of holding torque to effort limit along the path)
///         + 0.1 rad / (smallest distance to a joint limit along the path)
///         + 0.1 m / (smallest singular value of the tool's translational Jacobian at the start).
///
/// Throws Error if no candidate is left. The message states the limit that the best result
/// violates, or the problem of the best candidate. The message also names the pressing axis, and
/// states whether a posture exists for the opposite axis.
FoundPosture find_posture(const Task& task, const Robot& robot, const PostureOptions& options = {});

}  // namespace burnish::polishing
