#include "ocp/check_point.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/to_size.hpp"
#include "derivatives/check_differences.hpp"
#include "derivatives/check_units.hpp"

namespace burnish::ocp {
namespace {

/// Largest angle of a rotation residual at which finite differences are safe [rad]; chosen by hand.
constexpr double max_angle = std::numbers::pi - 0.1;
/// Smallest step of the extrapolated differences (check_differences.cpp), in units of
/// check_units().
constexpr double difference_step = 2e-4;

/// Returns the smallest divisor of relative errors: a thousandth of the largest value.
double floor_of(const Eigen::VectorXd& values) {
  return std::max(1e-9, 1e-3 * (values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff()));
}

/// Returns the derivative of a knot's next state by z as a full matrix, ndx x nz.
Eigen::MatrixXd dense_dynamics(const StateShape& shape, const KnotExpansion& knot, int nu) {
  const int nz = nu + shape.ndx, nv = shape.nv;
  const Eigen::Map<const RowMatrix, 0, Eigen::OuterStride<>> given(
      knot.dynamics, knot.form == DynamicsForm::Dense ? shape.ndx : nv, nz,
      Eigen::OuterStride<>(knot.stride));
  if (knot.form == DynamicsForm::Dense) return given;
  Eigen::MatrixXd F = Eigen::MatrixXd::Zero(shape.ndx, nz);
  F.middleRows(nv, nv) = given;
  F.topRows(nv) = knot.step * given;
  F.block(0, nu, nv, nv) += Eigen::MatrixXd::Identity(nv, nv);
  const double* tangent_blocks = knot.tangent_blocks;
  for (const NonEuclideanBlock& block : shape.blocks) {
    const int n = block.size;
    const Eigen::Map<const RowMatrix> A(tangent_blocks, n, n), B(tangent_blocks + n * n, n, n);
    F.middleRows(block.first, n) = knot.step * B * given.middleRows(block.first, n);
    F.block(block.first, nu + block.first, n, n) += A;
    tangent_blocks += 2 * n * n;
  }
  for (int i = 0; i < shape.filtered; ++i) {
    if (nu > 0) F(2 * nv + i, i) = 1.0 - knot.decay[i];
    F(2 * nv + i, nu + 2 * nv + i) = knot.decay[i];
  }
  return F;
}

}  // namespace

Eigen::VectorXd check_units(const Problem& problem, int nu) {
  constexpr double usual_torque = 200.0, usual_force = 200.0;  // robot of 20 kg, 1 m [Nm, N]
  const StateLayout& l = problem.layout();
  const CheckUnits units(problem.model());
  const auto torque = [&](int i) { return units.torque[l.actuated[to_size(i)]] / usual_torque; };
  Eigen::VectorXd z(nu + l.ndx());
  for (int i = 0; i < nu; ++i) z[i] = torque(i);
  z.segment(nu, l.nv) = z.segment(nu + l.nv, l.nv) = units.motion;
  for (int i = 0; i < l.filtered; ++i) z[nu + 2 * l.nv + i] = torque(i);
  z.tail(l.force_states).setConstant(units.force / usual_force);
  return z;
}

CheckPoint::CheckPoint(Problem& problem, int knot, Eigen::VectorXd x, Eigen::VectorXd u)
    : problem_(problem),
      knot_(knot),
      nu_(problem.controls(knot)),
      nz_(nu_ + problem.state().ndx),
      units_(check_units(problem, nu_)),
      x_(std::move(x)),
      u_(std::move(u)),
      costs_(static_cast<int>(ProblemInside::of(problem).stage(knot).costs)),
      terms_(ProblemInside::of(problem).stage(knot).terms) {
  int row = knot == problem.knots() ? 0 : problem.state().ndx;
  for (const CompiledTerm& term : terms_) {
    first_row_.push_back(row);
    row += term.rows;
  }
  first_row_.push_back(row);
  next_ = Eigen::VectorXd::Zero(problem.state().nx);
  status_ = problem.roll(0, knot, x_.data(), u_.data(), next_.data()).status;
  if (!is_usable(status_)) return;
  here_ = stacked(x_, u_);
  expand();
}

Eigen::VectorXd CheckPoint::stacked(const Eigen::VectorXd& x, const Eigen::VectorXd& u) {
  Eigen::VectorXd result(first_row_.back() + costs_);
  Eigen::VectorXd next(x.size());
  const Status status = problem_.roll(0, knot_, x.data(), u.data(), next.data()).status;
  if (!is_usable(status))
    return Eigen::VectorXd::Constant(result.size(), std::numeric_limits<double>::quiet_NaN());
  if (knot_ < problem_.knots()) problem_.difference(next_.data(), next.data(), result.data());
  const std::vector<double> costs = problem_.term_costs(knot_, x.data(), u.data());
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const int term = static_cast<int>(t);
    result.segment(first_row(term), terms_[t].rows) = problem_.residual(knot_, term, x, u);
    if (term < costs_) result[cost_row(term)] = costs[t];
  }
  return result;
}

Eigen::VectorXd CheckPoint::moved(int k, double h) {
  const auto cached = cache_.find({k, h});
  if (cached != cache_.end()) return cached->second;
  Eigen::VectorXd x = x_, u = u_;
  if (k < nu_) {
    u[k] += h * units_[k];
  } else {
    const Eigen::VectorXd dx = h * units_[k] * Eigen::VectorXd::Unit(problem_.state().ndx, k - nu_);
    problem_.integrate(x_.data(), dx.data(), x.data());
  }
  return cache_.emplace(std::pair{k, h}, stacked(x, u)).first->second;
}

Eigen::MatrixXd CheckPoint::differences(int first, int count) {
  const Eigen::MatrixXd in_units = extrapolated_differences(
      [&](int k, double h) { return Eigen::VectorXd(moved(k, h).segment(first, count)); }, nz_,
      count);
  return in_units * units_.cwiseInverse().asDiagonal();
}

std::vector<DerivativeBlock> CheckPoint::split(const std::string& name,
                                               const std::vector<std::string>& rows,
                                               const Eigen::MatrixXd& value,
                                               const Eigen::MatrixXd& expected, double floor,
                                               const Eigen::VectorXd& row_units) const {
  const StateShape& shape = problem_.state();
  std::vector<std::string> names = nu_ > 0 ? problem_.control_names() : std::vector<std::string>{};
  for (std::string& control : names) control.insert(0, "u ");
  for (const std::string& state : problem_.state_names()) names.push_back(state);
  std::vector<DerivativeBlock> blocks;
  int first = 0;
  const auto add = [&](const char* by, int count) {
    if (count > 0)
      blocks.push_back({"d" + name + "_d" + by,
                        rows,
                        {names.begin() + first, names.begin() + first + count},
                        value.middleCols(first, count),
                        expected.middleCols(first, count),
                        floor,
                        0.0,
                        row_units,
                        units_.segment(first, count)});
    first += count;
  };
  add("u", nu_);
  add("q", shape.nv);
  add("v", shape.nv);
  add("tau", problem_.layout().filtered);
  add("force", problem_.layout().force_states);
  return blocks;
}

void CheckPoint::expand() {
  const StateShape& shape = problem_.state();
  const auto knots = to_size(problem_.knots() + 1);
  const int stride = shape.ndx + problem_.max_controls();
  std::vector<double> x(knots * to_size(shape.nx)), next = x;
  std::vector<double> u(knots * to_size(problem_.max_controls()));
  std::copy_n(x_.data(), shape.nx, x.data() + static_cast<std::ptrdiff_t>(knot_) * shape.nx);
  std::copy_n(u_.data(), nu_,
              u.data() + static_cast<std::ptrdiff_t>(knot_) * problem_.max_controls());
  std::vector<KnotValue> values(knots);
  std::vector<KnotExpansion> out(knots);
  Eigen::VectorXd decay(shape.filtered);
  RowMatrix hessian(stride, stride), dynamics(stride, stride);
  int tangent_size = 0;
  for (const NonEuclideanBlock& block : shape.blocks) tangent_size += 2 * block.size * block.size;
  Eigen::VectorXd tangent_blocks(tangent_size);
  gradient_.resize(stride);
  KnotExpansion& knot = out[to_size(knot_)];
  knot.stride = stride;
  knot.gradient = gradient_.data();
  knot.hessian = hessian.data();
  knot.dynamics = dynamics.data();
  knot.tangent_blocks = tangent_blocks.data();
  knot.decay = decay.data();
  RowMatrix coefficients(problem_.rows(knot_), stride);
  Eigen::VectorXd row_values(problem_.rows(knot_));
  knot.rows = coefficients.data();
  knot.row_values = row_values.data();
  problem_.expand(0, {knot_, knot_ + 1}, {x.data(), u.data()}, next.data(), values.data(),
                  out.data());
  gradient_.conservativeResize(nz_);
  if (knot_ < problem_.knots()) dynamics_ = dense_dynamics(shape, knot, nu_);
  rows_ = RowMatrix::Zero(problem_.rows(knot_), nz_);
  for (int r = 0, next_row = 0; r < problem_.rows(knot_); ++r) {
    if (const int entry = problem_.row_entry(knot_)[r]; entry >= 0)
      rows_(r, entry) = 1.0;
    else
      rows_.row(r) = coefficients.row(next_row++).head(nz_);
  }
}

std::vector<DerivativeBlock> CheckPoint::next_state() {
  const int ndx = problem_.state().ndx;
  return split("next", problem_.state_names(), dynamics_, differences(0, ndx), 1e-5,
               units_.tail(ndx));
}

std::vector<DerivativeBlock> CheckPoint::residual(int term) {
  const int rows = term_at(term).rows;
  const Eigen::MatrixXd J = problem_.residual_derivative(knot_, term, x_, u_).rightCols(nz_);
  return split("r", row_names(problem_, term_at(term)), J, differences(first_row(term), rows),
               floor_of(here_.segment(first_row(term), rows)));
}

bool CheckPoint::near_breakpoint(int term) const {
  const CompiledTerm& compiled = term_at(term);
  if (compiled.penalty != Penalty::Kind::Barrier && compiled.penalty != Penalty::Kind::LogBarrier)
    return false;
  const RowMatrix J = problem_.residual_derivative(knot_, term, x_, u_);
  const double width = compiled.penalty == Penalty::Kind::LogBarrier ? compiled.width : 0.0;
  for (int i = 0; i < compiled.rows; ++i) {
    const double r = here_[first_row(term) + i];
    const auto row = to_size(i);
    const double distance = std::min(std::abs(r - compiled.lower[row] - width),
                                     std::abs(r - compiled.upper[row] + width));
    const double largest_change =
        J.row(i).tail(nz_).transpose().cwiseProduct(units_).cwiseAbs().maxCoeff();
    if (distance < 2.0 * difference_step * largest_change) return true;
  }
  return false;
}

std::vector<DerivativeBlock> CheckPoint::cost(int term) {
  if (near_breakpoint(term)) return {};
  // Builds a stage with only this term, so that the usual code computes the term's gradient.
  auto& impl = ProblemInside::of(problem_);
  CompiledStage alone = impl.stage(knot_);
  alone.terms = {term_at(term)};
  alone.costs = 1;
  alone.row_lower.clear();
  NodeKernel<double>& kernel = impl.worker(0).one;
  kernel.expand(alone, x_.data(), u_.data(), impl.targets_of(knot_), impl.when(knot_));
  const Eigen::Map<const Eigen::RowVectorXd> all(kernel.gradient.data(), problem_.layout().nz());
  return split("cost", {term_at(term).name}, all.tail(nz_), differences(cost_row(term), 1),
               floor_of(here_.segment(cost_row(term), 1)));
}

std::vector<DerivativeBlock> CheckPoint::all_costs() {
  for (int t = 0; t < costs_; ++t)
    if (near_breakpoint(t)) return {};
  const Eigen::RowVectorXd expected = differences(cost_row(0), costs_).colwise().sum();
  return split("cost", {"sum"}, gradient_.transpose(), expected,
               floor_of(here_.segment(cost_row(0), costs_)));
}

std::vector<DerivativeBlock> CheckPoint::constraint(int term) {
  const int rows = term_at(term).rows;
  return split("c", row_names(problem_, term_at(term)),
               rows_.block(term_at(term).first_row, 0, rows, nz_),
               differences(first_row(term), rows), floor_of(here_.segment(first_row(term), rows)));
}

bool CheckPoint::near_half_turn() const {
  for (std::size_t t = 0; t < terms_.size(); ++t) {
    const Eigen::VectorXd r = here_.segment(first_row_[t], terms_[t].rows);
    if (terms_[t].load != CompiledTerm::Load::Plain && r.tail<3>().norm() > max_angle) return true;
  }
  return false;
}

}  // namespace burnish::ocp
