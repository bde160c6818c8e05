// The force on each foot where no sensor measures it: from joint torques through the dynamics.
#pragma once

#include <memory>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/base_estimator.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// What the motion asks for beyond the joints' torques is the feet's:
///   J^T f = M dv/dt + b - tau.
/// Behind a first-order low-pass at the bandwidth w it is the observer of generalized momentum (De
/// Luca, Mattone, "Actuator failure detection and isolation using generalized momenta", 2003),
///   dr/dt = w (M dv/dt + b - tau - r),
/// whose dv/dt is that of two ticks. The feet's forces, and the moments of soles, are what fits r
/// best, joints that no foot moves by and the base included: min |J^T f - r|.
class FootForces {
 public:
  /// bandwidth: rad/s. Throws Error for feet that are unknown or fixed to the world, and for a
  /// bandwidth that is not positive.
  FootForces(const Model& model, const std::vector<FootSpec>& feet, double bandwidth);
  ~FootForces();
  FootForces(FootForces&&) noexcept;
  FootForces& operator=(FootForces&&) noexcept;

  void reset() noexcept;
  /// The state and the torques (nv, Nm or N; none in the base's entries) that acted in the dt s
  /// since the last one. The first update after reset() takes the robot to be at rest or in steady
  /// motion, dv/dt = 0. WrongSize, NotFinite (also for a dt that is not positive), NotNormalized,
  /// SingularContacts where the posture does not tell feet apart; unless Ok nothing changes.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                double dt) noexcept;

  const Eigen::Matrix3Xd& forces_world() const;  ///< of the ground on each foot, N, world axes
  const Eigen::VectorXd& normal_forces() const;  ///< against gravity, N, one per foot

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
