#include "mpc/error_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "mpc/closed_dynamics.hpp"
#include "mpc/horizon.hpp"

namespace burnish {
namespace {

constexpr double sliding_speed = 0.02;  // m/s, below which friction fades
constexpr double until_torques = 2e-3;  // s, from a measurement
constexpr double since_forces = 3e-3;   // s, of sensors and their filters
constexpr double touch_fade = 0.2;      // s from a touch until all of the force gain counts
// s of waiting for contact until the force counts as a model error, and until all of it does
constexpr double waiting = 0.1, waiting_fade = 0.1;

}  // namespace

ErrorEstimate::ErrorEstimate(const MpcSpec& spec)
    : options_(spec.model_error),
      filter_(spec.problem.torque_model),
      normal_world_(spec.normal_world),
      normal_at_first_(spec.normal_world),
      contact_threshold_(spec.contact_threshold),
      observer_(spec.problem.model, spec.tool, spec.model_error, supports_of(spec),
                measured_frames(spec), spec.base),
      felt_(spec),
      joint_friction_(spec),
      has_sensor_(spec.force_sensor),
      contact_force_(spec),
      tool_motion_(RigidBody(spec.problem.model), spec.tool, spec.base) {
  const std::vector<int> rubbing = contacts_that_rub(spec);
  if (!rubbing.empty()) {
    friction_.emplace(spec.friction_estimate);
    planned_speed_ =
        spec.problem.contacts[static_cast<std::size_t>(rubbing.front())].friction->fade_speed();
  }
  known_delay_ = spec.command_delay + spec.measurement_delay;
  smoothing_ =
      joint_friction_.lead() + spec.solver_delay + 0.5 * spec.update_period - until_torques;
  acted_ = force_feedback_ = torque_offset_ = torque_error_ = lasting_error_ = total_ = v_ahead_ =
      Eigen::VectorXd::Zero(spec.problem.model.nv);
}

void ErrorEstimate::reset() noexcept {
  observer_.reset();
  felt_.reset();
  joint_friction_.reset();
  normal_world_ = normal_at_first_;
  acted_.setZero();
  force_feedback_.setZero();
  pressed_for_ = 0.0;
  torque_offset_.setZero();
  torque_error_.setZero();
  lasting_error_.setZero();
  since_ = waits_for_ = 0.0;
  friction_force_.setZero();
  v_ahead_.setZero();
  between_.setZero();
  v_tool_.setZero();
  slid_.setZero();
  force_world_.setZero();
  pressed_ = force_error_ = 0.0;
  if (friction_) friction_->reset();
}

const Eigen::Vector3d& ErrorEstimate::feel(const MeasurementGate& gate, const ConstVectorRef& acted,
                                           int stage) noexcept {
  follow_command(gate, acted);
  felt_.update(gate, acted_, !contact_force_.has_contact(stage));
  return felt_.force_world();
}

void ErrorEstimate::update(const MeasurementGate& gate, const Command& before,
                           const ConstVectorRef& acted, int stage, double schedule_time,
                           bool waits) noexcept {
  const Measurement& m = gate.last();
  const double share = -std::expm1(-options_.usual_bandwidth() * gate.dt());
  if (has_sensor_) follow_command(gate, acted);  // else it was, by feel()
  total_ = m.tau;
  if (options_.kind == ModelErrorKind::Torque) {
    // What cannot be evaluated changes nothing, of either estimate.
    const Eigen::Vector3d force = known_force(m, gate.dt(), waits);
    const Status seen =
        has_sensor_ ? observer_.update(m.q, m.v, acted_, force, gate.dt(), m.support_wrenches)
                    : Status::Ok;
    if (seen <= Status::NotConverged) {
      torque_offset_ += share * (m.tau - acted_ - torque_offset_);
      joint_friction_.learn(model_error(), m.v, observed_at(), gate.dt());
    }
    follow_friction(gate, before);
    push_back(gate, before);
    follow_lasting(gate.dt());
    contact_force_.set_friction(friction());
    // Section IV-C: at the measured torques. What the torque error knows of them counts once.
    total_ += model_error() - torque_offset_;
    total_.noalias() += tool_motion_.jacobian().transpose() * friction_force_;
  }
  if (options_.kind == ModelErrorKind::Force) follow_force_error(m, stage, schedule_time, share);
  (void)contact_force_.force_at(stage, schedule_time, m.q, m.v, total_, force_world_);
}

/// The force that the observer is given. A light arm that meets the surface slowly may rest on it
/// with less than what counts as contact, and its plans, which know of no surface there, push no
/// harder. While contact is due the force along the normal is therefore given as a model error:
/// the plans push against it until it is felt.
Eigen::Vector3d ErrorEstimate::known_force(const Measurement& m, double dt, bool waits) noexcept {
  waits_for_ = waits ? waits_for_ + dt : 0.0;
  const double hidden = std::clamp((waits_for_ - waiting) / waiting_fade, 0.0, 1.0);
  return m.tool_force_world - hidden * normal_force(m) * normal_world_;
}

/// What the model believes to act on the joints: the command that acted, behind the torque model's
/// filter if there is one. What is lost between motor and link, joint friction above all,
/// is to be known too, so that errors are told from the command and not from the torque sensors.
void ErrorEstimate::follow_command(const MeasurementGate& gate,
                                   const ConstVectorRef& acted) noexcept {
  if (!filter_) {
    acted_ = acted;
  } else if (gate.is_first()) {
    acted_ = gate.last().tau;
  } else {
    acted_ += -std::expm1(-filter_->cutoff * gate.dt()) * (acted - acted_);
  }
}

/// Friction is no error of its own: it goes with the normal force. Given back as measured it would
/// close a loop from the normal force through friction and the arm's inertia to itself, with the
/// observer's lag in it, which rings where pressing harder and sliding hang together (a light wrist
/// on a heavy arm). So what is kept is its ratio to the normal force, and what is given back is
/// that ratio times the force that is asked for.
void ErrorEstimate::follow_friction(const MeasurementGate& gate, const Command& before) noexcept {
  const Measurement& m = gate.last();
  const Eigen::Vector3d& n = normal_world_;
  const double bandwidth =
      options_.sliding_bandwidth > 0.0 ? options_.sliding_bandwidth : options_.usual_bandwidth();
  const double share = -std::expm1(-bandwidth * gate.dt());
  pressed_ += share * (normal_force(m) - pressed_);
  const Eigen::Vector3d across = m.tool_force_world - normal_force(m) * n;
  friction_force_ += share * (across - explained_friction(gate, across) - friction_force_);
  const double asked = std::max(before.target_force, 0.0);
  const bool presses = pressed_ > contact_threshold_;
  // What is larger than the normal force is no friction.
  const double ratio = presses ? asked / std::max(pressed_, friction_force_.norm()) : 0.0;
  tool_motion_.update(gate.body());
  const Eigen::Vector3d known = turned_friction(gate.dt(), bandwidth);
  torque_error_ = model_error();
  torque_error_.noalias() += ratio * (tool_motion_.jacobian().transpose() * known);
}

/// A force that is off is answered at once, in proportion; the observer, which takes that torque
/// for a command like any other, takes away what is left. After a touch it is faded in: an impact
/// is not to be answered.
void ErrorEstimate::push_back(const MeasurementGate& gate, const Command& before) noexcept {
  const double gain = has_sensor_ ? options_.usual_force_gain() : 0.0;
  const bool presses = pressed_ > contact_threshold_ && before.target_force > contact_threshold_;
  pressed_for_ = presses ? pressed_for_ + gate.dt() : 0.0;
  const double off = normal_force(gate.last()) - before.target_force;
  const double bounded = std::clamp(off, -options_.limit, options_.limit);
  const double share = gain * std::min(1.0, pressed_for_ / touch_fade);
  force_feedback_.noalias() =
      share * bounded * (tool_motion_.jacobian().transpose() * normal_world_);
}

/// The mean of the first seconds, and of the last ones from then on.
void ErrorEstimate::follow_lasting(double dt) noexcept {
  constexpr double memory = 2.0, first = 0.1;  // s
  since_ += dt;
  const double share = std::min(1.0, dt / std::clamp(since_, first, memory));
  lasting_error_ += share * (torque_error_ - lasting_error_);
}

/// What is measured of friction is late by the filters of forces and by the time until torques act.
/// What of it lies along the way that the tool slid by then is turned to the way that it will
/// slide. Both are of what plans foresee a while ahead, behind a filter that is late by the same
/// while: measured velocities would close a loop through friction.
Eigen::Vector3d ErrorEstimate::turned_friction(double dt, double bandwidth) noexcept {
  if (friction_) return friction_force_;  // plans know where it turns
  constexpr double least = 0.25;          // of slid_: slower than that nothing is known of friction
  const Eigen::Vector3d& n = normal_world_;
  const double share = -std::expm1(-2.0 * dt / smoothing_);
  between_ += share * (tool_motion_.jacobian() * v_ahead_ - between_);
  v_tool_ += share * (between_ - v_tool_);
  const Eigen::Vector3d will_slide = sliding_direction(v_tool_ - n * n.dot(v_tool_), sliding_speed);
  const double late = until_torques + since_forces + known_delay_ + 1.0 / bandwidth;
  slid_ += -std::expm1(-dt / late) * (will_slide - slid_);
  const double along =
      std::max(0.0, -friction_force_.dot(slid_)) / std::max(slid_.squaredNorm(), least);  // N
  return friction_force_ - along * (will_slide - slid_);
}

/// Of the force along the surface, what the contacts' own friction says, N: the same that plans
/// know. What the coefficient learns leaves the rest, whose sum with it stays what it was.
Eigen::Vector3d ErrorEstimate::explained_friction(const MeasurementGate& gate,
                                                  const Eigen::Vector3d& across) noexcept {
  if (!friction_) return Eigen::Vector3d::Zero();
  const double force = normal_force(gate.last());
  const Eigen::Vector3d v = tool_motion_.velocity(gate.body());
  const Eigen::Vector3d v_across = v - normal_world_ * normal_world_.dot(v);
  const Eigen::Vector3d s = sliding_direction(v_across, planned_speed_);
  const double known = friction_->coefficient();
  if (pressed_ > contact_threshold_) friction_->update(force, across, v_across, gate.dt());
  friction_force_ += (friction_->coefficient() - known) * pressed_ * s;
  return -friction_->coefficient() * force * s;
}

void ErrorEstimate::follow_force_error(const Measurement& m, int stage, double schedule_time,
                                       double share) noexcept {
  const bool pressed = normal_force(m) > contact_threshold_;
  double error = 0.0;
  if (pressed && contact_force_.has_contact(stage)) {
    Eigen::Vector3d model_force;
    if (!contact_force_.force_at(stage, schedule_time, m.q, m.v, acted_, model_force)) return;
    error = normal_force(m) - model_force.dot(normal_world_);
  }
  force_error_ += share * (error - force_error_);
  force_error_ = std::clamp(force_error_, -options_.limit, options_.limit);
}

}  // namespace burnish
