// Measurements, estimates and faults of an MpcController.
#include <algorithm>
#include <cmath>

#include "mpc/mpc_impl.hpp"

namespace burnish {

bool MpcController::Impl::take_state(const Measurement& m) noexcept {
  if (m.q.size() != q_.size() || m.v.size() != v_.size()) return false;
  if (body_.update(m.q, m.v) > Status::NotConverged) return false;
  q_ = m.q;
  v_ = m.v;
  return true;
}

bool MpcController::Impl::accept(const Measurement& m) noexcept {
  const SafetyLimits& limits = spec.limits;
  const bool stands_still = started_ && m.time <= good_time_;
  if (fault.kind != FaultKind::None) {
    // The fallback makes do with a position and a velocity.
    last_time_ += spec.tick_period;
    if (stands_still || !take_state(m)) return false;
    if (std::isfinite(m.time)) good_time_ = m.time;
    return true;
  }
  if (stands_still) {
    bridge(FaultKind::StaleMeasurement, Status::NotEvaluated, limits.stale);
    return false;
  }
  const double gap = started_ ? m.time - good_time_ : 0.0;
  const bool forces =
      m.tau.size() == tau_.size() && m.tau.allFinite() && m.tool_force_world.allFinite();
  if (!std::isfinite(m.time) || !forces || !take_state(m)) {
    bridge(FaultKind::BadMeasurement, Status::NotFinite, limits.bad);
    return false;
  }
  tau_ = m.tau;
  tool_force = m.tool_force_world;
  last_time_ = good_time_ = m.time;
  if (gap > limits.stale) raise(FaultKind::StaleMeasurement, gap, limits.stale);
  return true;
}

/// Time goes on as it should have, so that the policy does too.
void MpcController::Impl::bridge(FaultKind kind, Status status, double limit) noexcept {
  last_time_ += spec.tick_period;
  command_.status = status;
  const double missing = last_time_ - good_time_;
  if (missing > limit + 0.01 * spec.tick_period) raise(kind, missing, limit);
}

void MpcController::Impl::average_force() noexcept {
  forces_.col(forces_count_ % forces_.cols()) = tool_force;
  ++forces_count_;
  const Eigen::Index count = std::min<Eigen::Index>(forces_count_, forces_.cols());
  mean_force_ = forces_.leftCols(count).rowwise().sum() / static_cast<double>(count);
}

/// Nothing touches in the reach. Where there is none, the approach shows the noise.
void MpcController::Impl::feel_contact() noexcept {
  const Phase phase = schedule.phases()[static_cast<std::size_t>(schedule.phase())].phase;
  const bool in_air = phase == Phase::Reach || (phase == Phase::Approach && !touch_.knows_noise());
  touch_.add(normal_force(), in_air);
}

/// What the model believes to act on the joints: the command of the tick before, behind the torque
/// model's filter if there is one. What is lost between motor and link, joint friction above all,
/// is to be known too, so that errors are told from the command and not from the torque sensors.
void MpcController::Impl::follow_command(double dt) noexcept {
  const auto& filter = spec.problem.torque_model;
  if (!filter) {
    acted_ = command_.tau;
  } else if (!started_) {
    acted_ = tau_;
  } else {
    acted_ += -std::expm1(-filter->cutoff * dt) * (command_.tau - acted_);
  }
}

void MpcController::Impl::estimate(double dt) noexcept {
  const ModelErrorKind kind = spec.model_error.kind;
  const double share = -std::expm1(-spec.model_error.bandwidth * dt);
  follow_command(dt);
  total_ = tau_;
  if (kind == ModelErrorKind::Torque) {
    // What cannot be evaluated changes nothing, of either estimate.
    const Status seen = observer.update(q_, v_, acted_, tool_force, dt);
    if (seen <= Status::NotConverged) torque_offset_ += share * (tau_ - acted_ - torque_offset_);
    follow_friction(share);
    // Section IV-C: at the measured torques. What the torque error knows of them counts once.
    total_ += observer.torque_error() - torque_offset_;
    total_.noalias() += tool_motion_.jacobian.topRows(3).transpose() * friction_force_;
  }
  if (kind == ModelErrorKind::Force) estimate_force_error(share);
  (void)force_at(total_, command_.force_estimate_world);
}

/// Friction is no error of its own: it goes with the normal force. Given back as measured it would
/// close a loop from the normal force through friction and the arm's inertia to itself, with the
/// observer's lag in it, which rings where pressing harder and sliding hang together (a light wrist
/// on a heavy arm). So what is kept is its ratio to the normal force, and what is given back is
/// that ratio times the force that is asked for.
void MpcController::Impl::follow_friction(double share) noexcept {
  const Eigen::Vector3d& n = spec.normal_world;
  pressed_ += share * (normal_force() - pressed_);
  friction_force_ += share * (tool_force - normal_force() * n - friction_force_);
  const double asked = std::max(command_.target_force, 0.0);
  const bool presses = pressed_ > spec.limits.contact_threshold;
  // What is larger than the normal force is no friction.
  const double ratio = presses ? asked / std::max(pressed_, friction_force_.norm()) : 0.0;
  body_.frame_derivatives(tool_, FrameAxes::Centered, tool_motion_);
  torque_error = observer.torque_error();
  torque_error.noalias() +=
      ratio * (tool_motion_.jacobian.topRows(3).transpose() * friction_force_);
}

void MpcController::Impl::estimate_force_error(double share) noexcept {
  const bool pressed = normal_force() > spec.limits.contact_threshold;
  double error = 0.0;
  if (pressed && has_contact(schedule.phase())) {
    Eigen::Vector3d model_force;
    if (!force_at(acted_, model_force)) return;
    error = normal_force() - model_force.dot(spec.normal_world);
  }
  force_error += share * (error - force_error);
  force_error = std::clamp(force_error, -spec.model_error.limit, spec.model_error.limit);
}

/// Force of the phase's contacts by forward dynamics at these torques (nv): N, world axes. False
/// and zero where the phase has no contact or the dynamics no solution.
bool MpcController::Impl::force_at(const Eigen::VectorXd& tau, Eigen::Vector3d& out) noexcept {
  out.setZero();
  const int phase = schedule.phase();
  if (!has_contact(phase)) return false;
  const std::vector<char>& holds = holds_[static_cast<std::size_t>(phase)];
  for (int c = 0; c < static_cast<int>(holds.size()); ++c) {
    const bool active = holds[static_cast<std::size_t>(c)] != 0;
    if (contact_.is_active(c) != active) contact_.set_active(c, active);
  }
  if (contact_.forward(q_, v_, tau) > Status::NotConverged) return false;
  for (int c = 0; c < static_cast<int>(holds.size()); ++c)
    if (contact_.is_active(c)) out += contact_.wrench(c, Reference::centered()).head<3>();
  return true;
}

void MpcController::Impl::watch(double dt) noexcept {
  watch_motion();
  const SafetyLimits& limits = spec.limits;
  const Phase phase = schedule.phases()[static_cast<std::size_t>(schedule.phase())].phase;
  watch_free_space(phase, dt);
  watch_approach(dt);
  const double force = mean_force_.norm();
  if (force > limits.force) raise(FaultKind::ForceLimit, force, limits.force);
  const bool wanted = phase == Phase::Ramp || phase == Phase::Track;
  const bool lost = wanted && touch_.is_lost(command_.target_force);
  lost_for_ = lost ? lost_for_ + dt : 0.0;
  if (lost_for_ > limits.contact_lost)
    raise(FaultKind::ContactLost, lost_for_, limits.contact_lost);
}

/// Where no force is wanted. A retreat begins pressed: it is free space once the tool is off.
void MpcController::Impl::watch_free_space(Phase phase, double dt) noexcept {
  const SafetyLimits& limits = spec.limits;
  const double pushed = mean_force_.dot(spec.normal_world);
  const bool retreats = phase == Phase::Retreat;
  retreats_for_ = retreats ? retreats_for_ + dt : 0.0;
  released_ = retreats &&
              (released_ || pushed < limits.contact_threshold || retreats_for_ > limits.release);
  const auto samples = static_cast<int>(forces_.cols());
  const double least = touch_.above_noise(limits.unexpected_force, samples);
  if ((phase == Phase::Reach || released_) && forces_count_ >= samples && pushed > least)
    raise(FaultKind::UnexpectedContact, pushed, least);
}

/// Where contact is due and does not come.
void MpcController::Impl::watch_approach(double dt) noexcept {
  const bool waited = waits_for_ > 0.0;
  waits_for_ = schedule.waits() ? waits_for_ + dt : 0.0;
  if (!schedule.waits()) return;
  const double height = body_.placement(tool_).translation().dot(spec.normal_world);
  if (!waited) due_height_ = height;
  const SafetyLimits& limits = spec.limits;
  const double travel = due_height_ - height;
  if (travel > limits.late_contact_travel)
    raise(FaultKind::NoContact, travel, limits.late_contact_travel);
  if (waits_for_ > limits.late_contact_time)
    raise(FaultKind::ContactLate, waits_for_, limits.late_contact_time);
}

void MpcController::Impl::watch_motion() noexcept {
  const Model& model = problem.model();
  const SafetyLimits& limits = spec.limits;
  for (const Joint& joint : model.joints) {
    for (int k = joint.v_index; k < joint.v_index + joint.nv; ++k) {
      const double fastest = limits.joint_speed_ratio * model.velocity_limit[k];
      if (std::abs(v_[k]) > fastest) raise(FaultKind::SpeedLimit, std::abs(v_[k]), fastest, k);
    }
    if (joint.nq != 1) continue;
    const double q = q_[joint.q_index];
    const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
    if (q < lower - limits.joint_margin) raise(FaultKind::OutOfRange, q, lower, joint.v_index);
    if (q > upper + limits.joint_margin) raise(FaultKind::OutOfRange, q, upper, joint.v_index);
  }
  const double speed = body_.velocity(tool_, FrameAxes::Centered).head<3>().norm();
  if (speed > limits.tool_speed) raise(FaultKind::SpeedLimit, speed, limits.tool_speed);
}

void MpcController::Impl::raise(FaultKind kind, double value, double limit, int joint) noexcept {
  if (fault.kind != FaultKind::None) return;
  fault.kind = kind;
  fault.time = last_time_;
  fault.value = value;
  fault.limit = limit;
  fault.joint = joint;
}

}  // namespace burnish
