#include "estimate/error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

// Tuning constants, chosen by hand.
constexpr double touch_fade = 0.2;  // time from a touch until the full force gain is used [s]
// While the schedule waits for contact, the normal force becomes a model error: delay of this
// change, and its duration [s].
constexpr double waiting = 0.1, waiting_fade = 0.1;

ToolFrictionSpec tool_friction_spec(const ErrorEstimateSpec& spec, double lead) {
  const ModelErrorOptions& options = spec.options;
  return {.bandwidth = options.sliding_bandwidth > 0.0 ? options.sliding_bandwidth
                                                       : options.usual_bandwidth(),
          .contact_threshold = spec.contact_threshold,
          .coefficient = spec.friction,
          .planned_speed = spec.planned_speed,
          .times = spec.times,
          .plan_lead = lead};
}

}  // namespace

ErrorEstimate::ErrorEstimate(const ErrorEstimateSpec& spec, const RobotState& state)
    : options_(spec.options),
      torque_cutoff_(spec.torque_cutoff),
      normal_world_(spec.normal_world),
      normal_at_first_(spec.normal_world),
      contact_threshold_(spec.contact_threshold),
      joint_friction_(spec.model, spec.options, spec.times, spec.held),
      tool_friction_(tool_friction_spec(spec, joint_friction_.lead()), spec.model.nv),
      contact_force_(spec.contacts) {
  if (spec.force_sensor)
    observer_.emplace(spec.model, spec.options, state, spec.supports, spec.measured);
  else
    felt_.emplace(spec.model, spec.options, state, spec.supports, spec.contact_threshold);
  acted_ = force_feedback_ = torque_offset_ = torque_error_ = lasting_error_ = total_ =
      Eigen::VectorXd::Zero(spec.model.nv);
}

void ErrorEstimate::reset() noexcept {
  started_ = false;
  if (observer_) observer_->reset();
  if (felt_) felt_->reset();
  joint_friction_.reset();
  tool_friction_.reset();
  normal_world_ = normal_at_first_;
  acted_.setZero();
  force_feedback_.setZero();
  pressed_for_ = 0.0;
  torque_offset_.setZero();
  torque_error_.setZero();
  lasting_error_.setZero();
  lasting_time_ = waits_for_ = 0.0;
  force_world_.setZero();
  force_error_ = 0.0;
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
    // force_at() receives measured torques plus the model error (section IV-C of Kleff et al.,
    // docs/frames.md). Without `torque_offset_`, the error would be relative to `acted_`.
    total_ += model_error() - torque_offset_;
    total_.noalias() += state.tool().jacobian().transpose() * tool_friction_.unmodelled_world();
  }
  if (options_.kind == ModelErrorKind::Force) follow_force_error(state, input, weight);
  (void)contact_force_.force_at(state, input.stage, input.schedule_time, total_, force_world_);
}

/// Returns the force for the observer. A light arm may rest on the surface with a force below the
/// contact threshold. Plans then assume free air and push no harder. While the schedule waits for
/// contact, the normal force is therefore withheld from the observer, which treats it as a model
/// error. Plans push against this error until the contact is detected.
Eigen::Vector3d ErrorEstimate::observed_force(const ErrorInput& input) noexcept {
  waits_for_ = input.waits ? waits_for_ + input.dt : 0.0;
  const double hidden = std::clamp((waits_for_ - waiting) / waiting_fade, 0.0, 1.0);
  return input.tool_force_world - hidden * tool_force(input).normal() * normal_world_;
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

/// Updates the friction along the surface, and the torque error.
void ErrorEstimate::follow_friction(RobotState& state, const ErrorInput& input) noexcept {
  tool_friction_.update(state, tool_force(input), input.target_force, input.dt);
  torque_error_ = model_error();
  torque_error_.noalias() += tool_friction_.feedforward_ratio() *
                             (state.tool().jacobian().transpose() * tool_friction_.ahead_world());
}

/// Updates the force feedback, which is proportional to the force error and acts without delay. The
/// observer treats this torque as part of the command and corrects the remaining error. After a
/// touch, the gain rises gradually, because the controller should not respond to the impact.
void ErrorEstimate::update_force_feedback(RobotState& state, const ErrorInput& input) noexcept {
  const double gain = observer_ ? options_.usual_force_gain() : 0.0;
  const bool presses = tool_friction_.presses() && input.target_force > contact_threshold_;
  pressed_for_ = presses ? pressed_for_ + input.dt : 0.0;
  const double error = tool_force(input).normal() - input.target_force;
  const double bounded = std::clamp(error, -options_.limit, options_.limit);
  const double faded_gain = gain * std::min(1.0, pressed_for_ / touch_fade);
  force_feedback_.noalias() =
      faded_gain * bounded * (state.tool().jacobian().transpose() * normal_world_);
}

/// Updates the mean of the torque error over the last seconds. At first, the mean covers the whole
/// time so far.
void ErrorEstimate::follow_lasting(double dt) noexcept {
  constexpr double memory = 2.0, first = 0.1;  // longest and shortest averaging time [s]
  lasting_time_ += dt;
  const double weight = std::min(1.0, dt / std::clamp(lasting_time_, first, memory));
  lasting_error_ += weight * (torque_error_ - lasting_error_);
}

void ErrorEstimate::follow_force_error(RobotState& state, const ErrorInput& input,
                                       double weight) noexcept {
  const bool pressed = tool_force(input).normal() > contact_threshold_;
  double error = 0.0;
  if (pressed && contact_force_.has_contact(input.stage)) {
    Eigen::Vector3d model_force;
    if (!contact_force_.force_at(state, input.stage, input.schedule_time, acted_, model_force))
      return;
    error = tool_force(input).normal() - model_force.dot(normal_world_);
  }
  force_error_ += weight * (error - force_error_);
  force_error_ = std::clamp(force_error_, -options_.limit, options_.limit);
}

}  // namespace burnish
