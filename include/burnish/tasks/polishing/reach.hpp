// Whether the arm can do a task at all, and from which posture, found out before anything moves.
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

/// Walks along the move from where a run begins (Task::home) to its start, by steps of 0.02 rad:
/// the tool and the arm, as check_reach() has it, stay outside the surface, and torques that hold
/// the robot still stay within their share of the limits. The text of a problem names postures of
/// the robot from which the way is free. Returns an empty report where no home is stated.
ReachReport check_home(const Task& task, const Setting& setting, const ReachOptions& options = {});

/// Posture of a robot from which its joints can move straight to a task's start.
/// @described polishing @result
struct FreeHome {
  std::string posture;    ///< of the robot's settings
  double duration = 0.0;  ///< [s], of the move
};
/// Returns the robot's postures, the start itself left out, from which check_home() finds nothing
/// in the way; the nearest first. Empty where the task can have no home.
std::vector<FreeHome> free_homes(const Task& task, const Setting& setting,
                                 const ReachOptions& options = {});

/// With the limits that a task has for it.
PostureOptions posture_options(const Task& task);

/// Direction that a task's tool presses in, in its own frame, of length one: what the task says. Of
/// a frame that the settings of the robot add it is z or -z. Of a link or a joint of the
/// description it is the axis of the last joint that carries it, or the line from that joint to the
/// tool where the tool lies beside the axis rather than on it. The sign points away from the robot,
/// by the first of these that is 1 mm or more along the axis: the tool's offset from the last
/// joint, the last joint's offset from the joint before, the centre of mass of the last link.
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
/// what is in the best one's way; which tool.axis was taken, and whether the opposite one has one.
FoundPosture find_posture(const Task& task, const Robot& robot, const PostureOptions& options = {});

}  // namespace burnish::polishing
