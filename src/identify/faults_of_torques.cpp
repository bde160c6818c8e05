// Faults of the torques: units, signs, swapped columns, a lag, or one column with other content.
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "identify/faults.hpp"
#include "identify/misfit.hpp"
#include "identify/record_check.hpp"

namespace burnish::identify_detail {
namespace {

struct UnitOfTorque {
  const char* name;
  double per_newton_metre;
};
constexpr UnitOfTorque units_of_torque[] = {
    {"Nmm", 1e3},        {"Ncm", 1e2},        {"kNm", 1e-3},        {"kgf m", 0.101972},
    {"kgf cm", 10.1972}, {"kgf mm", 101.972}, {"lbf ft", 0.737562}, {"lbf in", 8.85075},
    {"ozf in", 141.612}, {"dyn cm", 1e7}};
constexpr double same_unit = 0.05;  // Relative tolerance of a gain that counts as a change of unit

bool all_near(const Eigen::ArrayXd& ratio, double tolerance) {
  return ((ratio - 1.0).abs() < tolerance).all();
}

double median(const Eigen::VectorXd& values) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

}  // namespace

/// Tries to explain each measured torque as a gain times the true torque. The equations are linear
/// in the parameters and in 1 / gain.
void FaultSearch::try_gains() {
  const int nv = base_.nv;
  const Eigen::VectorXd known = base_.measured - base_.rest;
  const Rows plain = rows(base_);
  Rows with{Eigen::MatrixXd::Zero(plain.A.rows(), plain.A.cols() + nv), -known};
  with.A.leftCols(plain.A.cols()) = plain.A;
  // The gain of a torque that never changes cannot be estimated; the torque is taken as measured.
  const Eigen::Map<const RowMatrix> torque(base_.measured.data(), base_.samples, nv);
  for (int k = 0; k < nv; ++k) {
    const double range = torque.col(k).maxCoeff() - torque.col(k).minCoeff();
    for (int s = 0; s < base_.samples; ++s) {
      const Eigen::Index row = static_cast<Eigen::Index>(s) * nv + k;
      if (range > 0.0)
        with.A(row, plain.A.cols() + k) = -torque(s, k);
      else
        with.b[row] += torque(s, k);
    }
  }
  // Divides residuals by the rms of the model's torques, whose units the rows `with` have.
  const Eigen::VectorXd weight = weight_;
  const Eigen::Map<const RowMatrix> model_torque(known.data(), base_.samples, nv);
  const Eigen::ArrayXd size =
      model_torque.cwiseAbs2().colwise().mean().transpose().cwiseSqrt().array() + 1e-12;
  weight_ = (size + 0.02 * size.maxCoeff()).square().inverse().matrix().replicate(base_.samples, 1);
  Eigen::VectorXd x;
  (void)left(with, &x);
  weight_ = weight;
  Eigen::VectorXd gain = Eigen::VectorXd::Ones(nv);
  for (int k = 0; k < nv; ++k)
    if (const double inverse = x[plain.A.cols() + k]; inverse != 0.0) gain[k] = 1.0 / inverse;
  const Eigen::VectorXd residual = with.b - with.A * x;
  consider_gains(gain, weighted(residual.cwiseProduct(gain.replicate(base_.samples, 1))));
}

void FaultSearch::consider_gains(const Eigen::VectorXd& gain, double squares) {
  const auto& g = gain.array();
  // Uses the median, because noise changes the gains of small torques.
  const double middle = median(gain);
  const auto as = [&](const std::string& what) { consider(what, squares); };
  for (const UnitOfTorque& unit : units_of_torque)
    if (all_near(g / unit.per_newton_metre, same_unit))
      return as("all torques are " + number(middle) +
                " times the torques that the motion requires: are they "
                "in " +
                unit.name + "? wanted Nm (N)");
  if (all_near(-g, 0.2))
    return as(
        "all torques have the opposite sign of the torques that the motion requires; wanted "
        "motor torques");
  const Eigen::ArrayXd limit = model_.effort_limit.array();
  if (all_near(g * limit / 100.0, 0.1))
    return as("torques look like percentages of the effort limits; wanted Nm (N)");
  if (all_near(g * limit, 0.1))
    return as("torques look like fractions of the effort limits; wanted Nm (N)");
  if (all_near(g / middle, 0.05) && std::abs(middle - 1.0) > 0.02)
    return as(
        "all torques are " + number(middle) +
        " times the torques that the motion requires; "
        "wanted Nm (N): " +
        (std::abs(middle - 1.0) > 0.5
             ? "are they currents, or torques before the gears?"
             : "are their sensors calibrated, or do the links' masses differ from the model?"));
  std::string list;
  for (int k = 0; k < gain.size(); ++k)
    if (std::abs(gain[k] - 1.0) > 0.05)
      list += (list.empty() ? "" : ", ") + number(gain[k]) + " times for " +
              in_quotes(tau_column(model_, k));
  if (list.empty()) list = number(g.minCoeff()) + " to " + number(g.maxCoeff()) + " times";
  as("torques are multiples of the torques that the motion requires (" + list +
     "); wanted Nm (N) with the sign of the joint's axis: are their sensors calibrated?");
}

void FaultSearch::try_torque_columns() {
  for (int i = 0; i < base_.nv; ++i)
    for (int j = i + 1; j < base_.nv; ++j)
      consider(
          "are the columns " + in_quotes(tau_column(model_, i)) + " and " +
              in_quotes(tau_column(model_, j)) + " swapped?",
          left(rows_with_torques(base_, [&](RowMatrix& tau) { tau.col(i).swap(tau.col(j)); })));
  consider(
      "are the torques in the reverse order of the joints?",
      left(rows_with_torques(base_, [](RowMatrix& tau) { tau = tau.rowwise().reverse().eval(); })));
}

/// Returns the smoothed torque of a joint, read `by` samples later.
Eigen::VectorXd FaultSearch::shifted_torque(int joint, Eigen::Index by) const {
  const Eigen::VectorXd weights = kernel(windows_, 0);
  const Eigen::VectorXd torque = record_.tau.col(joint);
  const Eigen::Index stride = row_stride(windows_);
  Eigen::VectorXd result(base_.samples);
  for (int s = 0; s < base_.samples; ++s) {
    const Eigen::Index middle =
        windows_.first + (windows_.torque + s * stride) * windows_.stride + by;
    const Eigen::Index begin =
        std::clamp<Eigen::Index>(middle - weights.size() / 2, 0, torque.size() - weights.size());
    result[s] = weights.dot(torque.segment(begin, weights.size()));
  }
  return result;
}

void FaultSearch::try_lags() {
  constexpr double max_lag = 0.5, coarse = 0.02, min_lag = 0.03;  // [s]
  const int nv = base_.nv;
  const double period = record_.period;
  const auto squares_at = [&](int joint, double lag) {
    const auto by = static_cast<Eigen::Index>(std::lround(lag / period));
    return left(rows_with_torques(base_, [&](RowMatrix& tau) {
      for (int k = joint < 0 ? 0 : joint; k < (joint < 0 ? nv : joint + 1); ++k)
        tau.col(k) = shifted_torque(k, by);
    }));
  };
  for (int joint = -1; joint < nv; ++joint) {
    double best = 0.0, squares = std::numeric_limits<double>::infinity();
    const auto look = [&](double lag) {
      if (const double now = squares_at(joint, lag); now < squares) squares = now, best = lag;
    };
    for (double lag = -max_lag; lag <= max_lag + 1e-9; lag += coarse) look(lag);
    const double middle = best;
    for (double lag = middle - coarse; lag <= middle + coarse; lag += coarse / 5.0) look(lag);
    if (std::abs(best) < min_lag || std::abs(best) > max_lag - coarse) continue;
    consider((joint < 0 ? "all torques are " : in_quotes(tau_column(model_, joint)) + " is ") +
                 number(std::abs(best)) + " s " +
                 (best > 0.0 ? "behind the positions" : "ahead of the positions") +
                 "; wanted torques and positions of the same instants",
             squares);
  }
}

/// Omits one torque at a time. If the other torques fit the motion, the omitted column has a fault.
void FaultSearch::try_single_torques() {
  const Eigen::VectorXd weight = weight_;
  for (int k = 0; k < base_.nv; ++k) {
    for (int s = 0; s < base_.samples; ++s)
      weight_[static_cast<Eigen::Index>(s) * base_.nv + k] = 0.0;
    const double squares = left(rows(base_));
    weight_ = weight;
    consider("all torques except " + in_quotes(tau_column(model_, k)) +
                 " fit; is that sensor broken or does the column belong to another joint?",
             squares, true);
  }
}

}  // namespace burnish::identify_detail
