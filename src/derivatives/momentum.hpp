// Derivatives of centre of mass, momentum and energy from composite inertias and momenta: with I^C
// and h^C those of the subtree that joint k carries and psi'_k = v_parent x S_k,
//   dh/dv_k = I^C S_k,           dh/dq_k = S_k x* h^C + I^C psi'_k,
//   dT/dv_k = S_k . h^C,         dT/dq_k = psi'_k . h^C,
//   dc/dq_k = (I^C S_k)_linear / mass,   dV/dq_k = -gravity . (I^C S_k)_linear.
// A subtree that moves with S_k carries its inertias along; its twists change by S_k x v + psi'_k
// (Singh, Russell, Wensing 2022), and S_k x v does not change v . h.
#pragma once

#include <vector>

#include "dynamics/momentum.hpp"

namespace burnish {

/// Filled by momentum_derivatives. Matrices are row-major with nv columns.
template <class S>
struct MomentumDerivatives {
  explicit MomentumDerivatives(const Tree& tree);

  std::vector<S> com_dq;           ///< 3 x nv, world axes; d(com_velocity)/dv too
  std::vector<S> com_velocity_dq;  ///< 3 x nv
  std::vector<S> total_dq;         ///< 6 x nv, linear rows first, about the world's origin
  std::vector<S> total_dv;         ///< 6 x nv
  std::vector<S> centroidal_dq;    ///< 6 x nv, about the centre of mass
  std::vector<S> centroidal_dv;    ///< 6 x nv, the centroidal momentum matrix
  std::vector<S> kinetic_dq;       ///< nv, J/rad (J/m)
  std::vector<S> kinetic_dv;       ///< nv, M v
  std::vector<S> potential_dq;     ///< nv: the torques that hold the robot at rest, Nm (N)
};

/// Needs update_momentum at the same state; v: nv.
template <class S>
void momentum_derivatives(const Tree& tree, const Kinematics<S>& kinematics,
                          const Momentum<S>& momentum, const S* v, MomentumDerivatives<S>& d);

/// potential_dq alone, into out (nv).
template <class S>
void gravity_torque(const Tree& tree, const Kinematics<S>& kinematics, const Momentum<S>& momentum,
                    S* out);

}  // namespace burnish
