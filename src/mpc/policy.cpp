#include "mpc/policy.hpp"

#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// Until so many updates have failed that the run is given up.
int plan_knots(const MpcSpec& spec, int knots) {
  const double updates = 2.0 + spec.limits.failed_solves;
  const double time = updates * spec.update_period + spec.solver_delay;
  return static_cast<int>(
      std::min<double>(std::ceil(time / spec.problem.stages.front().step) + 1.0, knots));
}

}  // namespace

Policy::Policy(const MpcSpec& spec, const Problem& problem)
    : plan_(problem, plan_knots(spec, problem.knots()), spec.problem.stages.front().step),
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
}

void Policy::load(const DdpSolver& solver, double time) noexcept {
  next_time_ = time;
  next_.load(solver, next_time_);
  next_ready_ = true;
}

void Policy::take_over(double now) noexcept {
  // Times are sums: a plan is not to wait a whole tick for the last bit of one.
  if (!next_ready_ || now < next_time_ - rounding_) return;
  std::swap(plan_, next_);
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
