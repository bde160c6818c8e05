// Position limits of the joints in residual::JointPosition, one row for each limited joint.
#pragma once

#include <cmath>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::ocp {

/// Returns whether the joint is a row of residual::JointPosition{}: it has one coordinate, and this
/// coordinate has a limit.
inline bool has_position_limit(const Model& model, const Joint& joint) {
  return joint.nq == 1 && (std::isfinite(model.q_lower[joint.q_index]) ||
                           std::isfinite(model.q_upper[joint.q_index]));
}

/// Limits of the rows of residual::JointPosition{} [rad or m]. Empty if no joint has a limit.
struct PositionLimits {
  Eigen::VectorXd lower, upper;
};
inline PositionLimits position_limits(const Model& model) {
  std::vector<double> lower, upper;
  for (const Joint& joint : model.joints)
    if (has_position_limit(model, joint)) {
      lower.push_back(model.q_lower[joint.q_index]);
      upper.push_back(model.q_upper[joint.q_index]);
    }
  const auto rows = static_cast<Eigen::Index>(lower.size());
  return {Eigen::Map<const Eigen::VectorXd>(lower.data(), rows),
          Eigen::Map<const Eigen::VectorXd>(upper.data(), rows)};
}

}  // namespace burnish::ocp
