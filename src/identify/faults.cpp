#include "identify/faults.hpp"

#include <cmath>

#include "base/decomposition.hpp"
#include "base/sentence.hpp"

namespace burnish::identify_detail {
namespace {

/// A fault is convincing if it reduces the squared residual minus noise to less than this fraction
/// (the rms to a fifth). Effects that no fault describes, such as friction, remain in the residual.
constexpr double convincing = 1.0 / 25.0;
/// A mild fault, which does not reject the record, must reduce the squared residual minus noise to
/// less than this fraction (the rms to a half).
constexpr double worth_a_hint = 1.0 / 4.0;
/// A later fault must reduce the squared residual to less than this fraction of the squared
/// residual with an earlier, simpler fault.
constexpr double better = 0.7;

}  // namespace

FaultSearch::FaultSearch(const Model& model, const MotionRecord& record, const Windows& windows,
                         std::span<const Unknown> unknowns, const IdentificationSpec& spec)
    : model_(model),
      record_(record),
      windows_(windows.coarse()),
      unknowns_(unknowns),
      spec_(spec),
      base_(regression(model, record, spec)) {
  // Divides each torque by its rms. A torque with an rms far below the largest rms counts little.
  constexpr double min_fraction = 0.02;
  const Eigen::Map<const RowMatrix> torques(base_.measured.data(), base_.samples, base_.nv);
  const Eigen::VectorXd size =
      torques.cwiseAbs2().colwise().mean().transpose().cwiseSqrt().array() + 1e-12;
  weight_ = (size.array() + min_fraction * size.maxCoeff())
                .square()
                .inverse()
                .matrix()
                .replicate(base_.samples, 1);
}

std::optional<Fault> FaultSearch::best(const Eigen::VectorXd& x, const Eigen::VectorXd& expected) {
  reference_ = weighted(base_.residual(x));
  // Factor on the squared noise, because a mean over few instants is noisier (on arm7, 1.5 times).
  constexpr double of_few_instants = 2.0;
  noise_ = of_few_instants * weighted(expected.replicate(base_.samples, 1));
  try_negative_mass();
  try_torque_columns();
  try_position_columns();
  try_position_units();
  try_period();
  try_gains();
  try_lags();
  try_gravity();
  try_options();
  try_encoder_offsets();
  try_payload_change();
  if (!best_) try_single_torques();
  return best_;
}

/// Tries negative and impossible masses, which fit the record of a robot lighter than its model.
void FaultSearch::try_negative_mass() {
  const double as_it_is = left(rows(base_), &solution_);
  const double mass = solution_[0];
  const std::string of = in_quotes(unknowns_.front().frame);
  consider(mass < 0.0 && !unknowns_.front().replaces
               ? "only a mass of " + number(mass) + " kg at " + of +
                     " explains the torques; does the model contain a part that was not mounted on "
                     "the robot?"
               : "the torques require a physically impossible mass distribution at " + of +
                     "; are the masses of the model's links wrong?",
           as_it_is);
  reference_ = std::min(reference_, as_it_is);
}

void FaultSearch::consider(const std::string& sentence, double squares, bool is_mild) {
  const double beyond = std::max(0.0, squares - noise_), of = reference_ - noise_;
  if (!(beyond < (is_mild ? worth_a_hint : convincing) * of)) return;
  const double left = std::max(squares, noise_);
  if (best_ && !(left < better * best_->squares)) return;
  best_ = Fault{sentence, is_mild, left};
}

Rows FaultSearch::rows(const Regression& of) {
  Rows result{Eigen::MatrixXd(of.rest.size(), of.Y.cols() + of.linear.cols()), of.rest};
  result.A << of.Y, of.linear;
  return result;
}

double FaultSearch::weighted(const Eigen::VectorXd& residual) const {
  return (weight_.array() * residual.array().square()).sum();
}

double FaultSearch::left(const Rows& rows, Eigen::VectorXd* solution) const {
  const Eigen::VectorXd root = weight_.cwiseSqrt();
  Eigen::MatrixXd A = root.asDiagonal() * rows.A;
  const Eigen::VectorXd scale =
      (A.colwise().norm().array() + 1e-300).inverse().matrix().transpose();
  A = A * scale.asDiagonal();
  Eigen::MatrixXd information = A.transpose() * A;
  information.diagonal().array() += 1e-10;  // Allows linearly dependent columns
  const Eigen::VectorXd x =
      scale.asDiagonal() *
      solve_positive(information, A.transpose() * root.cwiseProduct(rows.b)).col(0);
  if (solution != nullptr) *solution = x;
  const double squares = weighted(rows.b - rows.A * x);
  return std::isfinite(squares) ? squares : std::numeric_limits<double>::infinity();
}

Regression FaultSearch::regression(const Model& model, const MotionRecord& record,
                                   const IdentificationSpec& spec) const {
  const SmoothedMotion motion(model, record, windows_, windows_.motion);
  return {model, motion, windows_, unknowns_, spec};
}

Regression FaultSearch::with_positions(const Change& change) const {
  MotionRecord changed = record_;
  change(changed.q);
  return regression(model_, changed, spec_);
}

Eigen::VectorXd FaultSearch::with_torques(const Eigen::VectorXd& rows, const Change& change) const {
  RowMatrix columns = Eigen::Map<const RowMatrix>(rows.data(), base_.samples, base_.nv);
  change(columns);
  return Eigen::Map<const Eigen::VectorXd>(columns.data(), columns.size());
}

Rows FaultSearch::rows_with_torques(const Regression& of, const Change& change) const {
  Rows result = rows(of);
  result.b += with_torques(of.measured, change) - of.measured;
  if (of.layout.delay >= 0) {
    const Eigen::VectorXd rate = result.A.col(of.layout.delay);
    result.A.col(of.layout.delay) = with_torques(rate, change);
  }
  return result;
}

}  // namespace burnish::identify_detail
