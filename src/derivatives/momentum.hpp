// Derivatives of the centre of mass c, the momentum h, the kinetic energy T and the potential
// energy V. S_k is the axis of joint k, I^C and h^C are the inertia and momentum of the subtree
// that joint k carries, and psi'_k = v_parent x S_k with the twist v_parent of the parent body:
//   dh/dv_k = I^C S_k,           dh/dq_k = S_k x* h^C + I^C psi'_k,
//   dT/dv_k = S_k . h^C,         dT/dq_k = psi'_k . h^C,
//   dc/dq_k = (I^C S_k)_linear / mass,   dV/dq_k = -gravity . (I^C S_k)_linear.
// A motion along S_k moves the inertias of the subtree, and changes the twists of its bodies by
// S_k x v + psi'_k (Singh, Russell, Wensing 2022). The part S_k x v does not change v . h.
#pragma once

#include <vector>

#include "dynamics/momentum.hpp"

namespace burnish {

/// Results of momentum_derivatives(). Matrices are row-major with nv columns.
template <class S>
struct MomentumDerivatives {
  explicit MomentumDerivatives(const Tree& tree);

  std::vector<S> com_dq;           ///< 3 x nv, in world axes; equal to d(com_velocity)/dv
  std::vector<S> com_velocity_dq;  ///< 3 x nv
  std::vector<S> total_dq;         ///< Momentum about the world's origin, 6 x nv, linear rows first
  std::vector<S> total_dv;         ///< 6 x nv
  std::vector<S> centroidal_dq;    ///< Momentum about the centre of mass, 6 x nv
  std::vector<S> centroidal_dv;    ///< Centroidal momentum matrix, 6 x nv
  std::vector<S> kinetic_dq;       ///< nv entries [J/rad, J/m]
  std::vector<S> kinetic_dv;       ///< M v, nv entries
  std::vector<S> potential_dq;     ///< Torques that hold the robot at rest, nv entries [N m, N]
};

/// Computes the derivatives. Requires update_momentum() at this state and velocity v (nv).
template <class S>
void momentum_derivatives(const Tree& tree, const Kinematics<S>& kinematics,
                          const Momentum<S>& momentum, const S* v, MomentumDerivatives<S>& d);

/// Computes only the derivative of the potential energy (potential_dq), in `out` (nv).
template <class S>
void gravity_torque(const Tree& tree, const Kinematics<S>& kinematics, const Momentum<S>& momentum,
                    S* out);

}  // namespace burnish
