// Contact force of a spring, a damper and Coulomb friction. The force is computed implicitly, for
// the end of a time step. Stiff springs and sticking friction therefore need no short steps.
#pragma once

#include <Eigen/Core>

namespace burnish {

struct PenaltyContact {
  double stiffness;  ///< Spring stiffness K [N/m]
  double damping;    ///< Damping D [Ns/m]
  double friction;   ///< Coulomb friction coefficient mu
};

/// Motion of the tip over a time step in which the contact force is zero. A constant force f would
/// make the velocity at the end of the step v + dt A f.
struct TipStep {
  double dt;          ///< Time step [s]
  double depth;       ///< Depth in the material at the start of the step [m]
  Eigen::Vector3d n;  ///< Normal, pointing out of the material
  Eigen::Vector3d v;  ///< Velocity at the end of the step without the force [m/s]
  Eigen::Matrix3d A;  ///< Inverse inertia of the tip, symmetric and positive definite [1/kg]
};

/// Returns the force on the tip, in world axes [N]; 0 if the tip is not in the material. The normal
/// force is max(0, K d - D v_n), with the depth d and the normal velocity v_n at the end of the
/// step. If friction of at most mu times the normal force can stop the sliding, it does. Otherwise,
/// friction has this magnitude, opposite to the sliding velocity at the end of the step.
Eigen::Vector3d penalty_force(const PenaltyContact& contact, const TipStep& tip) noexcept;

}  // namespace burnish
