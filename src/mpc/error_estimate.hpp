// What the model gets wrong, as an MpcController estimates it from tick to tick: see
// ModelErrorKind.
#pragma once

#include "mpc/contact_force_estimate.hpp"
#include "mpc/felt_force.hpp"
#include "mpc/joint_friction.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/tool_motion.hpp"

namespace burnish {

class ErrorEstimate {
 public:
  /// spec: of a normal of length one.
  explicit ErrorEstimate(const MpcSpec& spec);

  void reset() noexcept;
  /// After a good measurement, with the command of the tick before, the torque that acted until it
  /// was taken less what that made up for friction (nv), the stage that the schedule is in and its
  /// time, s. What cannot be evaluated changes nothing. `waits`: the schedule waits for contact,
  /// as Schedule::waits() says.
  void update(const MeasurementGate& gate, const Command& before, const ConstVectorRef& acted,
              int stage, double schedule_time, bool waits) noexcept;

  /// Without a force sensor, first of all after a good measurement: the force at the tool, N, world
  /// axes, at the stage that the schedule is in.
  const Eigen::Vector3d& feel(const MeasurementGate& gate, const ConstVectorRef& acted,
                              int stage) noexcept;
  /// Forward dynamics with the surface and the friction as they are known now.
  ContactForceEstimate& dynamics() { return contact_force_; }
  /// The surface at the tool from now on: its normal, and what contacts that follow it hold.
  void set_surface(const Quadric& surface, const Eigen::Vector3d& normal_world) noexcept {
    normal_world_ = normal_world;
    contact_force_.set_surface(surface);
  }
  /// Its normal alone, of length one, of a surface that turns.
  void set_normal(const Eigen::Vector3d& normal_world) noexcept { normal_world_ = normal_world; }
  /// What the robot carries at a frame, of which torques and forces are told from now on.
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)observer_.set_payload(frame, payload);
    felt_.set_payload(frame, payload);
    contact_force_.set_payload(frame, payload);
  }
  const Eigen::Vector3d& normal_world() const { return normal_world_; }
  /// Of the tool's contacts with friction: their coefficient; 0 without them.
  double friction() const { return friction_ ? friction_->coefficient() : 0.0; }

  /// nv, of a new plan, joint_friction().lead() after it begins: friction in joints and along the
  /// surface turns around with it.
  void foresee(const Eigen::VectorXd& v) noexcept {
    joint_friction_.foresee(v.data());
    v_ahead_ = v;
  }

  /// Its torque is taken for a part of the command before: that which friction takes away again.
  JointFriction& joint_friction() { return joint_friction_; }

  /// nv, observed and of friction, Nm (N).
  const Eigen::VectorXd& torque_error() const { return torque_error_; }
  /// nv, of that: what is observed, without the friction that is asked for; Nm (N).
  const Eigen::VectorXd& observed_error() const { return model_error(); }
  /// Whether contacts of the tool have friction of their own.
  bool models_friction() const { return friction_.has_value(); }
  /// nv, of that: what has been there for some seconds, Nm (N).
  const Eigen::VectorXd& lasting_error() const { return lasting_error_; }
  double force_error() const { return force_error_; }  ///< N
  /// nv, slow part of measured minus acted torque, Nm (N).
  const Eigen::VectorXd& torque_offset() const { return torque_offset_; }
  /// Of the stage's contacts on the tool, N, world axes.
  const Eigen::Vector3d& force_world() const { return force_world_; }
  /// nv, to be added to a command: force_gain times what the normal force is off, Nm (N).
  const Eigen::VectorXd& force_feedback() const { return force_feedback_; }

 private:
  Eigen::Vector3d known_force(const Measurement& m, double dt, bool waits) noexcept;
  double normal_force(const Measurement& m) const noexcept {
    return m.tool_force_world.dot(normal_world_);
  }
  const Eigen::VectorXd& model_error() const {
    return has_sensor_ ? observer_.torque_error() : felt_.model_error();
  }
  double observed_at() const {  ///< rad/s
    return has_sensor_ ? observer_.bandwidth() : felt_.bandwidth();
  }
  void follow_command(const MeasurementGate& gate, const ConstVectorRef& acted) noexcept;
  void push_back(const MeasurementGate& gate, const Command& before) noexcept;
  void follow_lasting(double dt) noexcept;
  void follow_friction(const MeasurementGate& gate, const Command& before) noexcept;
  Eigen::Vector3d turned_friction(double dt, double bandwidth) noexcept;
  Eigen::Vector3d explained_friction(const MeasurementGate& gate,
                                     const Eigen::Vector3d& across) noexcept;
  void follow_force_error(const Measurement& m, int stage, double schedule_time,
                          double share) noexcept;

  ModelErrorOptions options_;
  std::optional<TorqueModel> filter_;
  Eigen::Vector3d normal_world_, normal_at_first_;
  double contact_threshold_;  ///< N
  TorqueErrorObserver observer_;
  FeltForce felt_;
  JointFriction joint_friction_;
  bool has_sensor_;
  ContactForceEstimate contact_force_;
  ToolMotion tool_motion_;
  /// nv, torque that the model believes to act, less that of joint_friction_
  Eigen::VectorXd acted_;
  Eigen::VectorXd force_feedback_;
  double pressed_for_ = 0.0;  ///< s, with a force that is asked for
  Eigen::VectorXd torque_offset_, torque_error_, lasting_error_, total_;
  Eigen::VectorXd v_ahead_;  ///< nv, of a plan
  double since_ = 0.0;       ///< s, of lasting_error_
  double waits_for_ = 0.0;   ///< s, since contact was due
  double smoothing_;         ///< s
  double known_delay_;       ///< s, of commands and measurements
  /// m/s, of the tool in v_ahead_, smoothed once and twice: its velocity when torques act
  Eigen::Vector3d between_ = Eigen::Vector3d::Zero(), v_tool_ = between_;
  Eigen::Vector3d slid_ = between_;  ///< sliding_direction() of that, when forces were measured
  double pressed_ = 0.0;             ///< N, normal force behind the bandwidth
  /// N, along the surface, alike: what the contacts' own friction does not explain
  Eigen::Vector3d friction_force_ = Eigen::Vector3d::Zero();
  std::optional<FrictionEstimator> friction_;
  double planned_speed_ = 0.0;  ///< m/s, SlidingFriction::speed of plans
  Eigen::Vector3d force_world_ = Eigen::Vector3d::Zero();
  double force_error_ = 0.0;
};

}  // namespace burnish
