// Costs and constraints for the stages of pressing tasks.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "burnish/ocp/problem.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish::pressing {

/// Returns the quintic smooth step from 0 to 1 over s = 0 to 1; constant outside.
inline double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}
/// Returns the derivative of smooth() with respect to s.
inline double smooth_rate(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return 30.0 * s * s * (1.0 - s) * (1.0 - s);
}

/// Returns the joint torques (nv) that hold the robot in `q` against gravity.
Eigen::VectorXd rest_torque(const Model& model, const Eigen::VectorXd& q);

/// Returns constraints on positions and velocities of joints with limits. Throws EntryError if
/// `q_start` violates a limit: plans would then ignore all costs until the limit is met.
std::vector<Constraint> joint_limits(const Model& model, const PlanLimits& limits,
                                     const Eigen::VectorXd& q_start);
/// Returns constraints on the controls; empty without effort limits.
std::vector<Constraint> torque_limits(const Model& model, const PlanLimits& limits);
/// Returns constraints on torque rates; empty without effort limits. The rates are computed from a
/// torque model with the cut-off frequency `cutoff` [rad/s]. Throws EntryError for rate limits
/// without a cut-off frequency.
std::vector<Constraint> torque_rate_limits(const Model& model, const PlanLimits& limits,
                                           double cutoff);
/// Returns the largest torques that the controller may send (nv) [Nm (N)].
Eigen::VectorXd torque_limit(const Model& model, const PlanLimits& limits);
/// Returns a constraint that keeps the normal force of the contact "surface" in a band around
/// `force` [N], a signal over the time of the schedule. Without a band, the constraint only forbids
/// pulling. `min_force`: smallest value of `force` while pressing [N]. `scale`: scale of the
/// constraint [N].
Constraint force_limit(const Signal& force, double min_force, double scale,
                       const PlanLimits& limits);
/// Returns a cost on the deviation of torques from `rest`.
CostTerm torque_cost(const Eigen::VectorXd& rest, double weight);
/// Returns a cost on the deviation of the tool from `position`, relative to the origin of the
/// reference frame [m]. `normal_weight`: factor on the weight along the normal, the third axis of
/// the reference frame.
CostTerm place_cost(const std::string& name, const std::string& tool, const Signal& position,
                    const Reference& on_surface, double weight, double normal_weight);
/// Returns a cost on the deviation of the tool's normal speed from the third entry of the twist
/// `target`. The speed is relative to the world; the normal is the reference frame's third axis.
CostTerm normal_speed_cost(const std::string& name, const std::string& tool, const Signal& target,
                           const Reference& on_surface, double weight);
/// Returns a twist (6) whose only nonzero entry is the linear velocity `speed` along z [m/s].
Eigen::VectorXd normal_twist(double speed);
/// Returns a cost on the deviation of the normal force of the contact "surface" from `force` [N].
CostTerm force_cost(const Signal& force, double weight);

}  // namespace burnish::pressing
