// Passive joint torques: viscous damping and smoothed Coulomb friction,
//   tau_k = -damping_k v_k - friction_k tanh(v_k / slip),
// and torques of springs and tendons (springs.hpp). The coefficients are part of the model. Forward
// and inverse dynamics do not include passive torques; the caller adds them to tau.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"
#include "dynamics/springs.hpp"
#include "math/scalar.hpp"

namespace burnish {

/// Coefficients of the passive torques of all joints.
struct PassiveJoints {
  /// Throws Error if `slip_velocity` is not positive.
  explicit PassiveJoints(const Model& model, double slip_velocity = 0.01);

  std::vector<double> damping;   ///< Viscous damping, nv entries [Nms/rad or Ns/m]
  std::vector<double> friction;  ///< Coulomb friction, nv entries [Nm or N]
  Springs springs;
  double slip;  ///< Velocity at which friction reaches tanh(1) = 76 %, positive [rad/s or m/s]
};

/// Computes the torques of damping and friction at v (nv) into tau (nv) [Nm or N], and their
/// derivatives d(tau_k)/dv_k into dtau_dv (nv). The smoothing of friction uses slip / step_ratio in
/// place of slip; `step_ratio` is at most 1.
template <class S>
void passive_torque(const PassiveJoints& joints, const S* v, S* tau, S* dtau_dv,
                    const S& step_ratio = S(1.0)) {
  const S inverse_slip = S(1.0 / joints.slip) * step_ratio;
  for (std::size_t k = 0; k < joints.damping.size(); ++k) {
    const S damping(joints.damping[k]), friction(joints.friction[k]);
    const S sliding = hyperbolic_tangent(S(v[k] * inverse_slip));
    tau[k] = -damping * v[k] - friction * sliding;
    dtau_dv[k] = -damping - friction * inverse_slip * (S(1.0) - sliding * sliding);
  }
}

}  // namespace burnish
