#include "mpc/policy.hpp"

#include <algorithm>

#include "base/to_size.hpp"

namespace burnish {

Policy::Policy(const PolicySpec& spec, const Problem& problem)
    : plan_(problem, spec.steps),
      next_(plan_),
      feedback_(plan_.make_feedback()),
      effort_(problem.layout().nu),
      feeds_back_(spec.feedback),
      rounding_(0.01 * spec.tick_period) {
  for (int i = 0; i < problem.layout().nu; ++i)
    effort_[i] = problem.model().effort_limit[problem.layout().actuated[to_size(i)]];
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
