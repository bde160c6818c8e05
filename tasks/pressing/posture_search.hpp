// Search for a starting posture at a surface of any orientation.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::pressing {

/// Tool, surface and force of a task for the posture search. Members have the names of the task's
/// entries.
struct PressingPlace {
  std::string tool;
  std::optional<Eigen::Vector3d> tool_axis;
  Eigen::Vector3d normal_world;  ///< Normal of the surface, of any length.
  /// Point of the surface that the tool starts above [m]; none: anywhere.
  std::optional<Eigen::Vector3d> point_world;
  double tip_radius, clearance;  ///< Radius of the tip, height of the tip above the surface [m].
  double force;                  ///< Force along the normal [N].
};

/// Returns the limits of the posture search, as stated in a task.
template <class Task>
PostureOptions posture_options_of(const Task& task) {
  return {.tilt_limit = task.search.tilt,
          .joint_margin = task.search.joint_margin,
          .body_distance = task.search.body_distance};
}

/// Function that checks the reach of a task from a starting posture.
using CheckReach = std::function<ReachReport(const Eigen::VectorXd& q_start)>;

/// Returns a posture from which the task can be done. The result depends only on the arguments.
/// Damped least squares starts from the postures `known`, from the middle of the joint ranges, and
/// from random postures, three times each with different weights. It turns the pressing axis,
/// see tool_direction(), against the normal, and moves joints towards the middle of their ranges.
/// If the task states a point of the surface, the tool is placed `clearance` above the point.
/// Among the results within the limits of `options` that pass `check_reach`, the function returns
/// the one with the lowest score:
///   score = tilt + (largest static torque along the path, as a fraction of the limit)
///         + 0.1 rad / (smallest distance to a joint limit along the path)
///         + 0.1 m / (smallest singular value of the tool's translational Jacobian at the start).
/// Throws Error if there is no posture. The message names the condition that the best candidate
/// violates, or its problem along the path. It also states the pressing axis tool.axis, whether the
/// opposite axis has a posture, and which looser limits permit one.
FoundPosture search_posture(const PressingPlace& place, const Model& model,
                            const std::vector<Eigen::VectorXd>& known,
                            const PostureOptions& options, const CheckReach& check_reach);

}  // namespace burnish::pressing
