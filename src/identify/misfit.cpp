#include "identify/misfit.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/model/state.hpp"
#include "identify/signal_check.hpp"
#include "identify/smoothing.hpp"

namespace burnish::identify_detail {
namespace {

/// Largest accepted ratio of a residual to its expected noise. The ratio was at most 0.83 for arm7
/// with the seeds 300 to 449 of `burnish identify --seeds`, at 0.7 Hz and at 1.5 Hz.
constexpr double suspicious_ratio = 2.0;
/// Minimum error of torque sensors and models, as a fraction of the torque's rms; chosen by hand.
constexpr double min_fraction = 1e-3;

/// Returns the mean squares of the entries of the mass matrix along the record, nv x nv.
Eigen::MatrixXd mean_square_mass(const Evidence& of) {
  constexpr Eigen::Index instants = 20;
  const Model& model = of.model;
  ContactDynamics dynamics(model);
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.nv), none;
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(model.nv, model.nv);
  for (Eigen::Index i = 0; i < instants; ++i) {
    const Eigen::Index at = i * (of.record.q.rows() - 1) / (instants - 1);
    (void)dynamics.inverse(normalized(model, of.record.q.row(at).transpose()), still, still, none);
    sum += dynamics.mass_matrix().cwiseAbs2();
  }
  return sum / static_cast<double>(instants);
}

Eigen::VectorXd mean_square(const Regression& of, const Eigen::VectorXd& rows) {
  const Eigen::Map<const RowMatrix> r(rows.data(), of.samples, of.nv);
  return r.cwiseAbs2().colwise().mean().transpose();
}

}  // namespace

Eigen::VectorXd kernel(const Windows& windows, int order) {
  const Smoother smoother(windows.motion, windows.period);
  const Eigen::VectorXd mean = bell(windows.torque);
  Eigen::VectorXd result =
      Eigen::VectorXd::Zero((mean.size() - 1) * windows.stride + 2 * windows.motion + 1);
  for (Eigen::Index i = 0; i < mean.size(); ++i)
    result.segment(i * windows.stride, 2 * windows.motion + 1) += mean[i] * smoother.weights(order);
  return result;
}

Eigen::VectorXd expected_rms(const Evidence& of, const Eigen::VectorXd& x) {
  const int nv = of.model.nv;
  const Eigen::MatrixXd path = joint_path(of.model, of.record.q);
  Eigen::VectorXd of_torques(nv), of_positions(nv);
  for (int k = 0; k < nv; ++k) {
    of_positions[k] = std::pow(white_noise(path.col(k)), 2);
    of_torques[k] =
        std::pow(of.torque_noise > 0.0 ? of.torque_noise : white_noise(of.record.tau.col(k)), 2);
  }
  const Regression& regression = of.regression;
  Eigen::VectorXd square =
      kernel(of.windows, 0).squaredNorm() * of_torques +
      kernel(of.windows, 2).squaredNorm() * mean_square_mass(of) * of_positions;
  square += of.fraction * of.fraction *
            mean_square(regression, of.longer.residual(x) - regression.residual(x));
  square += mean_square(regression, regression.held);
  square += min_fraction * min_fraction * mean_square(regression, regression.measured);
  return square.cwiseSqrt();
}

Misfit misfit_of(const Regression& regression, const Fit& fit, const Eigen::VectorXd& expected) {
  Misfit result;
  result.ratio = fit.rms_after.array() / expected.array().max(1e-12);
  (void)result.ratio.maxCoeff(&result.joint);
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(regression.rest.size());
  for (int i = 0; i < regression.layout.inertias; ++i)
    masses +=
        regression.Y.middleCols<10>(10 * i) * LogCholesky::parameters(fit.x.segment<10>(10 * i));
  result.unexplained =
      fit.rms_after.norm() / std::max(1e-12, mean_square(regression, masses).cwiseSqrt().norm());
  result.is_suspicious = result.is_suspicious_at(result.joint);
  return result;
}

bool Misfit::is_suspicious_at(int entry_of_v) const {
  return !(ratio[entry_of_v] <= suspicious_ratio);
}

}  // namespace burnish::identify_detail
