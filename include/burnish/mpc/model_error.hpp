// Online estimate of the constant part of the model error. Adding the estimate to the model removes
// lasting errors due to wrong masses, friction and torque offsets (offset-free model predictive
// control). For contact tasks see Jordana et al., "Force Feedback Model-Predictive Control via
// Online Estimation", 2024.
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

/// Model error that an MpcController estimates. The estimate is relative to the commanded torque,
/// so it includes errors of the actuators.
/// @described mpc
/// If the problem has a torque model, the commanded torque means the output of that model's filter.
enum class ModelErrorKind {
  /// No estimate, as in the controller of Kleff et al. (docs/frames.md)
  None,
  /// Torque error d of each joint, defined by M a + b = tau + J^T f + d
  /// @note An MpcController also estimates the ratio of friction along the surface to the normal
  /// force.
  Torque,
  Force,  ///< Measured normal force minus the normal force that the model predicts
};

/// Settings of the online estimate of the constant model error. The estimate is added to the model
/// (offset-free model predictive control).
/// @described mpc
struct ModelErrorOptions {
  /// Estimated error: none, torque (per joint) or force (along the normal)
  ModelErrorKind kind = ModelErrorKind::Torque;
  /// Bandwidth of the observer (auto: fitted to the arm in polishing, else 30) [rad/s], > 0
  /// @code Bandwidth of the observer (none: fitted to the arm in polishing, else 30) [rad/s]
  /// @more A higher bandwidth corrects friction sooner and tolerates less delay. With kind force,
  /// the observer closes a loop through the controller, and the delays of that loop limit the
  /// bandwidth. Example: with a force sensor that is filtered at 50 Hz, 50 rad/s work and 100 rad/s
  /// oscillate.
  /// @word auto
  std::optional<double> bandwidth = {};
  /// Largest factor on the bandwidth (auto: fitted to the arm in polishing, else 3), > 0
  /// @code Largest factor on the bandwidth (none: fitted to the arm in polishing, else 3)
  /// @more The factor rises while a torque error changes faster than its noise: after a push or an
  /// impact, or where a joint reverses. The value 1 means no boost
  /// @word auto
  std::optional<double> boost = {};
  /// Factor on the bandwidth while the torque error has only noise (1: no reduction), 0.01 to 1
  /// @more A smaller factor lets less noise pass, such as encoder steps
  double calm = 1.0;
  /// Lag of velocities behind torques (auto: fitted to the arm in polishing, else 0) [s], >= 0
  /// @code Lag of velocities behind torques (none: fitted to the arm in polishing, else 0) [s]
  /// @more Motors and the filters of measured velocities cause this lag. The stated command and
  /// measurement delays are not part of the lag
  /// @word auto
  std::optional<double> lag = {};
  /// Gain on the normal force error (auto: fitted to the arm in polishing, else 0) [N/N], >= 0
  /// @code Gain on the normal force error (none: fitted to the arm in polishing, else 0) [N/N]
  /// @more Force error times gain is a commanded force on the tool. Used in contact, with kind
  /// torque and a force sensor
  /// @word auto
  std::optional<double> force_gain = {};
  /// Bandwidth of the estimate of friction along the surface (0: as `bandwidth`) [rad/s], >= 0
  /// @more Used with kind torque
  double sliding_bandwidth = 0.0;
  /// Decay time that plans assume for a new torque error, as after a push [s], > 0 or infinite
  /// @more Errors that have lasted for some seconds do not decay. With an infinite decay time, no
  /// error decays.
  double fading = std::numeric_limits<double>::infinity();
  /// Largest magnitude of an estimate [Nm (N)], > 0
  /// @more For a floating base, at least 6 % of the robot's weight
  double limit = 30.0;
  /// Estimate joint friction separately and feed it forward
  /// @more The compensation changes sign as soon as a joint reverses. Used with kind torque
  bool joint_friction = true;
  /// Joint speed below which the compensation of joint friction fades to zero [rad/s (m/s)], > 0
  double friction_speed = 0.001;

  /// Returns `bandwidth`, or 30 if unset [rad/s].
  double usual_bandwidth() const { return bandwidth.value_or(30.0); }
  /// Returns `boost`, or 3 if unset.
  double usual_boost() const { return boost.value_or(3.0); }
  /// Returns `lag`, or 0 if unset [s].
  double usual_lag() const { return lag.value_or(0.0); }
  /// Returns `force_gain`, or 0 if unset [N/N].
  double usual_force_gain() const { return force_gain.value_or(0.0); }
};

/// Observer of the joint velocity, with the torque error d of each joint as disturbance state. Let
/// v be the measured velocity, v^ its estimate, e = v - v^ and w the bandwidth. The observer is
/// critically damped:
///   d/dt v^ = M^-1 (tau + J^T f + d - b) + 2 w e,   d/dt d = w^2 M e.
/// In discrete time, both poles are at exp(-w dt) for any time step dt. The estimate of a constant
/// error is within 5 % of that error after 4.8 / w seconds.
///
/// The joint torques due to forces that are not passed to update() become part of d. For example,
/// if only the normal force is passed, d contains friction along the surface.
///
/// The bandwidth w varies. While d changes faster than its noise, w rises up to `boost` times the
/// nominal bandwidth. Afterwards w returns to the nominal bandwidth within about 0.3 s. When all
/// joints have shown only noise in d for a second, w is `calm` times the nominal bandwidth.
///
/// Measured velocities are filtered, so they show the effect of a new command late. The observer
/// delays the commanded torque too: tau minus the gravity torque passes a first-order low-pass
/// filter with the time constant `lag`. Without this filter, a new command would look like a torque
/// error and be compensated by another command.
class TorqueErrorObserver {
 public:
  /// `tool`: frame at which the force on the tool acts. `supports`: contacts that always hold, such
  /// as feet. `measured`: frames of the supports and other contacts whose wrenches are passed to
  /// update(). `base`: robot frame that receives the opposite force; empty: the world receives it.
  ///
  /// Torque errors that are balanced within kinematic loops do not move the robot and are not
  /// estimated. Torque errors that are balanced by supports are estimated only if the wrenches of
  /// the supports are measured. Throws Error for an unknown frame and for options out of range.
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
  /// If `dt` is not positive, the estimate stays unchanged too. Does not allocate.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt) noexcept {
    return update(q, v, tau, force_world, dt, Wrenches(6, 0));
  }
  /// Wrenches at the frames `measured` of the constructor, one column per frame. A column has the
  /// format of Measurement::support_wrenches.
  using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt, const Wrenches& supports) noexcept;
  /// Sets the payload that the robot carries at `frame`. Status and exceptions are described at
  /// ContactDynamics::set_payload().
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  const Eigen::VectorXd& torque_error() const;  ///< Estimated torque error d, nv entries [Nm, or N]
  double bandwidth() const;                     ///< Bandwidth w at the last update [rad/s]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
