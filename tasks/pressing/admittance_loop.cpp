#include "pressing/admittance_loop.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/integration.hpp"
#include "sim/small_product.hpp"

namespace burnish::pressing {

AdmittanceLoop::AdmittanceLoop(const Model& model, const PressingPath& path,
                               const AdmittanceGains& gains, double period)
    : gains_(gains),
      period_(period),
      approach_speed_(path.approach_speed),
      tree_(model),
      body_(model),
      tool_(body_.frame(path.tool)),
      command_{model.q_neutral, Eigen::VectorXd::Zero(model.nv)},
      q_(model.q_neutral),
      zero_(Eigen::VectorXd::Zero(model.nv)),
      posture_(path.posture),
      velocity_limit_(model.velocity_limit),
      homing_(zero_),
      step_(zero_),
      inverse_M_Jt_(zero_),
      J_(Eigen::MatrixXd::Zero(3, model.nv)),
      factor_(model.nv) {
  body_.frame_derivatives(tool_, Reference::centered(), motion_);
}

Status AdmittanceLoop::reset(const Eigen::VectorXd& q) noexcept {
  force_.setZero();
  integral_ = speed_ = 0.0;
  const Status status = body_.update(q, zero_);
  if (!is_usable(status)) return status;
  q_ = command_.q = q;
  command_.v.setZero();
  return status;
}

void AdmittanceLoop::touch() noexcept { integral_ = speed_ = 0.0; }

Status AdmittanceLoop::step(const TaskPoint& target, const Eigen::Vector3d& force_world,
                            bool pressing, bool may_integrate,
                            const Eigen::MatrixXd& mass_matrix) noexcept {
  const Status status = body_.update(q_, zero_);
  if (!is_usable(status)) return status;
  body_.frame_derivatives(tool_, Reference::centered(), motion_);
  J_ = motion_.jacobian.topRows(3);
  force_ += (1.0 - std::exp(-gains_.force_cutoff * period_)) * (force_world - force_);
  const Eigen::Vector3d& n = target.normal_world;
  const Eigen::Vector3d error = target.p_world - body_.placement(tool_).translation();
  Eigen::Vector3d v_tool = target.v_world + gains_.path_gain * error;
  const double speed = pressing ? normal_speed(target, inertia_along(n, mass_matrix), may_integrate)
                                : -approach_speed_;
  v_tool += (speed - n.dot(v_tool)) * n;
  solve_joints(v_tool);
  if (!step_.allFinite()) return Status::NotFinite;
  command_.q = q_;
  command_.v = step_;
  step_ *= period_;
  integrate_configuration(tree_, command_.q.data(), step_.data(), q_.data());
  return Status::Ok;
}

/// Returns the effective mass of the tool along n, 1 / (n^T J M^-1 J^T n) [kg].
double AdmittanceLoop::inertia_along(const Eigen::Vector3d& n,
                                     const Eigen::MatrixXd& mass_matrix) noexcept {
  multiply(J_.transpose(), n, step_);
  inverse_M_Jt_ = step_;
  factor_.compute(mass_matrix);
  factor_.solveInPlace(inverse_M_Jt_);
  double inverse = 0.0;
  for (Eigen::Index i = 0; i < step_.size(); ++i) inverse += step_[i] * inverse_M_Jt_[i];
  return 1.0 / inverse;
}

/// Returns the next speed along the normal, by an implicit Euler step of the admittance, which is
/// stable for any damping.
double AdmittanceLoop::normal_speed(const TaskPoint& target, double inertia,
                                    bool may_integrate) noexcept {
  const double excess = force_.dot(target.normal_world) - target.force;
  if (may_integrate) {
    integral_ += gains_.ki * period_ * excess;
    integral_ = std::clamp(integral_, -gains_.integral_limit, gains_.integral_limit);
  }
  speed_ = (gains_.mass * speed_ + period_ * (excess + integral_) / inertia) /
           (gains_.mass + period_ * gains_.damping);
  return speed_;
}

/// Computes the joint velocities step_ [rad/s (m/s)] that move the tool with `v_tool`, by damped
/// least squares. In the null space of the tool's Jacobian, joints move towards `posture_`. If a
/// joint would exceed its velocity limit, all velocities are scaled down.
void AdmittanceLoop::solve_joints(const Eigen::Vector3d& v_tool) noexcept {
  difference_configuration(tree_, q_.data(), posture_.data(), homing_.data());
  homing_ *= gains_.posture_gain;
  Eigen::Matrix3d square;
  multiply(J_, J_.transpose(), square);
  square.diagonal().array() += gains_.ik_damping * gains_.ik_damping;
  damped_.compute(square);
  Eigen::Vector3d rest;
  multiply(J_, homing_, rest);
  rest = v_tool - rest;
  damped_.solveInPlace(rest);
  step_ = homing_;
  add_product(1.0, J_.transpose(), rest, step_);
  double slower = 1.0;
  for (Eigen::Index i = 0; i < step_.size(); ++i)
    if (velocity_limit_[i] > 0.0)
      slower = std::max(slower, std::abs(step_[i]) / velocity_limit_[i]);
  step_ /= slower;
}

}  // namespace burnish::pressing
