#include "mpc/delayed_state.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/integration.hpp"
#include "dynamics/tree.hpp"

namespace burnish {
namespace {

// Approximate length of an integration step [s]; chosen by hand. The prediction assumes that no
// contact begins or ends within a step.
constexpr double integration_step = 1e-3;

int ticks_of(double delay, double tick_period) {
  return static_cast<int>(std::lround(delay / tick_period));
}

}  // namespace

DelayedState::DelayedState(const ProblemSpec& problem, const LoopTimes& times, double stale,
                           std::size_t tools)
    : tick_period_(times.tick_period),
      lead_(times.ticks_in(times.command_delay) * times.tick_period),
      ticks_(times.delay_ticks()),
      per_step_(std::max(1, times.ticks_in(integration_step))),
      max_ticks_(ticks_ == 0 ? 0 : ticks_ + times.ticks_in(std::min(stale, 0.1))),
      nq_(problem.model.nq),
      nv_(problem.model.nv),
      filter_(problem.torque_model ? std::exp(-problem.torque_model->cutoff * times.tick_period)
                                   : 0.0),
      tree_(std::make_unique<const Tree>(problem.model)),
      sent_(nv_, ticks_),
      effective_(nv_, max_ticks_),
      holds_(tools) {
  for (const Joint& joint : problem.model.joints)
    if (joint.kind != JointKind::FreeFlyer && !joint.follows)
      for (int k = 0; k < joint.nv; ++k) actuated_.push_back(joint.v_index + k);
  start_ = problem.initial_state;
  tau_ = total_ = dq_ = felt_ = Eigen::VectorXd::Zero(nv_);
}

DelayedState::~DelayedState() = default;

void DelayedState::reset() noexcept {
  tau_.setZero();
  sent_.fill(tau_);
  effective_.fill(tau_);
  started_ = false;
}

void DelayedState::send(const Eigen::VectorXd& tau, const Eigen::VectorXd& friction) noexcept {
  tau_ = tau - friction;
  if (started_) {
    sent_.add(tau);
    effective_.add(tau_);
  } else {
    sent_.fill(tau);
    effective_.fill(tau_);
  }
  started_ = true;
}

/// Finds the tools in contact, and computes the joint torque of measured tool forces that the
/// contact models do not produce. In free air, this is the whole force. During contact, it is the
/// force along the surface, unless the contact has a friction model.
void DelayedState::feel(const ContactForceEstimate& contacts, MeasurementGate& gate,
                        const PredictionInput& input) noexcept {
  felt_.setZero();
  for (std::size_t i = 0; i < holds_.size(); ++i) {
    const PredictionTool& tool = input.tools[i];
    Eigen::Vector3d force_world = gate.tool_forces_world().col(static_cast<Eigen::Index>(i));
    const double pressed = tool.normal_world.dot(force_world);
    const bool holds = pressed > tool.contact_threshold && contacts.has_contact(input.stage, i);
    holds_[i] = holds ? 1 : 0;
    if (holds && tool.has_friction) continue;
    if (holds) force_world -= tool.normal_world * pressed;
    felt_.noalias() += gate.state().tools()[i].jacobian().transpose() * force_world;
  }
}

bool DelayedState::predict(ContactForceEstimate& contacts, MeasurementGate& gate,
                           const PredictionInput& input, Eigen::VectorXd& x) noexcept {
  if (!started_) return false;
  const Measurement& m = gate.last();
  const bool is_filtered = filter_ > 0.0 && x.size() > nq_ + nv_;
  start_ = x;
  auto q = x.head(nq_);
  auto v = x.segment(nq_, nv_);
  // Each tick without a measurement extends the prediction by one tick.
  const int missed = ticks_of(gate.now() - m.time, tick_period_);
  int left = std::min(max_ticks_, ticks_ + std::max(0, missed));
  feel(contacts, gate, input);
  if (!contacts.place(gate.state(), input.schedule_time)) return false;
  while (left > 0) {
    const int count = std::min(left, per_step_);
    tau_.setZero();
    for (int i = 1; i <= count; ++i) {
      const auto command = effective_.ago(left - i);
      if (is_filtered)
        for (std::size_t k = 0; k < actuated_.size(); ++k) {
          double& acts = x[nq_ + nv_ + static_cast<Eigen::Index>(k)];
          acts = filter_ * acts + (1.0 - filter_) * command[actuated_[k]];
          tau_[actuated_[k]] += acts / count;
        }
      else
        tau_ += command / count;
    }
    total_ = tau_ + input.torque_error + felt_;
    const double dt = count * tick_period_;
    const Status status =
        gate.state().forward_at(q, v, contacts.active(input.stage, holds_), total_);
    if (!is_usable(status)) break;
    const auto a = gate.state().dynamics().a();
    dq_ = dt * (v + 0.5 * dt * a);
    integrate_configuration(*tree_, q.data(), dq_.data(), q.data());
    v += dt * a;
    left -= count;
  }
  if (left == 0 && x.allFinite()) return true;
  x = start_;
  return false;
}

}  // namespace burnish
