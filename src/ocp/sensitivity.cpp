#include "burnish/ocp/sensitivity.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "ocp/problem_impl.hpp"

namespace burnish {
namespace {

/// Lagrangian of the problem at the solver's trajectory and multipliers, up to a constant.
class Lagrangian {
 public:
  Lagrangian(Problem& problem, const DdpSolver& solver)
      : problem_(problem),
        solver_(solver),
        next_(problem.state().nx),
        change_(problem.state().ndx),
        rows_(std::max(1, problem.max_rows())) {}

  double value() {
    const MatrixView xs = solver_.xs(), us = solver_.us();
    double sum = 0.0;
    for (int k = 0; k <= problem_.knots(); ++k) {
      const double* const u = us.row(std::min<Eigen::Index>(k, us.rows() - 1)).data();
      const KnotValue at = problem_.roll(0, k, xs.row(k).data(), u, next_.data(), rows_.data());
      if (!is_usable(at.status) || !std::isfinite(at.cost))
        throw Error("cost_by_payload: " + problem_.knot_name(k) +
                    " cannot be evaluated: " + std::string(describe(at.status)));
      sum += at.cost;
      if (const int rows = problem_.rows(k); rows > 0 && solver_.multipliers(k).size() == rows)
        sum += solver_.multipliers(k).dot(rows_.head(rows));
      if (k == problem_.knots()) break;
      problem_.difference(xs.row(k + 1).data(), next_.data(), change_.data());
      sum += solver_.value_gradient(k + 1).dot(change_);
    }
    return sum;
  }

 private:
  Problem& problem_;
  const DdpSolver& solver_;
  Eigen::VectorXd next_, change_, rows_;
};

/// Changes the inertia of a body of a problem. The destructor restores the inertia.
class ChangedBody {
 public:
  ChangedBody(Problem& problem, int body)
      : problem_(problem), body_(body), before_(inertia_of_body(problem.model(), body)) {}
  ChangedBody(const ChangedBody&) = delete;
  ChangedBody& operator=(const ChangedBody&) = delete;
  ~ChangedBody() { set(before_); }

  const InertiaSpec& before() const { return before_; }
  void set(const InertiaSpec& inertia) {
    ocp::ProblemInside::of(problem_).set_body_inertia(body_, inertia);
  }

 private:
  Problem& problem_;
  int body_;
  InertiaSpec before_;
};

}  // namespace

Vector10 cost_by_payload(Problem& problem, const DdpSolver& solver, std::string_view frame) {
  const Frame& at = frame_on_body("cost_by_payload", problem.model(), frame);
  ChangedBody body(problem, at.body);
  const double mass = body.before().mass;
  if (!(mass > 0.0))
    throw Error("cost_by_payload: the body of frame " + in_quotes(frame) +
                " has no mass; wanted a frame on a body with mass");
  if (solver.summary().reason != StopReason::Converged)
    throw Error("cost_by_payload: the problem is not solved: " + solver.text());
  const Vector10 theta = inertia_parameters(body.before());
  const auto to_body = inertia_transform(at.placement);
  Lagrangian lagrangian(problem, solver);
  Vector10 result;
  for (int k = 0; k < 10; ++k) {
    // Step of the finite differences as a fraction of `mass`, of `mass` * 0.1 m for first moments,
    // and of `mass` * 0.01 m^2 for moments of inertia.
    constexpr double fraction = 1e-4;
    const double h = fraction * mass * (k == 0 ? 1.0 : k < 4 ? 0.1 : 0.01);
    const auto value_at = [&](double step) {
      body.set(inertia_of(theta + step * to_body.col(k)));
      return lagrangian.value();
    };
    result[k] = (value_at(h) - value_at(-h)) / (2.0 * h);
  }
  return result;
}

}  // namespace burnish
