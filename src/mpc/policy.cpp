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

Prediction::Prediction(const Problem& problem)
    : start_(Eigen::VectorXd::Zero(problem.layout().nx())),
      next_(start_),
      dx_(Eigen::VectorXd::Zero(problem.layout().ndx())),
      u_(Eigen::VectorXd::Zero(problem.layout().nu)) {}

/// Knots give accelerations; positions follow from them to second order, whatever the knots'
/// integrator: v after a whole knot would be wrong by half of it on the average.
bool Prediction::advance(Problem& problem, Horizon& horizon, Policy& policy, double now,
                         double schedule_time, double duration, Eigen::VectorXd& x) {
  const int nq = problem.layout().nq, nv = problem.layout().nv;
  const double step = horizon.step();
  start_ = x;
  for (double done = 0.0; done < duration;) {
    horizon.place_knot(0, schedule_time + done);
    policy.control(now + done, x, u_);
    const double part = std::min(duration - done, step);
    const KnotValue value = problem.roll(0, 0, x.data(), u_.data(), next_.data());
    if (value.status > Status::NotConverged) break;
    problem.difference(x.data(), next_.data(), dx_.data());
    dx_ *= part / step;
    dx_.head(nv) = part * (x.segment(nq, nv) + 0.5 * dx_.segment(nv, nv));
    problem.integrate(x.data(), dx_.data(), x.data());
    done += part;
    if (duration - done < 1e-9 * step) return true;
  }
  x = start_;
  return false;
}

}  // namespace burnish
