#include "estimate/error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Tuning constants, chosen by hand.
constexpr double sliding_speed = 0.02;  // speed below which the friction fades out [m/s]
constexpr double until_torques = 2e-3;  // assumed time from a measurement until torques act [s]
constexpr double since_forces = 3e-3;   // assumed delay of force sensors with their filters [s]
constexpr double touch_fade = 0.2;      // time from a touch until the full force gain is used [s]
// While the schedule waits for contact: time after which the normal force begins to count as a
// model error, and further time until the force counts in full [s].
constexpr double waiting = 0.1, waiting_fade = 0.1;

}  // namespace

ErrorEstimate::ErrorEstimate(const ErrorEstimateSpec& spec, const RobotState& state)
    : options_(spec.options),
      torque_cutoff_(spec.torque_cutoff),
      normal_world_(spec.normal_world),
      normal_at_first_(spec.normal_world),
      contact_threshold_(spec.contact_threshold),
      joint_friction_(spec.model, spec.options, spec.times, spec.held),
      contact_force_(spec.contacts),
      planned_speed_(spec.planned_speed) {
  if (spec.force_sensor)
    observer_.emplace(spec.model, spec.options, state, spec.supports, spec.measured);
  else
    felt_.emplace(spec.model, spec.options, state, spec.supports, spec.contact_threshold);
  if (spec.friction) friction_.emplace(*spec.friction);
  const LoopTimes& times = spec.times;
  nominal_delay_ = times.command_delay + times.measurement_delay;
  smoothing_ =
      joint_friction_.lead() + times.solver_delay + 0.5 * times.update_period - until_torques;
  acted_ = force_feedback_ = torque_offset_ = torque_error_ = lasting_error_ = total_ = v_ahead_ =
      Eigen::VectorXd::Zero(spec.model.nv);
}

void ErrorEstimate::reset() noexcept {
  started_ = false;
  if (observer_) observer_->reset();
  if (felt_) felt_->reset();
  joint_friction_.reset();
  normal_world_ = normal_at_first_;
  acted_.setZero();
  force_feedback_.setZero();
  pressed_for_ = 0.0;
  torque_offset_.setZero();
  torque_error_.setZero();
  lasting_error_.setZero();
  lasting_time_ = waits_for_ = 0.0;
  friction_force_.setZero();
  v_ahead_.setZero();
  between_.setZero();
  v_tool_.setZero();
  slid_.setZero();
  force_world_.setZero();
  pressed_ = force_error_ = 0.0;
  if (friction_) friction_->reset();
}

const Eigen::Vector3d& ErrorEstimate::feel(RobotState& state, const ErrorInput& input) noexcept {
  follow_command(input);
  felt_->update(state, acted_, input.dt, !contact_force_.has_contact(input.stage));
  return felt_->force_world();
}

void ErrorEstimate::update(RobotState& state, const ErrorInput& input) noexcept {
  const Measurement& m = input.measurement;
  const double weight = -std::expm1(-options_.usual_bandwidth() * input.dt);
  // Without a force sensor, feel() has already called follow_command().
  if (observer_) follow_command(input);
  total_ = m.tau;
  if (options_.kind == ModelErrorKind::Torque) {
    // If the dynamics cannot be evaluated, observer and estimate stay unchanged.
    const Eigen::Vector3d force = observed_force(input);
    const Status seen =
        observer_ ? observer_->update(state, acted_, force, input.dt, input.wrenches) : Status::Ok;
    if (is_usable(seen)) {
      torque_offset_ += weight * (m.tau - acted_ - torque_offset_);
      joint_friction_.learn(model_error(), m.v, observer_bandwidth(), input.dt);
    }
    follow_friction(state, input);
    update_force_feedback(state, input);
    follow_lasting(input.dt);
    contact_force_.set_friction(friction());
    // force_at() uses the measured torques (section IV-C of Kleff et al.). The torque error already
    // contains torque_offset_, the slow difference of these torques from acted_.
    total_ += model_error() - torque_offset_;
    total_.noalias() += state.tool().jacobian().transpose() * friction_force_;
  }
  if (options_.kind == ModelErrorKind::Force) follow_force_error(state, input, weight);
  (void)contact_force_.force_at(state, input.stage, input.schedule_time, total_, force_world_);
}

/// Returns the force for the observer. A light arm that touches the surface slowly may rest on it
/// with a force below the contact threshold. In this case, plans do not yet contain the surface and
/// push no harder. While contact is due, the observer therefore does not receive the normal force
/// and treats it as a model error. Plans push against this error until the contact is detected.
Eigen::Vector3d ErrorEstimate::observed_force(const ErrorInput& input) noexcept {
  waits_for_ = input.waits ? waits_for_ + input.dt : 0.0;
  const double hidden = std::clamp((waits_for_ - waiting) / waiting_fade, 0.0, 1.0);
  return input.tool_force_world - hidden * normal_force(input) * normal_world_;
}

/// Updates the torque that acts on the joints. It is the command, low-pass filtered if there is a
/// torque model. Torque errors are relative to the command rather than to torque sensors, so that
/// they include losses between motor and link, such as joint friction.
void ErrorEstimate::follow_command(const ErrorInput& input) noexcept {
  if (!torque_cutoff_) {
    acted_ = input.sent;
  } else if (!started_) {
    acted_ = input.measurement.tau;
  } else {
    acted_ += -std::expm1(-*torque_cutoff_ * input.dt) * (input.sent - acted_);
  }
  started_ = true;
}

/// Updates the friction along the surface, and the torque error. Feedback of the measured friction
/// would close a loop through normal force, friction, the inertia of the arm and the lag of the
/// observer. This loop rings if pressing and sliding are coupled in the arm, as with a light wrist
/// on a heavy arm. The estimate is therefore the ratio of friction to normal force. The feedback is
/// this ratio times the target force.
void ErrorEstimate::follow_friction(RobotState& state, const ErrorInput& input) noexcept {
  const Eigen::Vector3d& n = normal_world_;
  const double bandwidth =
      options_.sliding_bandwidth > 0.0 ? options_.sliding_bandwidth : options_.usual_bandwidth();
  const double weight = -std::expm1(-bandwidth * input.dt);
  pressed_ += weight * (normal_force(input) - pressed_);
  const Eigen::Vector3d across = input.tool_force_world - normal_force(input) * n;
  friction_force_ += weight * (across - explained_friction(state, input, across) - friction_force_);
  const double target = std::max(input.target_force, 0.0);
  const bool presses = pressed_ > contact_threshold_;
  // The part of a tangential force that exceeds the normal force does not count as friction.
  const double ratio = presses ? target / std::max(pressed_, friction_force_.norm()) : 0.0;
  const ToolMotion& tool = state.tool();
  const Eigen::Vector3d friction = friction_along_plan(tool, input.dt, bandwidth);
  torque_error_ = model_error();
  torque_error_.noalias() += ratio * (tool.jacobian().transpose() * friction);
}

/// Updates the force feedback, which is proportional to the force error and acts without delay. The
/// observer treats this torque as part of the command and corrects the remaining error. After a
/// touch, the gain rises gradually, because the controller should not respond to the impact.
void ErrorEstimate::update_force_feedback(RobotState& state, const ErrorInput& input) noexcept {
  const double gain = observer_ ? options_.usual_force_gain() : 0.0;
  const bool presses = pressed_ > contact_threshold_ && input.target_force > contact_threshold_;
  pressed_for_ = presses ? pressed_for_ + input.dt : 0.0;
  const double error = normal_force(input) - input.target_force;
  const double bounded = std::clamp(error, -options_.limit, options_.limit);
  const double faded_gain = gain * std::min(1.0, pressed_for_ / touch_fade);
  force_feedback_.noalias() =
      faded_gain * bounded * (state.tool().jacobian().transpose() * normal_world_);
}

/// Updates the average of the torque error: at first over the whole time, later over the last
/// seconds.
void ErrorEstimate::follow_lasting(double dt) noexcept {
  constexpr double memory = 2.0, first = 0.1;  // longest and shortest averaging time [s]
  lasting_time_ += dt;
  const double weight = std::min(1.0, dt / std::clamp(lasting_time_, first, memory));
  lasting_error_ += weight * (torque_error_ - lasting_error_);
}

/// Returns the estimated friction, rotated from the past to the future sliding direction. The
/// estimate is old by the delay of the force filters and by the time until torques act. The part
/// along the past sliding direction is therefore rotated to the direction in which the tool will
/// slide. Both directions come from planned velocities; the past one is delayed like the force.
/// Measured velocities would close a loop through friction.
Eigen::Vector3d ErrorEstimate::friction_along_plan(const ToolMotion& tool, double dt,
                                                   double bandwidth) noexcept {
  if (friction_) return friction_force_;  // plans already contain the change of direction
  // Lower bound of |slid_|^2. A shorter slid_ belongs to a slow motion, in which the direction of
  // friction is uncertain.
  constexpr double min_squared_slide = 0.25;
  const Eigen::Vector3d& n = normal_world_;
  const double weight = -std::expm1(-2.0 * dt / smoothing_);
  between_ += weight * (tool.jacobian() * v_ahead_ - between_);
  v_tool_ += weight * (between_ - v_tool_);
  const Eigen::Vector3d will_slide = sliding_direction(v_tool_ - n * n.dot(v_tool_), sliding_speed);
  const double delay = until_torques + since_forces + nominal_delay_ + 1.0 / bandwidth;
  slid_ += -std::expm1(-dt / delay) * (will_slide - slid_);
  const double along = std::max(0.0, -friction_force_.dot(slid_)) /
                       std::max(slid_.squaredNorm(), min_squared_slide);  // force [N]
  return friction_force_ - along * (will_slide - slid_);
}

/// Returns the part of the force along the surface that the friction model of the contacts explains
/// [N]. Plans already contain this part. When the coefficient changes, friction_force_ is corrected
/// so that its sum with the explained part stays the same.
Eigen::Vector3d ErrorEstimate::explained_friction(RobotState& state, const ErrorInput& input,
                                                  const Eigen::Vector3d& across) noexcept {
  if (!friction_) return Eigen::Vector3d::Zero();
  const double force = normal_force(input);
  const Eigen::Vector3d v = state.tool().velocity(state.body());
  const Eigen::Vector3d v_across = v - normal_world_ * normal_world_.dot(v);
  const Eigen::Vector3d s = sliding_direction(v_across, planned_speed_);
  const double before = friction_->coefficient();
  if (pressed_ > contact_threshold_) friction_->update(force, across, v_across, input.dt);
  friction_force_ += (friction_->coefficient() - before) * pressed_ * s;
  return -friction_->coefficient() * force * s;
}

void ErrorEstimate::follow_force_error(RobotState& state, const ErrorInput& input,
                                       double weight) noexcept {
  const bool pressed = normal_force(input) > contact_threshold_;
  double error = 0.0;
  if (pressed && contact_force_.has_contact(input.stage)) {
    Eigen::Vector3d model_force;
    if (!contact_force_.force_at(state, input.stage, input.schedule_time, acted_, model_force))
      return;
    error = normal_force(input) - model_force.dot(normal_world_);
  }
  force_error_ += weight * (error - force_error_);
  force_error_ = std::clamp(force_error_, -options_.limit, options_.limit);
}

}  // namespace burnish
