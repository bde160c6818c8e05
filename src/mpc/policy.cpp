#include "mpc/policy.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// Steps of the knots until so many updates have failed that the run is given up.
std::vector<double> plan_steps(const MpcSpec& spec) {
  // Nobody knows how long plans take.
  if (spec.timing != PlanTiming::Fixed) return knot_steps(spec.problem);
  const double updates = 2.0 + spec.limits.failed_solves;
  const double time = updates * spec.update_period + spec.solver_delay;
  std::vector<double> steps = knot_steps(spec.problem);
  const KnotTimes times(steps);
  // Uneven ones may begin half a knot earlier: at a change of phase.
  const double more = times.is_even() ? 1.0 : 2.0;
  const double knots = std::ceil(times.place(time)) + more;
  steps.resize(static_cast<std::size_t>(std::min<double>(knots, times.knots())));
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
    effort_[i] =
        spec.problem.model.effort_limit[problem.layout().actuated[static_cast<std::size_t>(i)]];
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
  // Times are sums: a plan is not to wait a whole tick for the last bit of one.
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
