#include "mpc/sampled_loop.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "estimate/tool_motion.hpp"

namespace burnish {
namespace {

constexpr double max_step = 5e-4;  // longest step of the plant; simulations use this step [s]

/// Returns the response of a first-order low-pass filter to a unit step after `time` [s]. It is 1
/// for a cut-off of 0 (no filter).
double step_response(double cutoff, double time) {
  return cutoff > 0.0 ? -std::expm1(-cutoff * time) : 1.0;
}

int whole(double ratio) { return static_cast<int>(std::lround(ratio)); }

}  // namespace

std::vector<Eigen::MatrixXd*> LoopState::blocks() {
  std::vector<Eigen::MatrixXd*> all{
      &q,     &v,    &q_before,   &v_measured, &force, &force_measured, &v_observed,
      &error, &late, &plan_error, &command,    &motor, &acted,          &offset};
  for (Eigen::MatrixXd& entry : queue) all.push_back(&entry);
  return all;
}

SampledLoop::SampledLoop(const SampledLoopSpec& spec, const LoopChain& chain)
    : chain_(chain),
      observes_(spec.observes),
      feeds_back_(spec.feedback),
      tick_(spec.tick_period),
      ticks_(whole(spec.update_period / spec.tick_period)),
      steps_(static_cast<int>(std::ceil(tick_ / max_step - 1e-9))),
      dt_(tick_ / steps_),
      plan_delay_(whole(spec.solver_delay / spec.tick_period)),
      torque_cutoff_(spec.torque_cutoff),
      plan_(spec.plan),
      n_(spec.model.nv) {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n_);
  RigidBody body(spec.model);
  ContactDynamics dynamics(spec.model);
  if (!is_usable(body.update(spec.q, none)) ||
      !is_usable(dynamics.forward(spec.q, none, body.gravity_torque())) ||
      !is_usable(dynamics.forward_derivatives()))
    throw Error("margins: the dynamics at the start cannot be evaluated");
  M_ = dynamics.mass_matrix();
  Minv_ = dynamics.da_dtau();
  gravity_slope_ = dynamics.da_dq();
  J_ = Eigen::RowVectorXd::Zero(n_);
  if (!spec.presses) return;
  const ToolMotion tool(body, {spec.tool, {}});
  J_ = spec.normal_world.transpose() * tool.jacobian();
}

LoopState SampledLoop::identity(const Case& with) const {
  LoopState s;
  s.queue.resize(to_size(whole(chain_.command_delay / dt_) + with.delay_steps));
  const int observed = observes_ ? n_ : 0;
  const int filtered = plan_.layout.filtered > 0 ? n_ : 0;
  const int acted = observes_ ? filtered : 0;
  const bool presses = !J_.isZero();
  std::vector<int> rows{n_,
                        n_,
                        chain_.difference_velocity ? n_ : 0,
                        n_,
                        presses ? 1 : 0,
                        presses ? 1 : 0,
                        observed,
                        observed,
                        with.lag > 0.0 ? observed : 0,
                        plan_delay_ > 0 ? observed : 0,
                        n_,
                        chain_.torque_cutoff > 0.0 ? n_ : filtered,
                        acted,
                        acted};
  rows.resize(rows.size() + s.queue.size(), n_);
  int size = 0, at = 0;
  for (const int count : rows) size += count;
  std::size_t i = 0;
  for (Eigen::MatrixXd* block : s.blocks()) {
    *block = Eigen::MatrixXd::Zero(rows[i], size);
    block->middleCols(at, rows[i]).setIdentity();
    at += rows[i++];
  }
  return s;
}

void SampledLoop::measure(LoopState& s) const {
  s.force_measured += step_response(chain_.force_cutoff, tick_) * (s.force - s.force_measured);
  if (!chain_.difference_velocity) {
    s.v_measured = s.v;
    return;
  }
  const Eigen::MatrixXd difference = (s.q - s.q_before) / tick_;
  s.v_measured += step_response(chain_.velocity_cutoff, tick_) * (difference - s.v_measured);
  s.q_before = s.q;
}

/// Updates the observer with the linearized equations of ErrorEstimate and TorqueErrorObserver.
void SampledLoop::observe(LoopState& s, const Case& with) const {
  if (!observes_) return;
  if (plan_.layout.filtered > 0) {
    s.acted += step_response(torque_cutoff_, tick_) * (s.command - s.acted);
    s.offset += step_response(with.bandwidth, tick_) * (s.motor - s.acted - s.offset);
  }
  const double pole = std::exp(-with.bandwidth * tick_);
  Eigen::MatrixXd torque = M_ * (gravity_slope_ * s.q);
  torque += s.acted.rows() > 0 ? s.acted : s.command;
  if (s.late.rows() > 0) {
    s.late += step_response(1.0 / with.lag, tick_) * (torque - s.late);
    torque = s.late;
  }
  torque += s.error;
  if (s.force.rows() > 0) torque += J_.transpose() * s.force_measured;
  s.v_observed += tick_ * (Minv_ * torque);
  const Eigen::MatrixXd innovation = s.v_measured - s.v_observed;
  s.v_observed += (1.0 - pole * pole) * innovation;
  s.error += (1.0 - pole) * (1.0 - pole) / tick_ * (M_ * innovation);
}

/// Computes the command of a tick. `start`: initial state of the plan in use. The controller
/// predicts the state in which a plan comes into use, so that the plan starts in this state. If
/// plans come into use after a delay, a plan assumes plan_error, the torque error when its
/// computation began.
void SampledLoop::control(LoopState& s, int tick, double force_gain, Eigen::MatrixXd& start) const {
  const StateLayout& layout = plan_.layout;
  const int ndx = layout.ndx();
  Eigen::MatrixXd x(ndx, s.q.cols());
  x.topRows(n_) = s.q;
  x.middleRows(n_, n_) = s.v_measured;
  for (int i = 0; i < layout.filtered; ++i) {
    const int k = layout.actuated[to_size(i)];
    x.row(2 * n_ + i) = s.motor.row(k);
    if (observes_) x.row(2 * n_ + i) -= s.offset.row(k);
  }
  const int taken_over = plan_delay_ % ticks_;
  if (tick == taken_over || start.size() == 0) start = x;
  const double elapsed = tick_ * std::max(0, tick - taken_over);
  const auto K = plan_.u.leftCols(ndx);
  Eigen::MatrixXd u = K * start, change = plan_.change.leftCols(ndx) * start;
  if (observes_) {
    const Eigen::MatrixXd& error = plan_delay_ > 0 ? s.plan_error : s.error;
    u += plan_.u.rightCols(n_) * error;
    change += plan_.change.rightCols(n_) * error;
  }
  if (feeds_back_) u += K * (x - start - elapsed / plan_.step * change);
  if (tick == taken_over && plan_delay_ > 0) s.plan_error = s.error;
  s.command.setZero();
  for (int i = 0; i < layout.nu; ++i) {
    const int k = layout.actuated[to_size(i)];
    s.command.row(k) = u.row(i);
    if (s.force.rows() > 0) s.command.row(k) += force_gain * J_[k] * s.force_measured;
  }
}

/// Advances the plant by one step, with the surface's force at the end of the step (implicit).
void SampledLoop::move(LoopState& s, const Case& with) const {
  Eigen::MatrixXd torque = s.command;
  if (!s.queue.empty()) {
    torque = s.queue.front();
    std::rotate(s.queue.begin(), s.queue.begin() + 1, s.queue.end());
    s.queue.back() = s.command;
  }
  if (s.motor.rows() > 0) {
    s.motor += step_response(chain_.torque_cutoff, dt_) * (torque - s.motor);
    torque = s.motor;
  }
  if (with.entry >= 0) torque.row(with.entry) *= with.factor;
  s.v += dt_ * (Minv_ * torque + gravity_slope_ * s.q);
  if (s.force.rows() > 0) {
    const double resist = chain_.stiffness * dt_ + chain_.damping;
    const Eigen::VectorXd response = Minv_ * J_.transpose();
    s.force = -(chain_.stiffness * (J_ * s.q) + resist * (J_ * s.v)) /
              (1.0 + resist * dt_ * J_.dot(response));
    s.v += dt_ * response * s.force;
  }
  s.q += dt_ * s.v;
}

Eigen::MatrixXd SampledLoop::transition(const Case& with) const {
  LoopState s = identity(with);
  Eigen::MatrixXd start;
  for (int tick = 0; tick < ticks_; ++tick) {
    measure(s);
    observe(s, with);
    control(s, tick, with.force_gain, start);
    for (int i = 0; i < steps_; ++i) move(s, with);
  }
  Eigen::MatrixXd result(s.q.cols(), s.q.cols());
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd* block : s.blocks()) {
    result.middleRows(at, block->rows()) = *block;
    at += block->rows();
  }
  return result;
}

/// Returns the growth rate, computed by repeated squaring of the transition matrix: the norm of its
/// powers grows with the spectral radius.
double SampledLoop::growth(const Case& with) const {
  constexpr double duration = 20.0;  // time after which transients hardly affect the result [s]
  Eigen::MatrixXd power = transition(with), square;
  double time = ticks_ * tick_, log_of_scale = 0.0;
  while (time < duration) {
    const double scale = power.norm();
    if (!std::isfinite(scale) || scale == 0.0) break;
    power /= scale;
    square.noalias() = power * power;
    power.swap(square);
    log_of_scale = 2.0 * (log_of_scale + std::log(scale));
    time *= 2.0;
  }
  return (log_of_scale + std::log(power.norm())) / time;
}

}  // namespace burnish
