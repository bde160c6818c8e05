// A starting posture for a surface of any orientation, found rather than given.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// What is pressed where: the entries of that name that tasks have.
struct PressingPlace {
  std::string tool;
  std::optional<Eigen::Vector3d> tool_axis;
  Eigen::Vector3d normal_world;                ///< any length
  std::optional<Eigen::Vector3d> point_world;  ///< m, of the surface; none: anywhere
  double tip_radius, clearance;                ///< m
  double force;                                ///< N
};

/// With the limits that a task has for it.
template <class Task>
PostureOptions posture_options_of(const Task& task) {
  return {.tilt_limit = task.search.tilt,
          .joint_margin = task.search.joint_margin,
          .body_distance = task.search.body_distance};
}

/// Of a task from a starting posture.
using CheckReach = std::function<ReachReport(const Eigen::VectorXd& q_start)>;

/// A posture from which the task can be done, the same one for the same input. Damped least squares
/// from many starts, those that are `known` first, each with three weights, turns the pressing axis
/// against the normal, draws joints to the middle of their ranges and, where the surface has a
/// point, puts the tool `clearance` above it. Of the ends that meet the limits of the options and
/// in whose way check_reach finds nothing, it is the one with the lowest
///   score = tilt + (largest share of a torque limit that statics take along the path)
///         + 0.1 rad / (smallest distance to a joint limit along the path)
///         + 0.1 m / (smallest singular value of the tool's translational Jacobian at the start).
/// The tool presses along tool_direction(). Throws Error with one sentence if there is none: which
/// condition the nearest posture fails, or what is in the best one's way; which tool.axis was
/// taken, and whether the opposite one has a posture; and looser limits with which one is found.
FoundPosture search_posture(const PressingPlace& place, const Model& model,
                            const std::vector<Eigen::VectorXd>& known,
                            const PostureOptions& options, const CheckReach& check_reach);

}  // namespace burnish::pressing
