// Costs that stages of tasks which press are made of.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "burnish/ocp/problem.hpp"

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

/// Barriers at the joints' velocity limits and 0.05 rad (m) inside their position limits, where
/// they have some.
std::vector<CostTerm> joint_limit_costs(const Model& model, double velocity, double position);
/// Torques to `rest`, and a barrier at the effort limits, where there are some.
std::vector<CostTerm> torque_costs(const Model& model, const Eigen::VectorXd& rest, double torque,
                                   double limits);
/// Of the tool's position, m in the world, along the surface and with a weight of its own along the
/// normal, the third of the axes.
CostTerm place_cost(const std::string& name, const std::string& tool, const Signal& position,
                    const Eigen::Matrix3d& surface_axes, double weight, double normal_weight);
/// Of the tool's speed along the normal; `target`: the twist, of which that entry counts.
CostTerm normal_speed_cost(const std::string& name, const std::string& tool, const Signal& target,
                           const Eigen::Matrix3d& surface_axes, double weight);
Eigen::VectorXd normal_twist(double speed);  ///< 6, m/s
/// Of the force along the normal of the contact "surface".
CostTerm force_cost(const Signal& force, double weight);

}  // namespace burnish::pressing
