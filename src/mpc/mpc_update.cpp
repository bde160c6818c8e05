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
  // Without the part that the torque error stands for: the filter leads to the command alone.
  for (int i = 0; i < layout.filtered; ++i) {
    const int k = layout.actuated[static_cast<std::size_t>(i)];
    x_[layout.nq + layout.nv + i] = tau_[k] - torque_offset_[k];
  }
  return x_;
}

void MpcController::Impl::place_knot(int knot, double schedule_time) {
  const auto phase = static_cast<std::size_t>(schedule.phase_at(schedule_time));
  const int stage = stage_of_phase_[phase];
  problem.set_knot(knot, stage, schedule_time);
  if (spec.model_error.kind != ModelErrorKind::Force || knot == problem.knots()) return;
  const auto& terms = force_terms_[static_cast<std::size_t>(stage)];
  for (std::size_t t = 0; t < terms.size(); ++t) {
    force_targets_[static_cast<std::size_t>(stage)][t].at(schedule_time, one_);
    one_[0] -= force_error;
    (void)problem.set_target(knot, terms[t], one_);  // one_ has the term's size
  }
}

void MpcController::Impl::place_horizon(double schedule_time) {
  for (int k = 0; k <= problem.knots(); ++k) place_knot(k, schedule_time + k * step_);
}

/// Moves x_ to where the policy in use leads, by knots as they are now. The horizon is placed anew
/// afterwards. Knots give accelerations; positions follow from them to second order, whatever the
/// knots' integrator: v after a whole knot would be wrong by half of it on the average.
void MpcController::Impl::predict(double now, double duration) {
  double* const next = guess_x_.data();
  const int nq = problem.layout().nq, nv = problem.layout().nv;
  for (double done = 0.0; done < duration;) {
    place_knot(0, schedule.time() + done);
    policy_control(now + done);
    const double part = std::min(duration - done, step_);
    const KnotValue value = problem.roll(0, 0, x_.data(), u_.data(), next);
    if (value.status > Status::NotConverged) break;
    problem.difference(x_.data(), next, dx_.data());
    dx_ *= part / step_;
    dx_.head(nv) = part * (x_.segment(nq, nv) + 0.5 * dx_.segment(nv, nv));
    problem.integrate(x_.data(), dx_.data(), x_.data());
    done += part;
    if (duration - done < 1e-9 * step_) return;
  }
  // Without a prediction the measurement is the best there is.
  measured_state();
}

/// The measured state everywhere, held against gravity.
void MpcController::Impl::rest_guess() noexcept {
  for (int k = 0; k <= problem.knots(); ++k) guess_x_.row(k) = x_.transpose();
  guess_u_.setZero();
  bias_.setZero();
  if (gravity_.forward(q_, bias_, bias_) > Status::NotConverged) return;
  for (int i = 0; i < problem.layout().nu; ++i)
    guess_u_.col(i).setConstant(
        gravity_.bias()[problem.layout().actuated[static_cast<std::size_t>(i)]]);
}

/// The last solution as a function of the schedule's time, from this time on: between its knots,
/// the last one repeated.
void MpcController::Impl::shift_guess(double schedule_time) noexcept {
  const int N = problem.knots();
  const auto xs = solver.xs();
  const auto us = solver.us();
  const double elapsed = std::max(0.0, (schedule_time - guess_time_) / step_);
  for (int k = 0; k <= N; ++k) {
    const double at = std::min(k + elapsed, static_cast<double>(N));
    const int i = std::min(static_cast<int>(at), N - 1);
    const double* const here = xs.data() + i * xs.cols();
    problem.difference(here, here + xs.cols(), dx_.data());
    dx_ *= at - i;
    problem.integrate(here, dx_.data(), guess_x_.row(k).data());
    if (k < N) guess_u_.row(k) = us.row(i);
  }
  guess_x_.row(0) = x_.transpose();
}

/// A plan from the measured state on: false if there is none that can be used.
bool MpcController::Impl::replan(double now) {
  const double delay = solved_ ? spec.solver_delay : 0.0;
  measured_state();
  if (spec.model_error.kind == ModelErrorKind::Torque &&
      problem.set_torque_bias(torque_error) != Status::Ok)
    return false;
  if (delay > 0.0) predict(now, delay);
  const double schedule_time = schedule.time() + delay;
  place_horizon(schedule_time);
  if (problem.set_initial_state(x_) != Status::Ok) return false;
  int iterations = spec.solver.max_iterations;
  if (jumped_ || !warm_) iterations = spec.jump_iterations;
  if (!solved_) iterations = spec.first_iterations;
  if (warm_) {
    shift_guess(schedule_time);
  } else {
    rest_guess();
  }
  warm_ = false;
  solver.set_max_iterations(iterations);
  solver.set_guess({guess_x_.data(), guess_u_.data()});
  const DdpSummary& summary = solver.solve();
  command_.iterations = summary.iterations;
  if (!solver.us().allFinite() || !solver.xs().allFinite()) return false;
  warm_ = true;
  guess_time_ = schedule_time;
  const bool usable = summary.reason == StopReason::Converged ||
                      summary.reason == StopReason::MaxIterations ||
                      (summary.reason == StopReason::TimeBudget && summary.iterations > 0);
  if (!usable) return false;
  next_time_ = now + delay;
  next_plan_.load(solver, next_time_);
  next_ready_ = true;
  jumped_ = false;
  return true;
}

void MpcController::Impl::update(double now) noexcept {
  const auto began = std::chrono::steady_clock::now();
  const bool first = !solved_;
  bool usable = false;
  try {
    usable = replan(now);
  } catch (...) {
    // Of a function that the specification holds: all that is known is that there is no plan.
    keep_exception();
    warm_ = false;
  }
  due_ = false;
  command_.solve_time =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  solved_ = solved_ || usable;
  failed_ = usable ? 0 : failed_ + 1;
  const SafetyLimits& limits = spec.limits;
  if (!usable) command_.status = worst(command_.status, Status::NotConverged);
  const int allowed = first ? 1 : limits.failed_solves;
  if (failed_ >= allowed) raise(FaultKind::SolverFailed, failed_, allowed);
  command_.missed_deadline = !first && command_.solve_time > limits.deadline;
  late_ = command_.missed_deadline ? late_ + 1 : 0;
  if (late_ >= limits.late_solves) raise(FaultKind::SolverLate, late_, limits.late_solves);
}

void MpcController::Impl::take_over(double now) noexcept {
  // Times are sums: a plan is not to wait a whole tick for the last bit of one.
  if (!next_ready_ || now < next_time_ - 0.01 * spec.tick_period) return;
  std::swap(plan_, next_plan_);
  next_ready_ = false;
}

/// u_ of the policy in use for x_.
void MpcController::Impl::policy_control(double time) noexcept {
  plan_.at(time, policy);
  if (spec.feedback) {
    plan_.control(policy, x_, u_);
  } else {
    u_ = policy.feedforward;
  }
  for (int i = 0; i < problem.layout().nu; ++i) {
    const double limit = effort_[problem.layout().actuated[static_cast<std::size_t>(i)]];
    u_[i] = std::clamp(u_[i], -limit, limit);
  }
}

void MpcController::Impl::apply_policy(double now) noexcept {
  take_over(now);
  measured_state();
  policy_control(now);
  if (!u_.allFinite()) {
    command_.status = worst(command_.status, Status::NotFinite);
    fall_back();
    return;
  }
  command_.tau.setZero();
  for (int i = 0; i < problem.layout().nu; ++i)
    command_.tau[problem.layout().actuated[static_cast<std::size_t>(i)]] = u_[i];
  holding_ = false;
}

}  // namespace burnish
