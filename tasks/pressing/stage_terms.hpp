// Costs and constraints that stages of tasks which press are made of.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "burnish/ocp/problem.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"

namespace burnish::pressing {

/// From 0 to 1 while s goes there, at rest before and behind.
inline double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}
/// Its derivative.
inline double smooth_rate(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return 30.0 * s * s * (1.0 - s) * (1.0 - s);
}

/// nv, that holds q against gravity.
Eigen::VectorXd rest_torque(const Model& model, const Eigen::VectorXd& q);

/// Range and speed of the joints, where they have limits. Throws EntryError for a start outside the
/// range: a plan would do all to get inside.
std::vector<Constraint> joint_limits(const Model& model, const PlanLimits& limits,
                                     const Eigen::VectorXd& q_start);
/// Of the controls, where there are effort limits.
std::vector<Constraint> torque_limits(const Model& model, const PlanLimits& limits);
/// Rates of the torques of a model with that cut-off [rad/s], where there are effort limits. Throws
/// EntryError for limits without a cut-off.
std::vector<Constraint> torque_rate_limits(const Model& model, const PlanLimits& limits,
                                           double cutoff);
/// nv, Nm (N): what may be sent.
Eigen::VectorXd torque_limit(const Model& model, const PlanLimits& limits);
/// Of the force along the normal of the contact "surface": a band about `force`, N over the
/// schedule's time, whose smallest value while pressing is `least`, or without a band no pull.
/// `scale`: N that count as much.
Constraint force_limit(const Signal& force, double least, double scale, const PlanLimits& limits);
/// Torques to `rest`.
CostTerm torque_cost(const Eigen::VectorXd& rest, double weight);
/// Of the tool's position, m from the reference's origin, along the surface and with a weight of
/// its own along the normal, the third of the reference's axes.
CostTerm place_cost(const std::string& name, const std::string& tool, const Signal& position,
                    const Reference& on_surface, double weight, double normal_weight);
/// Of the tool's speed in the world along the normal, the third of the reference's axes, at the
/// tool; `target`: the twist, of which that entry counts.
CostTerm normal_speed_cost(const std::string& name, const std::string& tool, const Signal& target,
                           const Reference& on_surface, double weight);
Eigen::VectorXd normal_twist(double speed);  ///< 6, m/s
/// Of the force along the normal of the contact "surface".
CostTerm force_cost(const Signal& force, double weight);

}  // namespace burnish::pressing
