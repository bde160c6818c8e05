// Estimate of the model error, updated at each valid measurement (see ModelErrorKind).
#pragma once

#include "burnish/estimate/measurement.hpp"
#include "estimate/contact_force_estimate.hpp"
#include "estimate/felt_force.hpp"
#include "estimate/joint_friction.hpp"
#include "estimate/tool_friction.hpp"

namespace burnish {

/// Settings of an ErrorEstimate for one tool.
struct ErrorTool {
  /// Unit normal of the surface in world axes, before set_surface() or set_normal() is called.
  Eigen::Vector3d normal_world;
  double contact_threshold;  ///< Normal force above which the tool is in contact [N].
  /// Settings of the friction estimate; not set: the tool's contacts have no friction.
  std::optional<FrictionEstimateOptions> friction = {};
  /// Speed below which friction fades out in plans; unused without `friction` [m/s].
  double planned_speed = 0.0;
};

/// Settings of an ErrorEstimate.
struct ErrorEstimateSpec {
  Model model;
  ModelErrorOptions options;
  /// Cutoff frequency of the torque model's low-pass filter; not set: no filter [rad/s].
  std::optional<double> torque_cutoff;
  std::vector<ErrorTool> tools;       ///< Tools of the state.
  bool force_sensor;                  ///< Whether the forces at the tools are measured.
  std::vector<ContactSpec> supports;  ///< Supports, which are active in every stage.
  std::vector<ContactSpec> held;      ///< `supports`, followed by the loops of the robot.
  std::vector<std::string> measured;  ///< Frame of each column of ErrorInput::wrenches.
  StageContacts contacts;
  LoopTimes times;
};

/// Inputs of an ErrorEstimate at a valid measurement.
struct ErrorInput {
  const Measurement& measurement;
  /// Force of the surface on each tool, in world axes, 3 x tools [N]. Without a force sensor, this
  /// is the result of feel().
  const Eigen::Matrix3Xd& tool_forces_world;
  /// Measured wrenches at the frames ErrorEstimateSpec::measured, as in Measurement::wrenches.
  const Wrenches& wrenches;
  double dt;  ///< Time since the previous valid measurement [s]; 0 at the first one.
  /// Target of the normal force at each tool at the previous tick [N].
  const Eigen::VectorXd& target_forces;
  /// Torque command in effect until the measurement, before the filter of the torque model and
  /// without the compensation of joint friction; nv [Nm or N].
  ConstVectorRef sent;
  int stage;             ///< Stage of the schedule.
  double schedule_time;  ///< Time of the schedule [s].
  bool waits;            ///< True while the schedule waits for a late event, such as a contact.
};

class ErrorEstimate {
 public:
  /// `state`: a state whose contacts are those of `spec.contacts`, and whose tools are those of
  /// `spec.tools`. Without a force sensor, there must be one tool.
  ErrorEstimate(const ErrorEstimateSpec& spec, const RobotState& state);

  void reset() noexcept;
  /// Updates the estimate. If the dynamics cannot be evaluated, the estimate stays unchanged.
  void update(RobotState& state, const ErrorInput& input) noexcept;

  /// Returns true if the force at the tool is estimated by feel() instead of measured.
  bool feels() const { return felt_.has_value(); }
  /// Estimates the force at the tool, in world axes, 3 x 1 [N]. Without a force sensor, call it
  /// before update(), which receives the result as its input.
  const Eigen::Matrix3Xd& feel(RobotState& state, const ErrorInput& input) noexcept;
  /// Returns the estimate of contact forces, with the current surface and friction.
  ContactForceEstimate& contacts() { return contact_force_; }
  /// Sets the surface under a tool and its unit normal. The contacts of the tool in
  /// StageContacts::surfaces use this surface.
  void set_surface(std::size_t tool, const Quadric& surface,
                   const Eigen::Vector3d& normal_world) noexcept {
    tools_[tool].normal_world = normal_world;
    contact_force_.set_surface(tool, surface);
  }
  /// Sets only the unit normal of the surface under a tool, for a surface that has rotated.
  void set_normal(std::size_t tool, const Eigen::Vector3d& normal_world) noexcept {
    tools_[tool].normal_world = normal_world;
  }
  /// Returns the coefficient of friction of a tool's contacts; 0 without a friction model.
  double friction(std::size_t tool) const { return tools_[tool].friction.coefficient(); }

  /// Sets the planned velocity v (nv) [rad/s or m/s], whose direction the friction estimates use. v
  /// is the velocity of a new plan at joint_friction().lead() after the plan's first knot.
  void foresee(const Eigen::VectorXd& v) noexcept {
    joint_friction_.foresee(v.data());
    for (Tool& tool : tools_) tool.friction.foresee(v);
  }

  /// Returns the estimate of joint friction. The torques passed to update() must not include the
  /// compensation of joint friction.
  JointFriction& joint_friction() { return joint_friction_; }

  /// Returns the observer's torque error plus the joint torque of unmodelled friction; nv [Nm or
  /// N]. Unmodelled friction is the force along the surface minus the friction of the contact
  /// models.
  const Eigen::VectorXd& torque_error() const { return torque_error_; }
  /// Returns torque_error() without the friction at tools whose contacts have no friction model; nv
  /// [Nm or N].
  const Eigen::VectorXd& modelled_error() const { return modelled_error_; }
  /// Returns true if the contacts of a tool have a friction model.
  bool models_friction(std::size_t tool) const { return tools_[tool].friction.is_modelled(); }
  /// Returns the mean of torque_error() over the last seconds; nv [Nm or N].
  const Eigen::VectorXd& lasting_error() const { return lasting_error_; }
  /// Returns the filtered error of the normal force at each tool (measured minus modelled) [N].
  const Eigen::VectorXd& force_error() const { return force_error_; }
  /// Returns the measured minus the acting torque, low-pass filtered; nv [Nm or N].
  const Eigen::VectorXd& torque_offset() const { return torque_offset_; }
  /// Returns the estimated sum of the contact forces on each tool, in world axes, 3 x tools [N].
  const Eigen::Matrix3Xd& forces_world() const { return forces_world_; }
  /// Returns the torque to add to a command as force feedback; nv [Nm or N]. It is the error of the
  /// normal forces times force_gain, converted to joint torques.
  const Eigen::VectorXd& force_feedback() const { return force_feedback_; }

 private:
  /// State of the estimate at one tool.
  struct Tool {
    Eigen::Vector3d normal_world, normal_at_first;
    double contact_threshold;
    ToolFriction friction;
    double pressed_for = 0.0;  ///< Time for which the tool has pressed as commanded [s].
  };

  const Eigen::Matrix3Xd& observed_forces(const ErrorInput& input) noexcept;
  ToolForce tool_force(const ErrorInput& input, std::size_t tool) const noexcept {
    return {input.tool_forces_world.col(static_cast<Eigen::Index>(tool)),
            tools_[tool].normal_world};
  }
  const Eigen::VectorXd& model_error() const {
    return felt_ ? felt_->model_error() : observer_->torque_error();
  }
  double observer_bandwidth() const {  ///< Bandwidth of the observer in use [rad/s].
    return felt_ ? felt_->bandwidth() : observer_->bandwidth();
  }
  void follow_command(const ErrorInput& input) noexcept;
  void update_force_feedback(RobotState& state, const ErrorInput& input) noexcept;
  void follow_lasting(double dt) noexcept;
  void follow_friction(RobotState& state, const ErrorInput& input) noexcept;
  void follow_force_error(RobotState& state, const ErrorInput& input, double weight) noexcept;

  ModelErrorOptions options_;
  std::optional<double> torque_cutoff_;
  /// Observer for a robot with a force sensor (observer_), or estimate of force and torque error
  /// for a robot without a force sensor (felt_).
  std::optional<ErrorObserver> observer_;
  std::optional<FeltForce> felt_;
  JointFriction joint_friction_;
  std::vector<Tool> tools_;
  ContactForceEstimate contact_force_;
  /// Torque in the joints: the command, low-pass filtered with torque_cutoff_; nv [Nm or N].
  Eigen::VectorXd acted_;
  Eigen::VectorXd force_feedback_;
  Eigen::VectorXd torque_offset_, torque_error_, modelled_error_, lasting_error_, total_;
  double lasting_time_ = 0.0;  ///< Averaging time of lasting_error_ so far [s].
  double waits_for_ = 0.0;     ///< Time for which the schedule has waited for contact [s].
  bool started_ = false;       ///< True after the first measurement.
  /// Forces on the tools, 3 x tools [N]: estimated, for the observer, and of the model alone.
  Eigen::Matrix3Xd forces_world_, observed_, model_forces_;
  Eigen::VectorXd force_error_;
};

}  // namespace burnish
