#include "identify/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double slip_velocity = 0.02;  // rad/s (m/s), at which Coulomb's friction has its sign
constexpr double lag_windows = 4.0;     // that sums over lags reach

/// Samples between which residuals are correlated, at most.
int lags_of(const Regression& of) { return std::min(of.lags, of.samples / 4); }

/// How much of a lag counts (M. Bartlett).
double share_of(int lag, int lags) { return 1.0 - static_cast<double>(lag) / (lags + 1); }

/// By how much standard deviations from a sum over lags are to be enlarged, since that sum is
/// itself an estimate: the critical values of N. Kiefer and T. Vogelsang, "A New Asymptotic Theory
/// for Heteroskedasticity-Autocorrelation Robust Tests" (2005), by those of a normal distribution.
double enlargement(double lags_per_sample) {
  const double b = lags_per_sample;
  return 1.0 + (2.9694 * b + 0.4160 * b * b - 0.5324 * b * b * b) / 1.96;
}

/// Autocovariance of the residuals at a lag of samples, nv x nv.
Eigen::MatrixXd covariance_at(const Regression& of, const Eigen::VectorXd& residual, int lag) {
  const Eigen::Map<const RowMatrix> r(residual.data(), of.samples, of.nv);
  const Eigen::Index n = of.samples - lag;
  return r.topRows(n).transpose() * r.bottomRows(n) / static_cast<double>(of.samples);
}

/// By torque: the variance that a residual would have if its neighbours said nothing of it. A sum
/// over lags.
Eigen::VectorXd spectral_variance(const Regression& of, const Eigen::VectorXd& residual) {
  const int lags = lags_of(of);
  Eigen::VectorXd result = covariance_at(of, residual, 0).diagonal();
  const Eigen::VectorXd plain = result;
  for (int lag = 1; lag <= lags; ++lag) {
    result += 2.0 * share_of(lag, lags) * covariance_at(of, residual, lag).diagonal();
  }
  return result.cwiseMax(plain).cwiseMax(1e-16);
}

struct Step {
  Eigen::MatrixXd information;  ///< of the posterior
  Eigen::VectorXd gradient;
};

/// Of the negative logarithm of the posterior at x; weights per row.
double objective(const Regression& of, const Eigen::VectorXd& x, const Eigen::VectorXd& weight) {
  const Eigen::VectorXd r = of.residual(x);
  const Eigen::ArrayXd p = (x - of.prior).array() / of.prior_sigma.array();
  return 0.5 * (weight.array() * r.array().square()).sum() + 0.5 * p.square().sum();
}
Step step_at(const Regression& of, const Eigen::VectorXd& x, const Eigen::VectorXd& weight) {
  const Eigen::MatrixXd A = of.derivative(x);
  const Eigen::ArrayXd prior = of.prior_sigma.array().square().inverse();
  Step result;
  result.information = A.transpose() * weight.asDiagonal() * A;
  result.information.diagonal().array() += prior;
  result.gradient = A.transpose() * (weight.array() * of.residual(x).array()).matrix();
  result.gradient.array() -= prior * (x - of.prior).array();
  return result;
}

/// Weights of all rows from those of each torque.
Eigen::VectorXd row_weights(const Regression& of, const Eigen::VectorXd& variance) {
  return variance.cwiseInverse().replicate(of.samples, 1);
}

/// Moves x to the least objective; whether it got there.
bool minimize(const Regression& of, const Eigen::VectorXd& weight, Eigen::VectorXd& x) {
  constexpr int most = 100;
  double damping = 1e-3, value = objective(of, x, weight);
  for (int i = 0; i < most; ++i) {
    const Step step = step_at(of, x, weight);
    while (true) {
      Eigen::MatrixXd damped = step.information;
      damped.diagonal() *= 1.0 + damping;
      const Eigen::VectorXd dx = solve_positive(damped, step.gradient);
      const double next = dx.allFinite() ? objective(of, x + dx, weight) : value;
      if (dx.allFinite() && next < value) {
        x += dx;
        const double gain = value - next;
        value = next;
        damping = std::max(1e-9, 0.2 * damping);
        if (gain < 1e-9 * (1.0 + value)) return true;
        break;
      }
      damping *= 5.0;
      if (damping > 1e9) return step.gradient.dot(dx) < 1e-6 * (1.0 + value) || i > 0;
    }
  }
  return false;
}

/// B (A^T W R W A + P^-1) B with B = (A^T W A + P^-1)^-1: the covariance of the estimate when noise
/// is correlated between torques and over time as the residuals are (W. Newey, K. West, 1987, with
/// one autocovariance for all samples).
Eigen::MatrixXd covariance_of(const Regression& of, const Eigen::VectorXd& x,
                              const Eigen::VectorXd& weight) {
  const Eigen::VectorXd residual = of.residual(x);
  const Eigen::MatrixXd A = of.derivative(x);
  const Eigen::MatrixXd WA = weight.asDiagonal() * A;
  const int lags = lags_of(of), p = of.size();
  Eigen::MatrixXd middle = Eigen::MatrixXd::Zero(p, p);
  for (int lag = 0; lag <= lags; ++lag) {
    const Eigen::MatrixXd C = covariance_at(of, residual, lag);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(p, p);
    for (int i = 0; i + lag < of.samples; ++i)
      sum +=
          WA.middleRows(i * of.nv, of.nv).transpose() * C * WA.middleRows((i + lag) * of.nv, of.nv);
    middle += share_of(lag, lags) * (lag == 0 ? sum : Eigen::MatrixXd(sum + sum.transpose()));
  }
  // Fitted parameters took a part of the noise with them, of which each window has one piece.
  const double pieces = static_cast<double>(residual.size()) / of.samples_per_window;
  middle *= pieces / std::max(1.0, pieces - p);
  middle *= std::pow(enlargement(static_cast<double>(lags) / of.samples), 2);
  Eigen::MatrixXd information = A.transpose() * WA;
  const Eigen::ArrayXd prior = of.prior_sigma.array().square().inverse();
  information.diagonal().array() += prior;
  middle.diagonal().array() += prior;
  const Eigen::MatrixXd B = solve_positive(information, Eigen::MatrixXd::Identity(p, p));
  return B * middle * B.transpose();
}

Eigen::VectorXd rms(const Regression& of, const Eigen::VectorXd& residual) {
  return covariance_at(of, residual, 0).diagonal().cwiseSqrt();
}

}  // namespace

Regression::Regression(const Model& model, const SmoothedMotion& motion,
                       const std::vector<Unknown>& unknowns, const IdentificationSpec& spec)
    : nv(model.nv), samples(motion.samples()), inertias(static_cast<int>(unknowns.size())) {
  samples_per_window = spec.window / motion.spacing;
  lags = static_cast<int>(std::ceil(lag_windows * samples_per_window));
  const Eigen::Index rows = static_cast<Eigen::Index>(samples) * nv;
  int columns = 10 * inertias;
  const auto add = [&](bool wanted, int count) {
    const int first = wanted ? columns : -1;
    if (wanted) columns += count;
    return first;
  };
  viscous = add(spec.friction, nv);
  coulomb = add(spec.friction, nv);
  offset = add(spec.offset, nv);
  delay = add(spec.delay, 1);
  rest.resize(rows);
  before.resize(rows);
  Y.setZero(rows, 10 * inertias);
  linear.setZero(rows, columns - 10 * inertias);
  prior.setZero(columns);
  prior_sigma.setConstant(columns, 1e3);  // Nm, Nms/rad: nothing is believed of friction
  if (delay >= 0) prior_sigma[delay] = 0.02;
  std::vector<int> bodies;
  for (int i = 0; i < inertias; ++i) {
    bodies.push_back(unknowns[static_cast<std::size_t>(i)].body);
    prior.segment<10>(10 * i) = unknowns[static_cast<std::size_t>(i)].eta;
    prior_sigma.segment<10>(10 * i) = unknowns[static_cast<std::size_t>(i)].sigma;
  }
  // Bodies whose own parameters are wanted are known to weigh nothing.
  Vector10 own;
  ContactDynamics dynamics(model);
  RowMatrix of_bodies;
  const Eigen::VectorXd none(0);
  const int skip = 10 * inertias;
  for (int i = 0; i < samples; ++i) {
    const Eigen::Index row = static_cast<Eigen::Index>(i) * nv;
    (void)dynamics.inverse(motion.q.row(i).transpose(), motion.v.row(i).transpose(),
                           motion.a.row(i).transpose(), none);
    (void)dynamics.regressor(bodies, of_bodies);
    before.segment(row, nv) = motion.tau.row(i).transpose() - dynamics.tau();
    rest.segment(row, nv) = before.segment(row, nv);
    for (int b = 0; b < inertias; ++b) {
      const Unknown& unknown = unknowns[static_cast<std::size_t>(b)];
      const auto block = of_bodies.middleCols<10>(10 * b);
      Y.block(row, 10 * b, nv, 10) = block * unknown.to_body;
      if (!unknown.replaces) continue;
      own = inertia_parameters(inertia_of_body(model, unknown.body));
      rest.segment(row, nv) += block * own;
    }
    for (int k = 0; k < nv; ++k) {
      const double v = motion.v(i, k);
      if (viscous >= 0) linear(row + k, viscous - skip + k) = v;
      if (coulomb >= 0) linear(row + k, coulomb - skip + k) = std::tanh(v / slip_velocity);
      if (offset >= 0) linear(row + k, offset - skip + k) = 1.0;
      if (delay >= 0) linear(row + k, delay - skip) = -motion.tau_rate(i, k);
    }
  }
}

Eigen::VectorXd Regression::residual(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = rest - linear * x.tail(linear.cols());
  for (int i = 0; i < inertias; ++i)
    result -= Y.middleCols<10>(10 * i) * LogCholesky::parameters(x.segment<10>(10 * i));
  return result;
}

Eigen::MatrixXd Regression::derivative(const Eigen::VectorXd& x) const {
  Eigen::MatrixXd result(rest.size(), size());
  for (int i = 0; i < inertias; ++i)
    result.middleCols<10>(10 * i) =
        Y.middleCols<10>(10 * i) * LogCholesky::derivative(x.segment<10>(10 * i));
  result.rightCols(linear.cols()) = linear;
  return result;
}

Fit fit(const Regression& regression) {
  Fit result;
  result.x = regression.prior;
  result.rms_before = rms(regression, regression.before);
  // How noisy each torque is shows in what is left. At first all are as good as each other and the
  // motion goes before what is believed: noise that is told from a bad fit stays large.
  constexpr double share = 1e-3, settled = 0.01;
  constexpr int rounds = 40;
  const double start = std::pow(share * result.rms_before.norm(), 2) + 1e-16;
  Eigen::VectorXd variance = Eigen::VectorXd::Constant(regression.nv, start);
  Eigen::VectorXd weight = row_weights(regression, variance);
  for (int round = 0; round < rounds; ++round) {
    const bool least = minimize(regression, weight, result.x);
    const Eigen::VectorXd next = spectral_variance(regression, regression.residual(result.x));
    const double change = (next.array() / variance.array()).log().abs().maxCoeff();
    variance = next;
    weight = row_weights(regression, variance);
    result.converged = least && change < settled;
    if (result.converged) break;
  }
  result.covariance = covariance_of(regression, result.x, weight);
  result.rms_after = rms(regression, regression.residual(result.x));
  return result;
}

}  // namespace burnish::identify_detail
