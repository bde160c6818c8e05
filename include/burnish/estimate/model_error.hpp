// Online estimate of the constant part of the model error. Adding the estimate to the model removes
// lasting control errors due to wrong masses, friction and torque offsets (offset-free model
// predictive control). For contact tasks see Jordana et al., "Force Feedback Model-Predictive
// Control via Online Estimation", 2024.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/contact/contact.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Model error that an MpcController estimates. The error is relative to the commanded torque and
/// therefore includes errors of the actuators.
/// @described mpc
/// If the problem has a torque model, the commanded torque is the output of the torque model's
/// filter.
enum class ModelErrorKind {
  /// No estimate, as in the controller of Kleff et al. (docs/frames.md)
  None,
  /// Torque error d of each joint, defined by the equation of motion M a + b = tau + J^T f + d
  /// @note An MpcController also estimates the ratio of friction along the surface to the normal
  /// force.
  Torque,
  Force,  ///< Measured normal force minus the normal force that the model predicts
};

/// Settings of the online estimate of the constant model error. The estimate is added to the model
/// (offset-free model predictive control).
/// @described mpc
struct ModelErrorOptions {
  /// Kind of error that is estimated: `none`, `torque` (per joint) or `force` (along the normal)
  ModelErrorKind kind = ModelErrorKind::Torque;
  /// Bandwidth of the observer (automatic: 30; for polishing, fitted to the arm) [rad/s], > 0
  /// @more A higher bandwidth corrects friction sooner and tolerates less delay. If `kind` is
  /// `force`, the observer closes a loop through the controller, and the delays of that loop limit
  /// the bandwidth. Example: if the force sensor is filtered at 50 Hz, the loop works at 50 rad/s
  /// and oscillates at 100 rad/s.
  /// @word auto
  std::optional<double> bandwidth = {};
  /// Largest factor on the bandwidth (automatic: 3; for polishing, fitted to the arm), > 0
  /// @more The factor rises while a torque error changes faster than its noise: after a push or an
  /// impact, or when a joint reverses. With 1, the bandwidth does not rise
  /// @word auto
  std::optional<double> transient_scale = {};
  /// Factor on the bandwidth while the torque error is only noise (1: no reduction), 0.01 to 1
  /// @more A smaller factor lets less noise pass, such as encoder steps
  double quiescent_scale = 1.0;
  /// Lag of velocities behind torques (automatic: 0; for polishing, fitted to the arm) [s], >= 0
  /// @more Motors and the filters of measured velocities cause the lag. MpcSpec.command_delay and
  /// measurement_delay are not part of the lag
  /// @word auto
  std::optional<double> lag = {};
  /// Gain on the normal force error (automatic: 0; for polishing, fitted to the arm) [N/N], >= 0
  /// @more The product of gain and force error is a commanded force on the tool. The gain is used
  /// only in contact, with a force sensor, and if `kind` is torque
  /// @word auto
  std::optional<double> force_gain = {};
  /// Bandwidth of the estimate of friction along the surface (0: as `bandwidth`) [rad/s], >= 0
  /// @more The estimate is made only if `kind` is torque
  double sliding_bandwidth = 0.0;
  /// Decay time that plans assume for a new torque error, as after a push [s], > 0 or infinite
  /// @more Errors that have lasted for some seconds do not decay. With an infinite decay time, no
  /// error decays.
  double decay_time = std::numeric_limits<double>::infinity();
  /// Largest magnitude of an estimate [Nm (N)], > 0
  /// @more For a floating base, the limit is at least 6 % of the robot's weight
  double limit = 30.0;
  /// Estimate joint friction separately and feed it forward
  /// @more The compensation changes sign as soon as a joint reverses. It is used only if `kind` is
  /// torque
  bool joint_friction = true;
  /// Joint speed below which the compensation of joint friction fades to zero [rad/s (m/s)], > 0
  double friction_speed = 0.001;

  /// Returns `bandwidth`, or 30 if unset [rad/s].
  double usual_bandwidth() const { return bandwidth.value_or(30.0); }
  /// Returns `transient_scale`, or 3 if unset.
  double usual_transient_scale() const { return transient_scale.value_or(3.0); }
  /// Returns `lag`, or 0 if unset [s].
  double usual_lag() const { return lag.value_or(0.0); }
  /// Returns `force_gain`, or 0 if unset [N/N].
  double usual_force_gain() const { return force_gain.value_or(0.0); }
};

/// Observer of the joint velocity, with the torque error d of each joint as disturbance state. Let
/// v be the measured velocity, v^ its estimate, e = v - v^ and w the bandwidth. The observer is
/// critically damped:
///   d/dt v^ = M^-1 (tau + J^T f + d - b) + 2 w e,   d/dt d = w^2 M e.
/// M is the mass matrix, b the bias torques, tau the commanded torque, and J^T f the joint torque
/// due to the force on the tool. In discrete time, both poles are at exp(-w dt) for any time step
/// dt. The estimate of a constant error is within 5 % of the error after 4.8 / w seconds.
///
/// If a force is not passed to update(), its joint torques become part of d. For example, if only
/// the normal force is passed, d contains friction along the surface.
///
/// The bandwidth w varies. While d changes faster than its noise, w rises up to `transient_scale`
/// times the nominal bandwidth. Afterwards w returns to the nominal bandwidth within about 0.3 s.
/// When d has shown only noise in all joints for a second, w is `quiescent_scale` times the nominal
/// bandwidth.
///
/// Measured velocities are filtered and therefore show the effect of a new command late. For this
/// reason the observer also delays the commanded torque: tau minus the gravity torque passes a
/// first-order low-pass filter with the time constant `lag`. Without this filter, the observer
/// would mistake a new command for a torque error.
class TorqueErrorObserver {
 public:
  /// `tool`: frame at which the force on the tool acts. `supports`: contacts that are always
  /// closed, such as feet. `measured`: frames of all contacts whose wrenches are passed to
  /// update(). `base`: robot frame on which the reaction to the force on the tool acts; empty: the
  /// reaction acts on the world.
  ///
  /// Torque errors that act within kinematic loops and do not move the robot are not estimated.
  /// Torque errors that supports balance are estimated only if the wrenches of the supports are
  /// measured. Supports whose frames are not in `measured` stay closed contacts. Throws Error for
  /// an unknown frame and for options out of range.
  TorqueErrorObserver(const Model& model, const std::string& tool, const ModelErrorOptions& options,
                      const std::vector<ContactSpec>& supports = {},
                      const std::vector<std::string>& measured = {}, const std::string& base = {});
  ~TorqueErrorObserver();
  TorqueErrorObserver(TorqueErrorObserver&&) noexcept;
  TorqueErrorObserver& operator=(TorqueErrorObserver&&) noexcept;

  void reset() noexcept;
  /// Updates the estimate with the measured configuration q (nq entries) and velocity v (nv
  /// entries), `dt` [s] after the previous call. `tau`: joint torques since the previous call, nv
  /// entries [Nm (N)]. `force_world`: force on the tool since the previous call, in world axes [N].
  /// The first call after reset() only initializes the velocity.
  ///
  /// Returns Ok or NotConverged. If the measurement cannot be evaluated, returns WrongSize,
  /// NotFinite, NotNormalized, SingularMass or SingularContacts and leaves the estimate unchanged.
  /// If `dt` is not positive, the estimate also stays unchanged. Does not allocate.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt) noexcept {
    return update(q, v, tau, force_world, dt, Wrenches(6, 0));
  }
  /// `supports`: measured wrenches, as in Measurement::wrenches, one column per entry of the
  /// constructor's `measured`, or no columns. NaN is not allowed.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt, const Wrenches& supports) noexcept;
  /// Sets the payload that the robot carries at `frame`. Returns and throws as
  /// ContactDynamics::set_payload() does.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  const Eigen::VectorXd& torque_error() const;  ///< Estimated torque error d, nv entries [Nm, or N]
  double bandwidth() const;                     ///< Bandwidth w at the last update [rad/s]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
