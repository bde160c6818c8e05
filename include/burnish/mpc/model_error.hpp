// The constant part of what the model gets wrong, estimated from measurements and given back to the
// model, so that wrong masses, friction and torque offsets leave no lasting error (offset-free
// model predictive control; for contact tasks: Jordana et al., "Force Feedback Model-Predictive
// Control via Online Estimation", 2024).
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

/// What an MpcController estimates of what its model gets wrong. Both are relative to the torque
/// that was commanded, so that what actuators get wrong is part of them.
/// @described mpc
/// The command counts behind the torque model's filter, where the problem has one.
enum class ModelErrorKind {
  None,  ///< nothing: the paper's controller
  /// d in M a + b = tau + J^T f + d, a torque per joint @note in an MpcController also the ratio of
  /// friction along the surface to the normal force
  Torque,
  Force,  ///< what the measured normal force is above the one that the model predicts
};

/// The constant part of what the model gets wrong, estimated from measurements and given back to
/// the model (offset-free model predictive control).
/// @described mpc
struct ModelErrorOptions {
  /// none, torque (per joint) or force (along the normal)
  ModelErrorKind kind = ModelErrorKind::Torque;
  /// [rad/s] of the observer; a higher one follows friction sooner and tolerates less delay; auto:
  /// fitted to the arm where a task does that, else 30, > 0 @code rad/s of the observer; a higher
  /// one follows friction sooner and tolerates less delay; none: fitted to the arm where a task
  /// does that, else 30 @more With kind force the observer closes a loop through the controller,
  /// whose delays bound its bandwidth: behind a force sensor filtered at 50 Hz, 50 rad/s work and
  /// 100 rad/s oscillate. @word auto
  std::optional<double> bandwidth = {};
  /// factor on the bandwidth while a torque error changes faster than its noise: after a push or an
  /// impact, or where a joint reverses; 1: no boost; auto: fitted to the arm where a task does
  /// that, else 3, > 0 @code factor on the bandwidth while a torque error changes faster than its
  /// noise: after a push or an impact, or where a joint reverses; 1: no boost; none: fitted to the
  /// arm where a task does that, else 3 @word auto
  std::optional<double> boost = {};
  /// factor on the bandwidth while noise alone, such as encoder steps, changes the torque error: a
  /// slower observer passes less of it on; 1: never, 0.01 to 1
  double calm = 1.0;
  /// [s] by which measured velocities follow torques later than known delays say, behind filters
  /// and motors; auto: fitted to the arm where a task does that, else 0, >= 0 @code s by which
  /// measured velocities follow torques later than known delays say, behind filters and motors;
  /// none: fitted to the arm where a task does that, else 0 @word auto
  std::optional<double> lag = {};
  /// [N] pushed back at once for each N that the measured normal force is off in contact, of kind
  /// torque with a force sensor; auto: fitted to the arm where a task does that, else 0, >= 0 @code
  /// N pushed back at once for each N that the measured normal force is off in contact, of kind
  /// torque with a force sensor; none: fitted to the arm where a task does that, else 0 @word auto
  std::optional<double> force_gain = {};
  /// [rad/s] of the estimate of friction along the surface, with kind torque; 0: the bandwidth, >=
  /// 0
  double sliding_bandwidth = 0.0;
  /// [s], decay time that plans assume for a torque error that has just appeared, as after a push,
  /// > 0 or infinite @more Errors that have lasted for some seconds do not decay; infinite: none
  /// does.
  double fading = std::numeric_limits<double>::infinity();
  /// [Nm (N)], largest magnitude of an estimate; for a floating base at least 6 % of its weight, >
  /// 0
  double limit = 30.0;
  /// with kind torque: joint friction is estimated separately and fed forward, so that it changes
  /// sign as soon as a joint reverses
  bool joint_friction = true;
  double friction_speed = 0.001;  ///< [rad/s] (m/s) over which that friction changes its sign, > 0

  double usual_bandwidth() const { return bandwidth.value_or(30.0); }  ///< rad/s
  double usual_boost() const { return boost.value_or(3.0); }
  double usual_lag() const { return lag.value_or(0.0); }                ///< s
  double usual_force_gain() const { return force_gain.value_or(0.0); }  ///< N/N
};

/// An observer of the joint velocity with the torque error as its disturbance state: with e = v -
/// v^, critically damped at the bandwidth w,
///   d(v^)/dt = M^-1 (tau + J^T f + d - b) + 2 w e,   d(d)/dt = w^2 M e,
/// sampled so that both poles are at exp(-w dt) whatever dt is: after 4.8 / w s a constant error is
/// known to 5 %. Forces that are not given to it are part of d: given the normal force alone, so is
/// friction along the surface. Where d changes faster than its noise has it, w is up to `boost`
/// times the bandwidth, and comes back within some 0.3 s. Where d has but noise in every joint
/// during a second, w is `calm` times the bandwidth. What tau is beyond gravity is taken behind a
/// first-order filter of time constant `lag`: compared with velocities that come behind filters, a
/// command that has just been given would be an error, and answered by another command.
class TorqueErrorObserver {
 public:
  /// `tool`: frame that the force acts at. `supports`: contacts that always hold, such as the feet
  /// that a robot stands on; of the torque error the part that loops carry moves nothing and is not
  /// known, nor is what supports carry unless their wrenches are measured. `measured`: frames that
  /// update() is given wrenches at, of supports and of what else the robot leans on. `base`: frame
  /// of the robot that the force pushes back at, where the tool is; empty: the world bears it.
  /// Throws Error for an unknown frame and options out of range.
  TorqueErrorObserver(const Model& model, const std::string& tool, const ModelErrorOptions& options,
                      const std::vector<ContactSpec>& supports = {},
                      const std::vector<std::string>& measured = {}, const std::string& base = {});
  ~TorqueErrorObserver();
  TorqueErrorObserver(TorqueErrorObserver&&) noexcept;
  TorqueErrorObserver& operator=(TorqueErrorObserver&&) noexcept;

  void reset() noexcept;
  /// A measurement, dt s after the last one: q (nq), v (nv), and what has acted since: joint
  /// torques tau (nv) and the force on the tool (N, world axes). The first one after reset() only
  /// sets the velocity. A measurement that cannot be evaluated changes nothing, nor does a dt that
  /// is not positive after the first: WrongSize, NotFinite, NotNormalized or SingularMass. No
  /// allocation.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt) noexcept {
    return update(q, v, tau, force_world, dt, Wrenches(6, 0));
  }
  /// The same with what acts at the measured frames, in their order:
  /// Measurement::support_wrenches.
  using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  Status update(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau,
                const Eigen::Vector3d& force_world, double dt, const Wrenches& supports) noexcept;
  /// As ContactDynamics::set_payload.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  const Eigen::VectorXd& torque_error() const;  ///< d, nv, Nm (N)
  double bandwidth() const;                     ///< w of the last update, rad/s

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
