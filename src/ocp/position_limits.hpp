// Position limits as residual::JointPosition has its rows: of limited joints, not of entries of q.
#pragma once

#include <cmath>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish::ocp {

/// Whether the joint is a row of residual::JointPosition{}: one coordinate with a limit.
inline bool has_position_limit(const Model& model, const Joint& joint) {
  return joint.nq == 1 && (std::isfinite(model.q_lower[joint.q_index]) ||
                           std::isfinite(model.q_upper[joint.q_index]));
}

/// A lower and an upper limit per row of residual::JointPosition{}, rad (m); empty where no joint
/// has any.
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
