#include "identify/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "base/decomposition.hpp"

namespace burnish::identify_detail {
namespace {

constexpr double lag_windows = 6.0;  // Largest lag in sums over lags [torque windows]

/// Returns the largest lag at which residuals count as correlated [samples].
int lags_of(const Regression& of) {
  return std::min(static_cast<int>(std::ceil(lag_windows * of.samples_per_window)), of.samples / 4);
}

/// Returns M. Bartlett's weight of a lag in sums over lags, which falls linearly with the lag.
double lag_weight(int lag, int lags) { return 1.0 - static_cast<double>(lag) / (lags + 1); }

/// Returns a factor on standard deviations, which accounts for errors of the estimated sums over
/// lags. The factor is a critical value (99 %) of N. Kiefer and T. Vogelsang, "A New
/// Asymptotic Theory for Heteroskedasticity-Autocorrelation Robust Tests" (2005), divided by the
/// same critical value of a normal distribution.
double enlargement(double lags_per_sample) {
  const double b = lags_per_sample;
  return 1.0 + (4.1618 * b + 0.5368 * b * b - 0.9060 * b * b * b) / 2.3263;
}

/// Returns the autocovariance of the residuals at a lag in samples, nv x nv.
Eigen::MatrixXd covariance_at(const Regression& of, const Eigen::VectorXd& residual, int lag) {
  const Eigen::Map<const RowMatrix> r(residual.data(), of.samples, of.nv);
  const Eigen::Index n = of.samples - lag;
  return r.topRows(n).transpose() * r.bottomRows(n) / static_cast<double>(of.samples);
}

/// Returns, per torque, the sum of the residuals' autocovariances over all lags. White noise with
/// this variance would disturb a mean as much as the correlated residuals do.
Eigen::VectorXd spectral_variance(const Regression& of, const Eigen::VectorXd& residual) {
  const int lags = lags_of(of);
  Eigen::VectorXd result = covariance_at(of, residual, 0).diagonal();
  const Eigen::VectorXd plain = result;
  for (int lag = 1; lag <= lags; ++lag) {
    result += 2.0 * lag_weight(lag, lags) * covariance_at(of, residual, lag).diagonal();
  }
  // Bounds the weights, because a torque without noise would outweigh the prior by far.
  constexpr double min_fraction = 1e-5;  // Smallest noise, as a fraction of a torque's rms
  const Eigen::VectorXd floor =
      (min_fraction * min_fraction * covariance_at(of, of.measured, 0).diagonal().array() + 1e-16)
          .matrix();
  return result.cwiseMax(plain).cwiseMax(floor);
}

struct Step {
  Eigen::MatrixXd information;  ///< Information matrix of the posterior
  Eigen::VectorXd gradient;
};

/// Returns the negative logarithm of the posterior at x; `weight` has one entry per row.
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

/// Returns the weights of all rows from the variance of each torque.
Eigen::VectorXd row_weights(const Regression& of, const Eigen::VectorXd& variance) {
  return variance.cwiseInverse().replicate(of.samples, 1);
}

/// Moves x to the minimum of the objective. Returns whether the minimum was reached.
bool minimize(const Regression& of, const Eigen::VectorXd& weight, Eigen::VectorXd& x) {
  constexpr int max_steps = 100;
  double damping = 1e-3, value = objective(of, x, weight);
  for (int i = 0; i < max_steps; ++i) {
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

/// Returns the covariance of the estimate, B (A^T W R W A + P^-1) B with B = (A^T W A + P^-1)^-1,
/// where A is the derivative, W the weight and P the covariance of the prior. R is the covariance
/// of the noise. Like the residuals, the noise is correlated between torques and over time
/// (W. Newey, K. West, 1987, with one autocovariance for all samples).
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
    middle += lag_weight(lag, lags) * (lag == 0 ? sum : Eigen::MatrixXd(sum + sum.transpose()));
  }
  // Corrects for the noise that the fitted parameters absorb. All residuals of one torque within a
  // window count as one independent number.
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

Fit fit(const Regression& regression) {
  Fit result;
  result.x = regression.prior;
  result.rms_before = rms(regression, regression.before);
  // The residuals show the noise of each torque. The first round assumes equal, small noise in all
  // torques, so that measurements outweigh the prior. If the prior outweighed them, the fit would
  // be bad, and the noise estimated from it would stay large.
  constexpr double start_fraction = 1e-3, settled = 0.01;
  constexpr int rounds = 40;
  const double start = std::pow(start_fraction * result.rms_before.norm(), 2) + 1e-16;
  Eigen::VectorXd variance = Eigen::VectorXd::Constant(regression.nv, start);
  Eigen::VectorXd& weight = result.weight;
  weight = row_weights(regression, variance);
  for (int round = 0; round < rounds; ++round) {
    const bool is_minimum = minimize(regression, weight, result.x);
    const Eigen::VectorXd next = spectral_variance(regression, regression.residual(result.x));
    const double change = (next.array() / variance.array()).log().abs().maxCoeff();
    variance = next;
    weight = row_weights(regression, variance);
    result.converged = is_minimum && change < settled;
    if (result.converged) break;
  }
  result.covariance = covariance_of(regression, result.x, weight);
  result.rms_after = rms(regression, regression.residual(result.x));
  return result;
}

void add_bias(const Regression& regression, const Regression& longer, double fraction, Fit& fit) {
  const Step here = step_at(regression, fit.x, fit.weight);
  const Step there = step_at(longer, fit.x, fit.weight);
  const Eigen::MatrixXd A = regression.derivative(fit.x);
  Eigen::MatrixXd towards(regression.size(), 2);
  towards.col(0) = fraction * (there.gradient - here.gradient);
  towards.col(1) = A.transpose() * fit.weight.cwiseProduct(regression.held);
  const Eigen::MatrixXd bias = solve_positive(here.information, towards);
  fit.covariance += bias * bias.transpose();
}

void add_misfit(const Regression& regression, Fit& fit) {
  const Step here = step_at(regression, fit.x, fit.weight);
  const Eigen::VectorXd r = regression.residual(fit.x);
  const double squares = (fit.weight.array() * r.array().square()).sum();
  const int p = regression.size();
  fit.covariance += squares * solve_positive(here.information, Eigen::MatrixXd::Identity(p, p));
}

}  // namespace burnish::identify_detail
