#include "burnish/tasks/pressing/admittance_controller.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "dynamics/integration.hpp"
#include "pressing/admittance_loop.hpp"
#include "pressing/descriptions.gen.hpp"
#include "pressing/path_follower.hpp"
#include "sim/small_product.hpp"

namespace burnish {
namespace {

using pressing::JointCommand;

AdmittanceSpec checked(const Model& model, AdmittanceSpec spec) {
  spec.path = pressing::checked_path(model, spec.path, description_of(&spec), &spec,
                                     "admittance controller");
  return spec;
}

/// Queue that delays joint commands by a constant time.
class DelayLine {
 public:
  /// `delay`: time by which commands are delayed [ticks]; `every`: time between two commands
  /// [ticks].
  DelayLine(const Model& model, long delay, long every)
      : delay_(delay),
        slots_(to_size(delay / every + 2),
               {0, {model.q_neutral, Eigen::VectorXd::Zero(model.nv)}}) {}

  void clear() noexcept { first_ = count_ = 0; }
  void send(long tick, const JointCommand& command) noexcept {
    Slot& slot = slots_[(first_ + count_) % slots_.size()];
    slot.due = tick + delay_;
    slot.command.q = command.q;
    slot.command.v = command.v;
    ++count_;
  }
  /// Removes and returns the command that arrives at this tick; null if none arrives.
  const JointCommand* arrived(long tick) noexcept {
    if (count_ == 0 || slots_[first_].due > tick) return nullptr;
    const JointCommand& command = slots_[first_].command;
    first_ = (first_ + 1) % slots_.size();
    --count_;
    return &command;
  }

 private:
  struct Slot {
    long due;
    JointCommand command;
  };
  long delay_;
  std::vector<Slot> slots_;
  std::size_t first_ = 0, count_ = 0;
};

long ticks(double time, double period) { return std::lround(time / period); }

class AdmittanceController final : public Controller {
 public:
  AdmittanceController(const Model& model, const AdmittanceSpec& spec);

  int nv() const override { return tree_.nv; }
  std::optional<std::vector<TouchSensor>> touches() const override {
    return {{{spec_.path.tool, WrenchSensor::Force}}};
  }
  void reset() noexcept override;
  const Command& tick(const Measurement& measurement) noexcept override;

 private:
  Status run_outer(const Measurement& measurement) noexcept;
  Status run_inner(const Measurement& measurement) noexcept;

  AdmittanceSpec spec_;
  Tree tree_;
  ContactDynamics dynamics_;
  RigidBody body_;
  int tool_;
  long every_;  ///< Period of the outer loop [ticks].
  pressing::PathFollower follower_;
  pressing::AdmittanceLoop outer_;
  DelayLine line_;
  Command command_;
  JointCommand wanted_;  ///< Current target of the inner loop (joint control).
  long tick_ = 0;
  bool started_ = false;
  bool saturated_ = false;  ///< True if a torque exceeded its limit at the last tick.
  Eigen::VectorXd effort_limit_, zero_, error_, integral_, response_, step_, tau_;
  Eigen::MatrixXd M_;
  Eigen::Vector3d force_world_ = Eigen::Vector3d::Zero();  ///< Measured force on the tool [N].
};

AdmittanceController::AdmittanceController(const Model& model, const AdmittanceSpec& spec)
    : spec_(checked(model, spec)),
      tree_(model),
      dynamics_(model),
      body_(model),
      tool_(body_.frame(spec_.path.tool)),
      every_(std::max(1L, ticks(1.0 / spec_.gains.rate, spec_.path.period))),
      follower_(spec_.path),
      outer_(model, spec_.path, spec_.gains, static_cast<double>(every_) * spec_.path.period),
      line_(model, ticks(spec_.gains.delay, spec_.path.period), every_),
      wanted_{model.q_neutral, Eigen::VectorXd::Zero(model.nv)},
      effort_limit_(model.effort_limit),
      zero_(Eigen::VectorXd::Zero(model.nv)),
      error_(zero_),
      integral_(zero_),
      response_(zero_),
      step_(zero_),
      tau_(zero_),
      M_(Eigen::MatrixXd::Zero(model.nv, model.nv)) {
  command_.tau = zero_;
  reset();
}

void AdmittanceController::reset() noexcept {
  tick_ = 0;
  started_ = saturated_ = false;
  integral_.setZero();
  line_.clear();
  follower_.reset(command_);
}

const Command& AdmittanceController::tick(const Measurement& measurement) noexcept {
  command_.status = dynamics_.forward(measurement.q, measurement.v, zero_);
  if (is_usable(command_.status)) command_.status = body_.update(measurement.q, measurement.v);
  if (!is_usable(command_.status)) return command_;
  force_world_ = body_.placement(tool_).linear() * measurement.force_at(0);
  if (!force_world_.allFinite()) {
    command_.status = Status::NotFinite;
    return command_;
  }
  M_ = dynamics_.mass_matrix();
  Status status = run_outer(measurement);
  if (is_usable(status)) status = run_inner(measurement);
  if (!is_usable(status)) command_.status = status;
  ++tick_;
  return command_;
}

Status AdmittanceController::run_outer(const Measurement& measurement) noexcept {
  if (!started_) {
    const Status status = outer_.reset(measurement.q);
    if (!is_usable(status)) return status;
    wanted_.q = measurement.q;
    wanted_.v.setZero();
    started_ = true;
  }
  follower_.update(force_world_, command_);
  if (follower_.touched()) {
    outer_.touch();
    integral_.setZero();
  }
  if (tick_ % every_ != 0) return Status::Ok;
  const TaskPoint target = follower_.ahead(spec_.gains.delay);
  const Status status =
      outer_.step(target, force_world_, follower_.phase() != Phase::Approach, !saturated_, M_);
  if (is_usable(status)) line_.send(tick_, outer_.command());
  return status;
}

/// Runs the joint controller. Between two commands, the joint targets move on with the velocities
/// of the last command.
Status AdmittanceController::run_inner(const Measurement& measurement) noexcept {
  const double dt = spec_.path.period, limit = spec_.gains.joint_integral_limit;
  if (const JointCommand* arrived = line_.arrived(tick_)) {
    wanted_.q = arrived->q;
    wanted_.v = arrived->v;
  }
  difference_configuration(tree_, measurement.q.data(), wanted_.q.data(), error_.data());
  for (int i = 0; i < tree_.nv; ++i) {
    if (!saturated_)
      integral_[i] =
          std::clamp(integral_[i] + spec_.gains.joint_ki * dt * error_[i], -limit, limit);
    response_[i] = spec_.gains.joint_kp * error_[i] +
                   spec_.gains.joint_kd * (wanted_.v[i] - measurement.v[i]) + integral_[i];
  }
  tau_ = dynamics_.bias();
  add_product(1.0, M_, response_, tau_);
  saturated_ = pressing::at_limit(tau_, effort_limit_);
  step_ = dt * wanted_.v;
  integrate_configuration(tree_, wanted_.q.data(), step_.data(), wanted_.q.data());
  if (!tau_.allFinite()) return Status::NotFinite;
  command_.tau = tau_;
  return Status::Ok;
}

}  // namespace

std::unique_ptr<Controller> make_admittance_controller(const Model& model,
                                                       const AdmittanceSpec& spec) {
  return std::make_unique<AdmittanceController>(model, spec);
}

}  // namespace burnish
