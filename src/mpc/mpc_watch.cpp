// Measurements, estimates and faults of an MpcController.
#include <algorithm>
#include <cmath>

#include "mpc/mpc_impl.hpp"

namespace burnish {

bool MpcController::Impl::well_formed(const Measurement& m) const noexcept {
  return std::isfinite(m.time) && m.q.size() == q_.size() && m.v.size() == v_.size() &&
         m.tau.size() == tau_.size() && m.q.allFinite() && m.v.allFinite() && m.tau.allFinite() &&
         m.tool_force_world.allFinite();
}

bool MpcController::Impl::accept(const Measurement& m) noexcept {
  if (!well_formed(m)) {
    // Time goes on as it should have, so that the policy does too.
    last_time_ += spec.tick_period;
    command_.status = Status::NotFinite;
    if (last_time_ - good_time_ > spec.limits.bad)
      raise(FaultKind::BadMeasurement, last_time_ - good_time_, spec.limits.bad);
    return false;
  }
  if (started_ && !(m.time > good_time_)) {
    last_time_ += spec.tick_period;
    command_.status = Status::NotEvaluated;
    if (last_time_ - good_time_ > spec.limits.stale)
      raise(FaultKind::StaleMeasurement, last_time_ - good_time_, spec.limits.stale);
    return false;
  }
  last_time_ = good_time_ = m.time;
  q_ = m.q;
  v_ = m.v;
  tau_ = m.tau;
  tool_force = m.tool_force_world;
  const Status status = body_.update(q_, v_);
  if (status > Status::NotConverged) {
    command_.status = status;
    raise(FaultKind::BadMeasurement, 0.0, spec.limits.bad);
    return false;
  }
  return true;
}

void MpcController::Impl::estimate(const Measurement& /*m*/) noexcept {
  const Eigen::Vector3d normal_part = normal_force() * spec.normal_world;
  // The commanded torque, not the measured one: what is lost between motor and link, joint friction
  // above all, is to be known too. `command_` is still that of the tick before.
  if (spec.model_error.kind == ModelErrorKind::Torque && started_)
    observer.update(q_, v_, command_.tau, normal_part, spec.tick_period);
  estimate_force();
  if (spec.model_error.kind != ModelErrorKind::Force) return;
  const bool held = in_contact_stage_[static_cast<std::size_t>(schedule.phase())] != 0 &&
                    normal_force() > spec.limits.contact_threshold;
  const double wanted =
      held ? normal_force() - command_.force_estimate_world.dot(spec.normal_world) : 0.0;
  const double share = 1.0 - std::exp(-spec.model_error.bandwidth * spec.tick_period);
  force_error += share * (wanted - force_error);
  force_error = std::clamp(force_error, -spec.model_error.limit, spec.model_error.limit);
}

void MpcController::Impl::estimate_force() noexcept {
  // Section IV-C: forward dynamics in contact at the measured torques, positions and velocities.
  command_.force_estimate_world.setZero();
  const int phase = schedule.phase();
  if (in_contact_stage_[static_cast<std::size_t>(phase)] == 0) return;
  const Stage& stage =
      spec.problem
          .stages[static_cast<std::size_t>(stage_of_phase_[static_cast<std::size_t>(phase)])];
  for (int c = 0; c < contact_.contacts().size(); ++c) {
    const std::string& name = contact_.contacts().contacts()[static_cast<std::size_t>(c)].spec.name;
    const bool active =
        std::find(stage.contacts.begin(), stage.contacts.end(), name) != stage.contacts.end();
    if (contact_.is_active(c) != active) contact_.set_active(c, active);
  }
  total_ = tau_;
  if (spec.model_error.kind == ModelErrorKind::Torque) total_ += observer.torque_error();
  if (contact_.forward(q_, v_, total_) > Status::NotConverged) return;
  for (int c = 0; c < contact_.contacts().size(); ++c)
    if (contact_.is_active(c))
      command_.force_estimate_world += contact_.wrench(c, Reference::centered()).head<3>();
}

void MpcController::Impl::watch(double dt) noexcept {
  watch_motion();
  watch_contact(dt, normal_force());
}

void MpcController::Impl::watch_motion() noexcept {
  const Model& model = problem.model();
  const SafetyLimits& limits = spec.limits;
  for (const Joint& joint : model.joints) {
    if (joint.kind != JointKind::Revolute && joint.kind != JointKind::Prismatic) continue;
    const double q = q_[joint.q_index];
    const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
    if (q < lower - limits.joint_margin) raise(FaultKind::OutOfRange, q, lower, joint.v_index);
    if (q > upper + limits.joint_margin) raise(FaultKind::OutOfRange, q, upper, joint.v_index);
    const double fastest = limits.joint_speed_ratio * model.velocity_limit[joint.v_index];
    if (std::abs(v_[joint.v_index]) > fastest)
      raise(FaultKind::SpeedLimit, std::abs(v_[joint.v_index]), fastest, joint.v_index);
  }
  const double speed = body_.velocity(tool_, FrameAxes::Centered).head<3>().norm();
  if (speed > limits.tool_speed) raise(FaultKind::SpeedLimit, speed, limits.tool_speed);
}

void MpcController::Impl::watch_contact(double dt, double force_normal) noexcept {
  const SafetyLimits& limits = spec.limits;
  const double force = tool_force.norm();
  if (force > limits.force) raise(FaultKind::ForceLimit, force, limits.force);
  const Phase phase = schedule.phases()[static_cast<std::size_t>(schedule.phase())].phase;
  if (phase == Phase::Reach && force_normal > limits.unexpected_force)
    raise(FaultKind::UnexpectedContact, force_normal, limits.unexpected_force);
  const bool wanted = phase == Phase::Ramp || phase == Phase::Track;
  lost_for_ = wanted && force_normal < limits.contact_threshold ? lost_for_ + dt : 0.0;
  if (lost_for_ > limits.contact_lost)
    raise(FaultKind::ContactLost, lost_for_, limits.contact_lost);
}

void MpcController::Impl::raise(FaultKind kind, double value, double limit, int joint) noexcept {
  if (fault.kind != FaultKind::None) return;
  fault.kind = kind;
  fault.time = last_time_;
  fault.value = value;
  fault.limit = limit;
  fault.joint = joint;
}

void MpcController::Impl::fall_back() noexcept {
  // At the last good state; after a bad measurement its velocity is the best guess there is.
  const Eigen::VectorXd& zero = bias_;
  bias_.setZero();
  if (gravity_.forward(q_, zero, zero) > Status::NotConverged) {
    command_.tau.setZero();
    return;
  }
  command_.tau = gravity_.bias();
  for (Eigen::Index k = 0; k < v_.size(); ++k)
    command_.tau[k] -= spec.fallback.damping * gravity_.mass_matrix()(k, k) * v_[k];
}

}  // namespace burnish
