// Setting an MpcController up, and the order of a tick.
#include "mpc/mpc_impl.hpp"

#include <algorithm>
#include <cmath>

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
      throw Error("MPC: stage '" + stage.name + "' is an impact; wanted steps of time");
    if (stage.step != problem.stages[0].step)
      throw Error("MPC: stage '" + stage.name + "' has a step of " + std::to_string(stage.step) +
                  " s; wanted that of the others, " + std::to_string(problem.stages[0].step) +
                  " s");
  }
  return problem.stages[0].step;
}

int ticks_between(double period, double tick, const char* name) {
  const double ratio = period / tick;
  const int ticks = static_cast<int>(std::lround(ratio));
  if (!(tick > 0.0) || ticks < 1 || std::abs(ratio - ticks) > 1e-6)
    throw Error("MPC: " + std::string(name) + " of " + std::to_string(period) +
                " s is no multiple of the tick of " + std::to_string(tick) + " s");
  return ticks;
}

/// Room for the longest solve.
DdpOptions roomy(const MpcSpec& spec) {
  DdpOptions options = spec.solver;
  options.max_iterations =
      std::max({options.max_iterations, spec.first_iterations, spec.jump_iterations});
  return options;
}

}  // namespace

void MpcController::Impl::check(const MpcSpec& spec) {
  if (!spec.target) throw Error("MPC: there is no target function");
  if (!(spec.normal_world.norm() > 0.0)) throw Error("MPC: the normal has no length");
  if (!(spec.solver_delay >= 0.0) || spec.solver_delay > spec.update_period)
    throw Error("MPC: a solver delay of " + std::to_string(spec.solver_delay) +
                " s; wanted between 0 and the update period of " +
                std::to_string(spec.update_period) + " s");
  if (knots_of(spec.problem) * step_of(spec.problem) <= 2.0 * spec.update_period)
    throw Error("MPC: the horizon is not longer than two updates");
}

MpcController::Impl::Impl(MpcSpec given)
    : spec((check(given), std::move(given))),
      problem(spec.problem),
      solver(problem, roomy(spec)),
      schedule(spec.schedule),
      observer(spec.problem.model, spec.tool, spec.model_error),
      plan_(problem,
            std::max(2, 2 * static_cast<int>(spec.update_period / step_of(spec.problem)) + 2),
            step_of(spec.problem)),
      next_plan_(plan_),
      body_(spec.problem.model),
      gravity_(spec.problem.model),
      contact_(spec.problem.model, spec.problem.contacts, {.mu = 1e-9}),
      tool_(body_.frame(spec.tool)),
      step_(step_of(spec.problem)),
      ticks_per_update_(ticks_between(spec.update_period, spec.tick_period, "an update period")) {
  spec.normal_world.normalize();
  const StateLayout& layout = problem.layout();
  policy = plan_.make_feedback();
  command_.tau = Eigen::VectorXd::Zero(layout.nv);
  q_ = spec.problem.initial_state.head(layout.nq);
  v_ = tau_ = bias_ = total_ = Eigen::VectorXd::Zero(layout.nv);
  x_ = spec.problem.initial_state;
  u_ = Eigen::VectorXd::Zero(layout.nu);
  dx_ = Eigen::VectorXd::Zero(layout.ndx());
  one_ = Eigen::VectorXd::Zero(1);
  effort_ = spec.problem.model.effort_limit;
  guess_x_ = RowMatrix::Zero(problem.knots() + 1, layout.nx());
  guess_u_ = RowMatrix::Zero(problem.knots(), layout.nu);
  find_stages();
  find_force_terms();
  make_history();
}

void MpcController::Impl::find_stages() {
  for (const SchedulePhase& phase : schedule.phases()) {
    const int stage = problem.stage_index(phase.stage);
    stage_of_phase_.push_back(stage);
    in_contact_stage_.push_back(
        spec.problem.stages[static_cast<std::size_t>(stage)].contacts.empty() ? 0 : 1);
  }
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
  fault.last_second.clear();
  force_error = lost_for_ = 0.0;
  started_ = solved_ = jumped_ = next_ready_ = false;
  tick_ = history_rows_ = 0;
  failed_ = late_ = 0;
  command_ = Command{std::move(command_.tau)};
  command_.tau.setZero();
}

const Command& MpcController::Impl::tick(const Measurement& m) noexcept {
  command_.solve_time = 0.0;
  command_.iterations = 0;
  command_.missed_deadline = false;
  command_.status = Status::Ok;
  const double before = last_time_;
  const bool good = accept(m);
  const double now = last_time_;
  const double dt = started_ ? now - before : 0.0;
  if (fault.kind == FaultKind::None && good) {
    estimate(m);
    if (started_) {
      const bool contact = normal_force() > spec.limits.contact_threshold;
      if (schedule.advance(dt, contact)) jumped_ = true;
    }
    watch(dt);
    if (fault.kind == FaultKind::None && tick_ % ticks_per_update_ == 0) update(now, jumped_);
    started_ = true;
  }
  if (fault.kind == FaultKind::None && solved_) {
    apply_policy(now);
  } else {
    fall_back();
  }
  limit_torque();
  const Schedule& s = schedule;
  command_.phase = s.phases()[static_cast<std::size_t>(s.phase())].phase;
  const TaskTarget target = spec.target(s.time());
  command_.target_force = target.force;
  command_.p_target_world = target.p_world;
  record(now);
  ++tick_;
  return command_;
}

void MpcController::Impl::limit_torque() noexcept {
  for (Eigen::Index k = 0; k < command_.tau.size(); ++k) {
    if (!std::isfinite(command_.tau[k])) command_.tau[k] = 0.0;
    command_.tau[k] = std::clamp(command_.tau[k], -effort_[k], effort_[k]);
  }
}

}  // namespace burnish
