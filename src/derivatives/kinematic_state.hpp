// State of a RigidBody, for classes that reuse its kinematics.
#pragma once

#include <Eigen/Core>

#include "dynamics/kinematics.hpp"

namespace burnish {

/// Last accepted state of a RigidBody: q (nq), v (nv) and the kinematics at this state.
struct KinematicState {
  const Eigen::VectorXd &q, &v;
  const Kinematics<double>& kinematics;
};

}  // namespace burnish
