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

ToolFrictionSpec tool_friction_spec(const ErrorEstimateSpec& spec, const ErrorTool& tool,
                                    double lead) {
  const ModelErrorOptions& options = spec.options;
  return {.bandwidth = options.sliding_bandwidth > 0.0 ? options.sliding_bandwidth
                                                       : options.usual_bandwidth(),
          .contact_threshold = tool.contact_threshold,
          .coefficient = tool.friction,
          .planned_speed = tool.planned_speed,
          .times = spec.times,
          .plan_lead = lead};
}

}  // namespace

ErrorEstimate::ErrorEstimate(const ErrorEstimateSpec& spec, const RobotState& state)
    : options_(spec.options),
      torque_cutoff_(spec.torque_cutoff),
      joint_friction_(spec.model, spec.options, spec.times, spec.held),
      contact_force_(spec.contacts, spec.tools.size()) {
  for (const ErrorTool& tool : spec.tools)
    tools_.push_back(
        {.normal_world = tool.normal_world,
         .normal_at_first = tool.normal_world,
         .contact_threshold = tool.contact_threshold,
         .friction = {tool_friction_spec(spec, tool, joint_friction_.lead()), spec.model.nv}});
  if (spec.force_sensor)
    observer_.emplace(spec.model, spec.options, state, spec.supports, spec.measured);
  else
    felt_.emplace(spec.model, spec.options, state, spec.supports,
                  spec.tools.front().contact_threshold);
  acted_ = force_feedback_ = torque_offset_ = torque_error_ = modelled_error_ = lasting_error_ =
      total_ = Eigen::VectorXd::Zero(spec.model.nv);
  const auto count = static_cast<Eigen::Index>(tools_.size());
  forces_world_ = observed_ = model_forces_ = Eigen::Matrix3Xd::Zero(3, count);
  force_error_ = Eigen::VectorXd::Zero(count);
}

void ErrorEstimate::reset() noexcept {
  started_ = false;
  if (observer_) observer_->reset();
  if (felt_) felt_->reset();
  joint_friction_.reset();
  for (Tool& tool : tools_) {
    tool.friction.reset();
    tool.normal_world = tool.normal_at_first;
    tool.pressed_for = 0.0;
  }
  acted_.setZero();
  force_feedback_.setZero();
  torque_offset_.setZero();
  torque_error_.setZero();
  modelled_error_.setZero();
  lasting_error_.setZero();
  lasting_time_ = waits_for_ = 0.0;
  forces_world_.setZero();
  force_error_.setZero();
}

const Eigen::Matrix3Xd& ErrorEstimate::feel(RobotState& state, const ErrorInput& input) noexcept {
  follow_command(input);
  felt_->update(state, acted_, input.dt, !contact_force_.has_contact(input.stage, 0));
  return felt_->forces_world();
}

void ErrorEstimate::update(RobotState& state, const ErrorInput& input) noexcept {
  const Measurement& m = input.measurement;
  const double weight = -std::expm1(-options_.usual_bandwidth() * input.dt);
  // Without a force sensor, feel() has already called follow_command().
  if (observer_) follow_command(input);
  total_ = m.tau;
  if (options_.kind == ModelErrorKind::Torque) {
    // If the dynamics cannot be evaluated, observer and estimate stay unchanged.
    const Status seen = observer_ ? observer_->update(state, acted_, observed_forces(input),
                                                      input.dt, input.wrenches)
                                  : Status::Ok;
    if (is_usable(seen)) {
      torque_offset_ += weight * (m.tau - acted_ - torque_offset_);
      joint_friction_.learn(model_error(), m.v, observer_bandwidth(), input.dt);
    }
    follow_friction(state, input);
    update_force_feedback(state, input);
    follow_lasting(input.dt);
    // forces_at() receives measured torques plus the model error (section IV-C of Kleff et al.,
    // docs/frames.md). Without `torque_offset_`, the error would be relative to `acted_`.
    total_ += model_error() - torque_offset_;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      contact_force_.set_friction(i, friction(i));
      total_.noalias() +=
          state.tools()[i].jacobian().transpose() * tools_[i].friction.unmodelled_world();
    }
  }
  if (options_.kind == ModelErrorKind::Force) follow_force_error(state, input, weight);
  (void)contact_force_.forces_at(state, input.stage, input.schedule_time, total_, forces_world_);
}

/// Returns the forces for the observer. A light arm may rest on the surface with a force below the
/// contact threshold. Plans then assume free air and push no harder. While the schedule waits for
/// contact, the normal force of a tool without contact in the plan is therefore withheld from the
/// observer, which treats it as a model error. Plans push against this error until the contact is
/// detected.
const Eigen::Matrix3Xd& ErrorEstimate::observed_forces(const ErrorInput& input) noexcept {
  waits_for_ = input.waits ? waits_for_ + input.dt : 0.0;
  const double hidden = std::clamp((waits_for_ - waiting) / waiting_fade, 0.0, 1.0);
  observed_ = input.tool_forces_world;
  if (hidden == 0.0) return observed_;
  for (std::size_t i = 0; i < tools_.size(); ++i)
    if (!contact_force_.has_contact(input.stage, i))
      observed_.col(static_cast<Eigen::Index>(i)) -=
          hidden * tool_force(input, i).normal() * tools_[i].normal_world;
  return observed_;
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

/// Updates the friction along the surfaces, and the torque error.
void ErrorEstimate::follow_friction(RobotState& state, const ErrorInput& input) noexcept {
  torque_error_ = modelled_error_ = model_error();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const ToolMotion& motion = state.tools()[i];
    ToolFriction& friction = tools_[i].friction;
    friction.update(state.body(), motion, tool_force(input, i),
                    input.target_forces[static_cast<Eigen::Index>(i)], input.dt);
    const auto torque =
        friction.feedforward_ratio() * (motion.jacobian().transpose() * friction.ahead_world());
    torque_error_.noalias() += torque;
    if (friction.is_modelled()) modelled_error_.noalias() += torque;
  }
}

/// Updates the force feedback, which is proportional to the force errors and acts without delay.
/// The observer treats this torque as part of the command and corrects the remaining error. After a
/// touch, the gain rises gradually, because the controller should not respond to the impact.
void ErrorEstimate::update_force_feedback(RobotState& state, const ErrorInput& input) noexcept {
  const double gain = observer_ ? options_.usual_force_gain() : 0.0;
  force_feedback_.setZero();
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    Tool& tool = tools_[i];
    const double target = input.target_forces[static_cast<Eigen::Index>(i)];
    const bool presses = tool.friction.presses() && target > tool.contact_threshold;
    tool.pressed_for = presses ? tool.pressed_for + input.dt : 0.0;
    const double error = tool_force(input, i).normal() - target;
    const double bounded = std::clamp(error, -options_.limit, options_.limit);
    const double faded_gain = gain * std::min(1.0, tool.pressed_for / touch_fade);
    force_feedback_.noalias() +=
        faded_gain * bounded * (state.tools()[i].jacobian().transpose() * tool.normal_world);
  }
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
  const auto presses = [&](std::size_t tool) {
    return tool_force(input, tool).normal() > tools_[tool].contact_threshold &&
           contact_force_.has_contact(input.stage, tool);
  };
  bool any_presses = false;
  for (std::size_t i = 0; i < tools_.size(); ++i) any_presses = any_presses || presses(i);
  if (any_presses &&
      !contact_force_.forces_at(state, input.stage, input.schedule_time, acted_, model_forces_))
    return;
  for (std::size_t i = 0; i < tools_.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    const double error = presses(i) ? tool_force(input, i).normal() -
                                          model_forces_.col(column).dot(tools_[i].normal_world)
                                    : 0.0;
    double& estimate = force_error_[column];
    estimate += weight * (error - estimate);
    estimate = std::clamp(estimate, -options_.limit, options_.limit);
  }
}

}  // namespace burnish
