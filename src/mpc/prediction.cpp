#include "mpc/prediction.hpp"

#include <algorithm>

namespace burnish {

Prediction::Prediction(const Problem& problem)
    : start_(Eigen::VectorXd::Zero(problem.layout().nx())),
      next_(start_),
      dx_(Eigen::VectorXd::Zero(problem.layout().ndx())),
      u_(Eigen::VectorXd::Zero(problem.layout().nu)) {}

/// Uses the acceleration at each knot, and integrates positions to second order, whichever
/// integrator plans use. An integrator that used the velocity at the end of a knot for the whole
/// knot would be wrong by half the change of velocity.
bool Prediction::advance(Problem& problem, Horizon& horizon, Policy& policy, const Interval& over,
                         Eigen::VectorXd& x) {
  const int nq = problem.layout().nq, nv = problem.layout().nv;
  start_ = x;
  for (double done = 0.0; done < over.duration;) {
    horizon.place_knot(0, over.schedule_start + done);
    const double step = problem.step_of(0);
    policy.control(over.start + done, x, u_);
    const double duration_of_step = std::min(over.duration - done, step);
    const KnotValue value = problem.roll(0, 0, x.data(), u_.data(), next_.data());
    if (!is_usable(value.status)) break;
    problem.difference(x.data(), next_.data(), dx_.data());
    dx_ *= duration_of_step / step;
    dx_.head(nv) = duration_of_step * (x.segment(nq, nv) + 0.5 * dx_.segment(nv, nv));
    problem.integrate(x.data(), dx_.data(), x.data());
    done += duration_of_step;
    if (over.duration - done < 1e-9 * step) return true;
  }
  x = start_;
  return false;
}

}  // namespace burnish
