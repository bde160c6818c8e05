// A contact as a spring, a damper and Coulomb friction, solved for at the end of a step, so that
// stiff springs and sticking friction need no shorter steps.
#pragma once

#include <Eigen/Core>

namespace burnish {

struct PenaltyContact {
  double stiffness;  ///< N/m
  double damping;    ///< Ns/m
  double friction;   ///< Coulomb coefficient mu
};

/// The tip over a step of `dt` s, as it would be without the force: with a force f, held over the
/// step, its velocity at the end is v + dt A f.
struct TipStep {
  double dt;
  double depth;       ///< m in the material, at the begin of the step
  Eigen::Vector3d n;  ///< normal out of the material
  Eigen::Vector3d v;  ///< m/s
  Eigen::Matrix3d A;  ///< inverse inertia, 1/kg, symmetric and positive
};

/// The force on the tip, N, world axes: along n it is K d - D d' of the depth at the end, never
/// below zero; across n mu times that against the sliding velocity at the end, or what stops it.
/// Zero where the tip is not in the material.
Eigen::Vector3d penalty_force(const PenaltyContact& contact, const TipStep& tip) noexcept;

}  // namespace burnish
