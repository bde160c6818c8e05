#include "mpc/policy.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"

namespace burnish {
namespace {

/// Returns the time steps of the knots for which a plan is kept. They cover the time until a run is
/// stopped because too many updates have failed.
std::vector<double> plan_steps(const MpcSpec& spec) {
  // With other kinds of PlanTiming, the computing time has no limit, so that all knots are kept.
  if (spec.timing != PlanTiming::Fixed) return knot_steps(spec.problem);
  const double updates = 2.0 + spec.limits.failed_solves;
  const double time = updates * spec.update_period + spec.solver_delay;
  std::vector<double> steps = knot_steps(spec.problem);
  const KnotTimes times(steps);
  // With uneven knots, one step more is kept, because knots may move by half a step to a change of
  // phase.
  const double extra = times.is_even() ? 1.0 : 2.0;
  const double knots = std::ceil(times.place(time)) + extra;
  steps.resize(to_size(std::min<double>(knots, times.knots())));
  return steps;
}

}  // namespace

Policy::Policy(const MpcSpec& spec, const Problem& problem)
    : plan_(problem, plan_steps(spec)),
      next_(plan_),
      feedback_(plan_.make_feedback()),
      effort_(problem.layout().nu),
      feeds_back_(spec.feedback),
      rounding_(0.01 * spec.tick_period) {
  for (int i = 0; i < problem.layout().nu; ++i)
    effort_[i] = spec.problem.model.effort_limit[problem.layout().actuated[to_size(i)]];
}

void Policy::reset() noexcept {
  plan_.clear();
  next_.clear();
  next_ready_ = false;
  measured_ = -std::numeric_limits<double>::infinity();
}

void Policy::load(const DdpSolver& solver, double time, const KnotTimes& times, double done,
                  double measured) noexcept {
  fill(solver, times);
  offer(time, done, measured);
}

void Policy::fill(const DdpSolver& solver, const KnotTimes& times) noexcept {
  next_.load(solver, 0.0, times);
}

void Policy::offer(double time, double done, double measured) noexcept {
  next_.begin_at(time);
  next_measured_ = measured;
  next_time_ = std::max(time, done);
  next_ready_ = true;
}

void Policy::take_over(double now) noexcept {
  // Without this tolerance, a rounding error in the summed times could delay a plan by a whole
  // tick.
  if (!next_ready_ || now < next_time_ - rounding_) return;
  std::swap(plan_, next_);
  measured_ = next_measured_;
  next_ready_ = false;
}

void Policy::control(double time, const Eigen::VectorXd& x, Eigen::VectorXd& u) noexcept {
  plan_.at(time, feedback_);
  if (feeds_back_) {
    plan_.control(feedback_, x, u);
  } else {
    u = feedback_.feedforward;
  }
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::clamp(u[i], -effort_[i], effort_[i]);
}

}  // namespace burnish
