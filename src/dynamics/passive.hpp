// Torques that joints feel without a motor: viscous damping and Coulomb friction, the latter
// smoothed so that it has a derivative,
//   tau_k = -damping_k v_k - friction_k tanh(v_k / slip),
// and those of springs and tendons (springs.hpp). The model holds the coefficients; forward and
// inverse dynamics leave these torques out unless the caller adds them to tau.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"
#include "dynamics/springs.hpp"
#include "math/scalar.hpp"

namespace burnish {

struct PassiveJoints {
  /// Throws Error for a slip velocity that is not positive.
  explicit PassiveJoints(const Model& model, double slip_velocity = 0.01);

  std::vector<double> damping;   ///< nv, Nms/rad or Ns/m
  std::vector<double> friction;  ///< nv, Nm or N
  Springs springs;
  double slip;  ///< rate at which friction has reached tanh(1) = 76 %, rad/s or m/s; positive
};

/// The torques of damping and friction at v (nv), into tau (nv: Nm or N), and their derivatives
/// d(tau_k)/dv_k, into dtau_dv (nv: the diagonal of a diagonal matrix). With a pace of at most 1
/// friction has its full size at slip / pace.
template <class S>
void passive_torque(const PassiveJoints& joints, const S* v, S* tau, S* dtau_dv,
                    const S& pace = S(1.0)) {
  const S inverse_slip = S(1.0 / joints.slip) * pace;
  for (std::size_t k = 0; k < joints.damping.size(); ++k) {
    const S damping(joints.damping[k]), friction(joints.friction[k]);
    const S sliding = hyperbolic_tangent(S(v[k] * inverse_slip));
    tau[k] = -damping * v[k] - friction * sliding;
    dtau_dv[k] = -damping - friction * inverse_slip * (S(1.0) - sliding * sliding);
  }
}

}  // namespace burnish
