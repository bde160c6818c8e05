// Independent solver for comparisons: a dense convex quadratic program by Mehrotra's
// predictor-corrector method,
// minimize 1/2 x^T H x + g^T x  subject to  G x <= h,  A x = b.
#pragma once

#include <Eigen/Dense>
#include <algorithm>

namespace burnish::testing {

struct QpSolution {
  Eigen::VectorXd x;
  Eigen::VectorXd multiplier;  ///< multipliers of G x <= h, nonnegative
  Eigen::VectorXd equal_multiplier;
  bool converged = false;
};

inline double max_step(const Eigen::VectorXd& value, const Eigen::VectorXd& change) {
  double length = 1.0;
  for (Eigen::Index i = 0; i < value.size(); ++i)
    if (change[i] < 0.0) length = std::min(length, -value[i] / change[i]);
  return length;
}

inline QpSolution solve_qp(const Eigen::MatrixXd& H, const Eigen::VectorXd& g,
                           const Eigen::MatrixXd& G, const Eigen::VectorXd& h,
                           const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  using Eigen::VectorXd;
  const Eigen::Index n = g.size(), m = h.size(), equal = b.size();
  const double inequalities = static_cast<double>(std::max<Eigen::Index>(1, m));
  QpSolution s{VectorXd::Zero(n), VectorXd::Ones(m), VectorXd::Zero(equal), false};
  VectorXd slack = (h - G * s.x).cwiseMax(1.0);
  const double scale = 1.0 + g.cwiseAbs().maxCoeff() + H.cwiseAbs().maxCoeff();
  for (int iteration = 0; iteration < 200 && !s.converged; ++iteration) {
    const VectorXd stationary =
        H * s.x + g + G.transpose() * s.multiplier + A.transpose() * s.equal_multiplier;
    const VectorXd primal = G * s.x + slack - h;
    const VectorXd closed = A * s.x - b;
    const double gap = slack.dot(s.multiplier) / inequalities;
    s.converged = stationary.cwiseAbs().maxCoeff() < 1e-12 * scale && gap < 1e-14 * scale &&
                  (m == 0 || primal.cwiseAbs().maxCoeff() < 1e-10) &&
                  (equal == 0 || closed.cwiseAbs().maxCoeff() < 1e-10);
    if (s.converged) break;
    const VectorXd ratio = s.multiplier.cwiseQuotient(slack);
    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + equal, n + equal);
    kkt.topLeftCorner(n, n) = H + G.transpose() * ratio.asDiagonal() * G;
    kkt.topRightCorner(n, equal) = A.transpose();
    kkt.bottomLeftCorner(equal, n) = A;
    const Eigen::PartialPivLU<Eigen::MatrixXd> factor(kkt);
    VectorXd dx, de, ds, dm;
    const auto direction = [&](const VectorXd& complementarity) {
      // S dm + M ds = -complementarity
      const VectorXd r = ratio.cwiseProduct(primal) - complementarity.cwiseQuotient(slack);
      VectorXd right(n + equal);
      right << -stationary - G.transpose() * r, -closed;
      const VectorXd step = factor.solve(right);
      dx = step.head(n);
      de = step.tail(equal);
      ds = -primal - G * dx;
      dm = -(complementarity + s.multiplier.cwiseProduct(ds)).cwiseQuotient(slack);
    };
    direction(slack.cwiseProduct(s.multiplier));
    const double affine = std::min(max_step(slack, ds), max_step(s.multiplier, dm));
    const double remaining_gap =
        (slack + affine * ds).dot(s.multiplier + affine * dm) / inequalities;
    // Complementarity must not vanish before the other residuals.
    const double residual = stationary.cwiseAbs().maxCoeff() / scale;
    const double centre = gap < 0.1 * residual
                              ? gap
                              : std::max(std::pow(remaining_gap / gap, 3) * gap, 1e-15 * scale);
    direction(slack.cwiseProduct(s.multiplier) + ds.cwiseProduct(dm) -
              VectorXd::Constant(m, centre));
    const double length =
        std::min(1.0, 0.99 * std::min(max_step(slack, ds), max_step(s.multiplier, dm)));
    s.x += length * dx;
    s.equal_multiplier += length * de;
    slack += length * ds;
    s.multiplier += length * dm;
  }
  return s;
}

}  // namespace burnish::testing
