// Estimate of the model error in an MpcController, updated at every tick (see ModelErrorKind).
#pragma once

#include "mpc/contact_force_estimate.hpp"
#include "mpc/felt_force.hpp"
#include "mpc/joint_friction.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

class ErrorEstimate {
 public:
  /// `spec.normal_base` must be a unit vector.
  explicit ErrorEstimate(const MpcSpec& spec);

  void reset() noexcept;
  /// Updates the estimate after a valid measurement. If the dynamics cannot be evaluated, the
  /// estimate stays unchanged.
  /// - `before`: command of the previous tick.
  /// - `acted`: torque that acted until the measurement, without the compensation of joint friction
  ///   (nv).
  /// - `stage`, `schedule_time`: stage and time of the schedule [s].
  /// - `waits`: result of Schedule::waits().
  void update(const MeasurementGate& gate, const Command& before, const ConstVectorRef& acted,
              int stage, double schedule_time, bool waits) noexcept;

  /// Estimates and returns the force at the tool, in world axes [N]. Called before update() if the
  /// robot lacks a force sensor. `stage`: current stage of the schedule.
  const Eigen::Vector3d& feel(const MeasurementGate& gate, const ConstVectorRef& acted,
                              int stage) noexcept;
  /// Returns the forward dynamics that use the current estimates of surface and friction.
  ContactForceEstimate& dynamics() { return contact_force_; }
  /// Sets the surface under the tool, for the contacts that follow it, and the unit normal of the
  /// surface.
  void set_surface(const Quadric& surface, const Eigen::Vector3d& normal_world) noexcept {
    normal_world_ = normal_world;
    contact_force_.set_surface(surface);
  }
  /// Sets only the unit normal, for a surface that has rotated.
  void set_normal(const Eigen::Vector3d& normal_world) noexcept { normal_world_ = normal_world; }
  /// Sets the payload at a frame for all later estimates.
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)observer_.set_payload(frame, payload);
    felt_.set_payload(frame, payload);
    contact_force_.set_payload(frame, payload);
  }
  const Eigen::Vector3d& normal_world() const { return normal_world_; }
  /// Returns the coefficient of friction of the tool's contacts; 0 without a friction model.
  double friction() const { return friction_ ? friction_->coefficient() : 0.0; }

  /// Sets the planned velocity (nv) of a new plan, at joint_friction().lead() after the plan's
  /// first knot. The estimates of friction change sign with this velocity.
  void foresee(const Eigen::VectorXd& v) noexcept {
    joint_friction_.foresee(v.data());
    v_ahead_ = v;
  }

  /// Returns the estimate of joint friction. The torques passed to update() must not include its
  /// compensation.
  JointFriction& joint_friction() { return joint_friction_; }

  /// Returns the estimated torque error; nv [Nm or N]. It includes friction along the surface.
  const Eigen::VectorXd& torque_error() const { return torque_error_; }
  /// Returns the part of torque_error() from the observer; nv [Nm or N]. It does not include
  /// friction along the surface.
  const Eigen::VectorXd& observed_error() const { return model_error(); }
  /// Returns true if the tool's contacts have a friction model.
  bool models_friction() const { return friction_.has_value(); }
  /// Returns the mean of torque_error() over the last seconds; nv [Nm or N].
  const Eigen::VectorXd& lasting_error() const { return lasting_error_; }
  double force_error() const { return force_error_; }  ///< Estimated force error [N].
  /// Returns the low-pass filtered difference, measured minus acting torque; nv [Nm or N].
  const Eigen::VectorXd& torque_offset() const { return torque_offset_; }
  /// Returns the estimated sum of the contact forces on the tool, in world axes [N].
  const Eigen::Vector3d& force_world() const { return force_world_; }
  /// Returns the torque to add to a command as force feedback; nv [Nm or N]. It is the error of the
  /// normal force times force_gain, converted to joint torques.
  const Eigen::VectorXd& force_feedback() const { return force_feedback_; }

 private:
  Eigen::Vector3d observed_force(const Measurement& m, double dt, bool waits) noexcept;
  double normal_force(const Measurement& m) const noexcept {
    return m.tool_force_world.dot(normal_world_);
  }
  const Eigen::VectorXd& model_error() const {
    return has_sensor_ ? observer_.torque_error() : felt_.model_error();
  }
  double observer_bandwidth() const {  ///< Bandwidth of the observer in use [rad/s].
    return has_sensor_ ? observer_.bandwidth() : felt_.bandwidth();
  }
  void follow_command(const MeasurementGate& gate, const ConstVectorRef& acted) noexcept;
  void update_force_feedback(const MeasurementGate& gate, const Command& before) noexcept;
  void follow_lasting(double dt) noexcept;
  void follow_friction(const MeasurementGate& gate, const Command& before) noexcept;
  Eigen::Vector3d friction_along_plan(double dt, double bandwidth) noexcept;
  Eigen::Vector3d explained_friction(const MeasurementGate& gate,
                                     const Eigen::Vector3d& across) noexcept;
  void follow_force_error(const Measurement& m, int stage, double schedule_time,
                          double weight) noexcept;

  ModelErrorOptions options_;
  std::optional<TorqueModel> filter_;
  Eigen::Vector3d normal_world_, normal_at_first_;
  double contact_threshold_;  ///< Normal force above which the tool is in contact [N].
  TorqueErrorObserver observer_;
  FeltForce felt_;
  JointFriction joint_friction_;
  bool has_sensor_;
  ContactForceEstimate contact_force_;
  ToolMotion tool_motion_;
  /// Torque that acts according to the torque model, without the compensation of joint friction;
  /// nv.
  Eigen::VectorXd acted_;
  Eigen::VectorXd force_feedback_;
  double pressed_for_ = 0.0;  ///< Time in contact while a force is commanded [s].
  Eigen::VectorXd torque_offset_, torque_error_, lasting_error_, total_;
  Eigen::VectorXd v_ahead_;    ///< Planned velocity set by foresee(), nv.
  double lasting_time_ = 0.0;  ///< Averaging time of lasting_error_ so far [s].
  double waits_for_ = 0.0;     ///< Time for which the schedule has waited for contact [s].
  double smoothing_;           ///< Time constant of the filters of between_ and v_tool_ [s].
  double nominal_delay_;       ///< Stated delay of commands plus stated delay of measurements [s].
  /// Planned tool velocity from v_ahead_, low-pass filtered once (between_) and twice (v_tool_)
  /// [m/s]. v_tool_ is the planned velocity at the time when torques act.
  Eigen::Vector3d between_ = Eigen::Vector3d::Zero(), v_tool_ = between_;
  /// Direction of v_tool_ at the time of the force measurement.
  Eigen::Vector3d slid_ = between_;
  double pressed_ = 0.0;  ///< Low-pass filtered normal force [N].
  /// Low-pass filtered force along the surface, without the friction in the contact models [N].
  Eigen::Vector3d friction_force_ = Eigen::Vector3d::Zero();
  std::optional<FrictionEstimator> friction_;
  double planned_speed_ = 0.0;  ///< Planned speed, as in SlidingFriction::speed [m/s].
  Eigen::Vector3d force_world_ = Eigen::Vector3d::Zero();
  double force_error_ = 0.0;
};

}  // namespace burnish
