// Setting an MpcController up, and the order of a tick.
#include "mpc/mpc_impl.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"

namespace burnish {
namespace {

int knots_of(const ProblemSpec& problem) {
  int knots = 0;
  for (const HorizonSegment& segment : problem.horizon) knots += segment.knots;
  return knots;
}

double step_of(const ProblemSpec& problem) {
  if (problem.stages.empty()) throw Error("MPC: the problem has no stages");
  for (const Stage& stage : problem.stages) {
    if (stage.impact)
      throw Error("MPC: stage " + in_quotes(stage.name) + " is an impact; wanted steps of time");
    if (stage.step != problem.stages[0].step)
      throw Error("MPC: stage " + in_quotes(stage.name) + " has a step of " + number(stage.step) +
                  " s; wanted that of the others, " + number(problem.stages[0].step) + " s");
  }
  return problem.stages[0].step;
}

int ticks_per_update(const MpcSpec& spec) {
  constexpr double shortest = 1e-5;  // s: the record of the last second has a row for each
  if (!(spec.tick_period >= shortest))
    throw Error("MPC: a tick of " + number(spec.tick_period) + " s; wanted at least " +
                number(shortest) + " s");
  const double ratio = spec.update_period / spec.tick_period;
  if (!(ratio > 0.5) || !(ratio < 1e9) || std::abs(ratio - std::round(ratio)) > 1e-6)
    throw Error("MPC: an update period of " + number(spec.update_period) +
                " s; wanted a multiple of the tick of " + number(spec.tick_period) + " s");
  return static_cast<int>(std::lround(ratio));
}

/// Knots that a plan is kept for: until so many updates have failed that the run is given up.
int plan_knots(const MpcSpec& spec) {
  const double updates = 2.0 + spec.limits.failed_solves;
  const double time = updates * spec.update_period + spec.solver_delay;
  return static_cast<int>(
      std::min<double>(std::ceil(time / step_of(spec.problem)) + 1.0, knots_of(spec.problem)));
}

/// Room for the longest solve.
DdpOptions roomy(const MpcSpec& spec) {
  DdpOptions options = spec.solver;
  options.max_iterations =
      std::max({options.max_iterations, spec.first_iterations, spec.jump_iterations});
  return options;
}

/// Stabilisation keeps plans on the surface; in an estimate it would turn the noise of velocities
/// into force.
std::vector<ContactSpec> without_gains(std::vector<ContactSpec> contacts) {
  for (ContactSpec& contact : contacts) contact.with_gains(0.0, 0.0);
  return contacts;
}

void check_limits(const SafetyLimits& limits, double tick_period) {
  const std::pair<const char*, double> numbers[] = {
      {"force", limits.force},
      {"force_window", limits.force_window},
      {"tool_speed", limits.tool_speed},
      {"joint_speed_ratio", limits.joint_speed_ratio},
      {"joint_margin", limits.joint_margin},
      {"bad", limits.bad},
      {"contact_lost", limits.contact_lost},
      {"contact_threshold", limits.contact_threshold},
      {"late_contact_travel", limits.late_contact_travel},
      {"late_contact_time", limits.late_contact_time},
      {"unexpected_force", limits.unexpected_force},
      {"release", limits.release},
      {"deadline", limits.deadline}};
  for (const auto& [name, value] : numbers)
    if (!(value >= 0.0))
      throw Error("MPC: the limit " + std::string(name) + " is " + number(value) +
                  "; wanted a number that is not negative");
  if (!(limits.force_window < 1.0))
    throw Error("MPC: a force window of " + number(limits.force_window) +
                " s; wanted less than a second");
  if (!(limits.stale > tick_period))
    throw Error("MPC: measurements are stale after " + number(limits.stale) +
                " s; wanted longer than the tick of " + number(tick_period) + " s");
  if (limits.failed_solves < 1 || limits.late_solves < 1)
    throw Error("MPC: the run ends after " +
                std::to_string(std::min(limits.failed_solves, limits.late_solves)) +
                " failed or late updates; wanted at least 1");
}

void check_fallback(const Fallback& fallback) {
  const auto refuse = [](const char* what, double value, const char* wanted) {
    throw Error("MPC: the fallback's " + std::string(what) + " is " + number(value) + "; wanted " +
                wanted);
  };
  constexpr const char* not_negative = "a number that is not negative";
  if (!(fallback.stiffness >= 0.0) || !std::isfinite(fallback.stiffness))
    refuse("stiffness in 1/s^2", fallback.stiffness, not_negative);
  if (!(fallback.damping >= 0.0) || !std::isfinite(fallback.damping))
    refuse("damping in 1/s", fallback.damping, not_negative);
  if (!(fallback.give >= 0.0 && fallback.give <= 1.0))
    refuse("give", fallback.give, "a share between 0 and 1");
}

const MpcSpec& checked(const MpcSpec& spec) {
  (void)ticks_per_update(spec);
  if (!spec.target) throw Error("MPC: there is no target function");
  if (!spec.normal_world.allFinite() || !(spec.normal_world.norm() > 0.0))
    throw Error("MPC: the normal is not finite or has no length; wanted a direction");
  if (!(spec.solver_delay >= 0.0) || spec.solver_delay > spec.update_period)
    throw Error("MPC: a solver delay of " + number(spec.solver_delay) +
                " s; wanted between 0 and the update period of " + number(spec.update_period) +
                " s");
  if (!(knots_of(spec.problem) * step_of(spec.problem) > 2.0 * spec.update_period))
    throw Error("MPC: a horizon of " + number(knots_of(spec.problem) * step_of(spec.problem)) +
                " s; wanted longer than two update periods of " + number(spec.update_period) +
                " s");
  if (spec.first_iterations < 1 || spec.jump_iterations < 1 || spec.solver.max_iterations < 1)
    throw Error("MPC: a solve of " +
                std::to_string(std::min(
                    {spec.first_iterations, spec.jump_iterations, spec.solver.max_iterations})) +
                " iterations; wanted at least 1");
  check_fallback(spec.fallback);
  check_limits(spec.limits, spec.tick_period);
  return spec;
}

constexpr double touch_window = 5e-3;  // s, of the mean that tells contact from noise

/// Ticks that a time is, one at least.
int samples_of(double time, double tick_period) {
  return static_cast<int>(std::max(1.0, std::round(time / tick_period)));
}

}  // namespace

MpcController::Impl::Impl(MpcSpec given)
    : spec((checked(given), std::move(given))),
      problem(spec.problem),
      solver(problem, roomy(spec)),
      schedule(spec.schedule),
      observer(spec.problem.model, spec.tool, spec.model_error),
      step_(step_of(spec.problem)),
      ticks_per_update_(ticks_per_update(spec)),
      plan_(problem, plan_knots(spec), step_),
      next_plan_(plan_),
      body_(spec.problem.model),
      gravity_(spec.problem.model),
      contact_(spec.problem.model, without_gains(spec.problem.contacts), {.mu = 1e-9}),
      tool_(body_.frame(spec.tool)),
      touch_(spec.limits.contact_threshold, samples_of(touch_window, spec.tick_period)),
      tree_(spec.problem.model) {
  spec.normal_world.normalize();
  const StateLayout& layout = problem.layout();
  policy = plan_.make_feedback();
  command_.tau = Eigen::VectorXd::Zero(layout.nv);
  q_ = spec.problem.initial_state.head(layout.nq);
  q_hold_ = q_;
  v_ = tau_ = bias_ = total_ = acted_ = torque_offset_ = Eigen::VectorXd::Zero(layout.nv);
  pull_ = stretch_ = torque_error = v_;
  body_.frame_derivatives(tool_, FrameAxes::Centered, tool_motion_);  // sized here, not in a tick
  x_ = spec.problem.initial_state;
  u_ = Eigen::VectorXd::Zero(layout.nu);
  dx_ = Eigen::VectorXd::Zero(layout.ndx());
  one_ = Eigen::VectorXd::Zero(1);
  effort_ = spec.problem.model.effort_limit;
  guess_x_ = RowMatrix::Zero(problem.knots() + 1, layout.nx());
  guess_u_ = RowMatrix::Zero(problem.knots(), layout.nu);
  forces_ = Eigen::Matrix3Xd::Zero(3, samples_of(spec.limits.force_window, spec.tick_period));
  find_stages();
  find_force_terms();
  make_history();
}

void MpcController::Impl::find_stages() {
  for (const SchedulePhase& phase : schedule.phases()) {
    stage_of_phase_.push_back(problem.stage_index(phase.stage));
    const std::vector<std::string>& held =
        spec.problem.stages.at(static_cast<std::size_t>(stage_of_phase_.back())).contacts;
    std::vector<char>& holds = holds_.emplace_back();
    for (const ContactSpec& contact : spec.problem.contacts)
      holds.push_back(std::find(held.begin(), held.end(), contact.name) != held.end() ? 1 : 0);
  }
}

bool MpcController::Impl::has_contact(int phase) const noexcept {
  const std::vector<char>& holds = holds_[static_cast<std::size_t>(phase)];
  return std::find(holds.begin(), holds.end(), 1) != holds.end();
}

void MpcController::Impl::find_force_terms() {
  force_terms_.resize(spec.problem.stages.size());
  force_targets_.resize(spec.problem.stages.size());
  for (std::size_t s = 0; s < spec.problem.stages.size(); ++s)
    for (std::size_t t = 0; t < spec.problem.stages[s].costs.size(); ++t) {
      const auto* force =
          std::get_if<residual::ContactForce>(&spec.problem.stages[s].costs[t].residual);
      if (force == nullptr || force->target.size() != 1) continue;
      force_terms_[s].push_back(static_cast<int>(t));
      force_targets_[s].push_back(force->target);
    }
}

void MpcController::Impl::reset() noexcept {
  schedule.reset();
  observer.reset();
  fault.kind = FaultKind::None;
  fault.time = fault.value = fault.limit = 0.0;
  fault.joint = -1;
  fault.last_second.clear();
  plan_.clear();
  next_plan_.clear();
  q_ = spec.problem.initial_state.head(q_.size());
  v_.setZero();
  tau_.setZero();
  acted_.setZero();
  torque_offset_.setZero();
  torque_error.setZero();
  friction_force_.setZero();
  pressed_ = 0.0;
  tool_force.setZero();
  touch_.reset();
  mean_force_.setZero();
  force_error = good_time_ = last_time_ = 0.0;
  lost_for_ = waits_for_ = due_height_ = retreats_for_ = blind_for_ = 0.0;
  released_ = holding_ = started_ = fresh_ = due_ = solved_ = warm_ = jumped_ = next_ready_ = false;
  thrown = nullptr;
  tick_ = history_rows_ = forces_count_ = 0;
  failed_ = late_ = 0;
  command_ = Command{std::move(command_.tau)};
  command_.tau.setZero();
}

const Command& MpcController::Impl::tick(const Measurement& m) noexcept {
  command_.solve_time = 0.0;
  command_.iterations = 0;
  command_.missed_deadline = false;
  command_.status = Status::Ok;
  const double before = good_time_;
  due_ = due_ || tick_ % ticks_per_update_ == 0;
  fresh_ = accept(m);
  if (fresh_ && fault.kind == FaultKind::None) {
    // Over ticks without a good measurement, if there were any.
    const double dt = started_ ? good_time_ - before : 0.0;
    average_force();
    feel_contact();
    estimate(dt);
    if (started_ && schedule.advance(dt, touch_.touches())) jumped_ = true;
    watch(dt);
    started_ = true;
    take_over(last_time_);
    if (fault.kind == FaultKind::None && due_) update(last_time_);
  }
  if (fault.kind == FaultKind::None && solved_) {
    apply_policy(last_time_);
  } else {
    fall_back();
  }
  limit_torque();
  aim();
  record(last_time_);
  ++tick_;
  return command_;
}

void MpcController::Impl::aim() noexcept {
  const int phase = schedule.phase();
  command_.phase = schedule.phases()[static_cast<std::size_t>(phase)].phase;
  if (fault.kind != FaultKind::None) {
    command_.target_force = 0.0;
    return;
  }
  try {
    const TaskTarget target = spec.target(schedule.time());
    command_.target_force = target.force;
    command_.p_target_world = target.p_world;
  } catch (...) {
    keep_exception();
    command_.status = worst(command_.status, Status::NotEvaluated);
  }
}

/// Within a handler.
void MpcController::Impl::keep_exception() noexcept {
  if (!thrown) thrown = std::current_exception();
}

void MpcController::Impl::limit_torque() noexcept {
  for (Eigen::Index k = 0; k < command_.tau.size(); ++k) {
    if (!std::isfinite(command_.tau[k])) command_.tau[k] = 0.0;
    command_.tau[k] = std::clamp(command_.tau[k], -effort_[k], effort_[k]);
  }
}

}  // namespace burnish
