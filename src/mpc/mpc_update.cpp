// Horizons and policies of an MpcController.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "mpc/mpc_impl.hpp"

namespace burnish {

Eigen::VectorXd& MpcController::Impl::measured_state() noexcept {
  const StateLayout& layout = problem.layout();
  x_.head(layout.nq) = q_;
  x_.segment(layout.nq, layout.nv) = v_;
  for (int i = 0; i < layout.filtered; ++i)
    x_[layout.nq + layout.nv + i] = tau_[layout.actuated[static_cast<std::size_t>(i)]];
  return x_;
}

void MpcController::Impl::place_horizon(double schedule_time) noexcept {
  for (int k = 0; k <= problem.knots(); ++k) {
    const double time = schedule_time + k * step_;
    const int phase = schedule.phase_at(time);
    const int stage = stage_of_phase_[static_cast<std::size_t>(phase)];
    problem.set_knot(k, stage, time);
    if (spec.model_error.kind != ModelErrorKind::Force || k == problem.knots()) continue;
    const auto& terms = force_terms_[static_cast<std::size_t>(stage)];
    for (std::size_t t = 0; t < terms.size(); ++t) {
      force_targets_[static_cast<std::size_t>(stage)][t].at(time, one_);
      one_[0] -= force_error;
      problem.set_target(k, terms[t], one_);
    }
  }
  if (spec.model_error.kind == ModelErrorKind::Torque)
    problem.set_torque_bias(observer.torque_error());
}

void MpcController::Impl::predict(double duration) noexcept {
  // The state that the policy in use leads to, by knots of the problem that is being left.
  double left = duration;
  if (plan_.empty() || !(left > 0.0)) return;
  const double fraction = left / step_;
  plan_.at(last_time_, policy);
  plan_.control(policy, x_, u_);
  if (problem.roll(0, 0, x_.data(), u_.data(), guess_x_.row(0).data()).status >
      Status::NotConverged)
    return;
  problem.difference(x_.data(), guess_x_.row(0).data(), dx_.data());
  dx_ *= fraction;
  problem.integrate(x_.data(), dx_.data(), x_.data());
}

void MpcController::Impl::shift_guess(double now) noexcept {
  // The last solution, (now - guess_time_) later: between its knots, the last one repeated.
  const int N = problem.knots();
  const auto xs = solver.xs();
  const auto us = solver.us();
  const double elapsed = std::max(0.0, (now - guess_time_) / step_);
  for (int k = 0; k <= N; ++k) {
    const double at = std::min(k + elapsed, static_cast<double>(N));
    const int i = std::min(static_cast<int>(at), N - 1);
    const double* const here = xs.data() + i * xs.cols();
    problem.difference(here, here + xs.cols(), dx_.data());
    dx_ *= at - i;
    problem.integrate(here, dx_.data(), guess_x_.row(k).data());
    if (k < N) guess_u_.row(k) = us.row(std::min(i, N - 1));
  }
}

void MpcController::Impl::solve(double now, int iterations) noexcept {
  const auto began = std::chrono::steady_clock::now();
  solver.set_max_iterations(iterations);
  solver.set_guess({guess_x_.data(), guess_u_.data()});
  const DdpSummary& summary = solver.solve();
  command_.solve_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  command_.iterations = summary.iterations;
  const bool usable = summary.reason == StopReason::Converged ||
                      summary.reason == StopReason::MaxIterations ||
                      summary.reason == StopReason::TimeBudget;
  const bool finite = solver.us().allFinite() && solver.xs().allFinite();
  if (usable && finite) {
    failed_ = 0;
    next_plan_.load(solver, now + spec.solver_delay);
    next_ready_ = true;
    next_time_ = now + spec.solver_delay;
    guess_time_ = now + spec.solver_delay;
    if (!solved_) next_time_ = now;
    solved_ = true;
  } else {
    command_.status = worst(command_.status, Status::NotConverged);
    if (++failed_ >= spec.limits.failed_solves || !solved_)
      raise(FaultKind::SolverFailed, failed_, spec.limits.failed_solves);
  }
  command_.missed_deadline = command_.solve_time > spec.limits.deadline;
  late_ = command_.missed_deadline ? late_ + 1 : 0;
  if (late_ >= spec.limits.late_solves)
    raise(FaultKind::SolverLate, late_, spec.limits.late_solves);
}

void MpcController::Impl::update(double now, bool jumped) noexcept {
  measured_state();
  const bool first = !solved_;
  const double delay = first ? 0.0 : spec.solver_delay;
  if (delay > 0.0) predict(delay);
  place_horizon(schedule.time() + delay);
  if (problem.set_initial_state(x_) != Status::Ok) {
    raise(FaultKind::BadMeasurement, 0.0, spec.limits.bad);
    return;
  }
  if (first) {
    for (int k = 0; k <= problem.knots(); ++k) guess_x_.row(k) = x_.transpose();
    bias_.setZero();
    if (gravity_.forward(q_, bias_, bias_) <= Status::NotConverged)
      for (int k = 0; k < problem.knots(); ++k)
        for (int i = 0; i < problem.layout().nu; ++i)
          guess_u_(k, i) = gravity_.bias()[problem.layout().actuated[static_cast<std::size_t>(i)]];
  } else {
    shift_guess(now + delay);
  }
  guess_x_.row(0) = x_.transpose();
  solve(now, first ? spec.first_iterations
                   : (jumped ? spec.jump_iterations : spec.solver.max_iterations));
  jumped_ = false;
}

void MpcController::Impl::apply_policy(double now) noexcept {
  if (next_ready_ && now >= next_time_ - 1e-9) {
    std::swap(plan_, next_plan_);
    next_ready_ = false;
  }
  plan_.at(now, policy);
  if (spec.feedback) {
    plan_.control(policy, measured_state(), u_);
  } else {
    u_ = policy.feedforward;
  }
  command_.tau.setZero();
  for (int i = 0; i < problem.layout().nu; ++i)
    command_.tau[problem.layout().actuated[static_cast<std::size_t>(i)]] = u_[i];
}

}  // namespace burnish
