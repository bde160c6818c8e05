// Problems for the solver's tests: knots given as functions, and random linear-quadratic problems.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "burnish/base/views.hpp"
#include "burnish/solver/shooting_problem.hpp"

namespace burnish::testing {

struct TestKnot {
  int nu = 0;
  /// Cost; writes the next state unless `next` is null.
  std::function<double(const double* x, const double* u, double* next)> roll;
  std::function<void(const double* x, const double* u, KnotExpansion& out)> expand;
};

/// Problem over a vector space whose knots are functions. Its cost has two terms: 'work' has the
/// whole cost, 'nothing' is zero.
class TestProblem final : public ShootingProblem {
 public:
  StateShape shape;
  std::vector<TestKnot> stages;  ///< N + 1
  std::vector<double> start;
  std::vector<std::vector<double>> lower, upper;  ///< per knot; empty: unbounded
  int max_nu = 0;
  /// Limits of the rows of every knot; the rows are the entries of the state.
  std::vector<double> row_limits_below, row_limits_above;
  std::vector<double> row_scales, row_l1_weights, row_quadratic_weights;
  int poisoned_knot = -1;  ///< knot whose term 'nothing' is NaN
  int poisoned_derivatives = -1;
  mutable int prepared = 0;

  void close() {
    for (const TestKnot& k : stages) max_nu = std::max(max_nu, k.nu);
    ranges_.clear();
    for (int k = 0; k < knots(); k += 3) ranges_.push_back({k, std::min(knots(), k + 3)});
    ranges_.push_back({knots(), knots() + 1});
  }

  const StateShape& state() const override { return shape; }
  int knots() const override { return static_cast<int>(stages.size()) - 1; }
  int controls(int knot) const override { return stages[knot].nu; }
  int max_controls() const override { return max_nu; }
  const double* initial_state() const override { return start.data(); }
  void integrate(const double* x, const double* dx, double* out) const override {
    for (int i = 0; i < shape.ndx; ++i) out[i] = x[i] + dx[i];
  }
  void difference(const double* x0, const double* x1, double* dx) const override {
    for (int i = 0; i < shape.ndx; ++i) dx[i] = x1[i] - x0[i];
  }
  const double* control_lower(int knot) const override {
    return lower.empty() ? nullptr : lower[knot].data();
  }
  const double* control_upper(int knot) const override {
    return upper.empty() ? nullptr : upper[knot].data();
  }
  int rows(int /*knot*/) const override { return static_cast<int>(row_limits_below.size()); }
  int max_rows() const override { return rows(0); }
  const double* row_lower(int /*knot*/) const override { return row_limits_below.data(); }
  const double* row_upper(int /*knot*/) const override { return row_limits_above.data(); }
  const double* row_scale(int /*knot*/) const override { return row_scales.data(); }
  const double* row_l1_weight(int /*knot*/) const override { return row_l1_weights.data(); }
  const double* row_quadratic_weight(int /*knot*/) const override {
    return row_quadratic_weights.data();
  }
  std::vector<std::string> row_names(int knot) const override {
    return numbered("limit/x", rows(knot));
  }
  std::vector<double> row_values(int knot, const double* x, const double* /*u*/) override {
    return {x, x + rows(knot)};
  }
  void prepare(int workers) override { prepared = workers; }
  std::span<const KnotRange> ranges() const override { return ranges_; }

  KnotValue roll(int /*worker*/, int knot, const double* x, const double* u, double* next,
                 double* row_values = nullptr) override {
    KnotValue value{stages[knot].roll(x, u, next), Status::Ok, -1};
    if (row_values != nullptr) std::copy_n(x, rows(knot), row_values);
    if (knot == poisoned_knot) value = {std::nan(""), Status::NotFinite, 1};
    return value;
  }
  void evaluate(int worker, KnotRange range, TrajectoryView at, double* next, KnotValue* values,
                double* row_values) override {
    for (int k = range.begin; k < range.end; ++k)
      values[k] = roll(worker, k, at.x + k * shape.nx, at.u + k * max_nu,
                       k < knots() ? next + k * shape.nx : nullptr,
                       row_values != nullptr ? row_values + k * max_rows() : nullptr);
  }
  void expand(int worker, KnotRange range, TrajectoryView at, double* next, KnotValue* values,
              KnotExpansion* out) override {
    evaluate(worker, range, at, next, values, nullptr);
    for (int k = range.begin; k < range.end; ++k) {
      stages[k].expand(at.x + k * shape.nx, at.u + k * max_nu, out[k]);
      for (int r = 0; r < rows(k); ++r) {
        out[k].row_values[r] = at.x[k * shape.nx + r];
        std::fill_n(out[k].rows + r * out[k].stride, stages[k].nu + shape.ndx, 0.0);
        out[k].rows[r * out[k].stride + stages[k].nu + r] = 1.0;
      }
      if (k == poisoned_derivatives) out[k].hessian[0] = std::nan("");
    }
  }

  std::vector<std::string> state_names() const override { return numbered("x", shape.ndx); }
  std::vector<std::string> control_names() const override { return numbered("u", max_nu); }
  std::vector<std::string> term_names(int /*knot*/) const override { return {"work", "nothing"}; }
  std::vector<double> term_costs(int knot, const double* x, const double* u) override {
    std::vector<double> next(start.size());
    return {stages[knot].roll(x, u, knot < knots() ? next.data() : nullptr), 0.0};
  }
  std::string knot_name(int knot) const override { return "stage, knot " + std::to_string(knot); }

 private:
  static std::vector<std::string> numbered(const char* letter, int count) {
    std::vector<std::string> names;
    for (int i = 0; i < count; ++i) names.push_back(letter + std::to_string(i));
    return names;
  }
  std::vector<KnotRange> ranges_;
};

struct LqSpec {
  int nv = 0;  ///< 0: unstructured, with `ndx` entries
  int filtered = 0;
  int ndx = 4;
  std::vector<NonEuclideanBlock> blocks = {};
  std::vector<int> nu;  ///< controls per knot; 0 is an impact
  DynamicsForm form = DynamicsForm::Dense;
  unsigned seed = 1;
};

/// f = F z + c, l = 1/2 z^T H z + h^T z with z = (u, x).
struct LqStage {
  RowMatrix F, P, H;
  Eigen::VectorXd c, h, decay;
  std::vector<RowMatrix> A, B;
  double step = 0.0;
  int nu = 0;
};

struct LqProblem {
  std::vector<LqStage> stages;
  TestProblem problem;
};

inline LqStage random_stage(const LqSpec& spec, const StateShape& shape, int nu,
                            std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&](int rows, int columns) {
    return RowMatrix(RowMatrix::NullaryExpr(rows, columns, [&] { return normal(random); }));
  };
  LqStage s;
  s.nu = nu;
  const int ndx = shape.ndx;
  const int nz = nu + ndx;
  const RowMatrix root = draw(nz, nz);
  s.H = root * root.transpose() / nz + 0.1 * RowMatrix::Identity(nz, nz);
  s.h = draw(nz, 1);
  s.c = 0.3 * draw(ndx, 1);
  const int nv = spec.nv;
  if (nv == 0) {
    s.F = draw(ndx, nz) / std::sqrt(nz);
    return s;
  }
  s.step = nu == 0 ? 0.0 : 0.1;
  s.P = draw(nv, nz) / std::sqrt(nz);
  s.F = RowMatrix::Zero(ndx, nz);
  RowMatrix A = RowMatrix::Identity(nv, nv);
  RowMatrix B = A;
  for (const NonEuclideanBlock& b : spec.blocks) {
    s.A.emplace_back(RowMatrix::Identity(b.size, b.size) + 0.3 * draw(b.size, b.size));
    s.B.emplace_back(RowMatrix::Identity(b.size, b.size) + 0.3 * draw(b.size, b.size));
    A.block(b.first, b.first, b.size, b.size) = s.A.back();
    B.block(b.first, b.first, b.size, b.size) = s.B.back();
  }
  s.F.middleRows(nv, nv) = s.P;
  s.F.topRows(nv) = s.step * B * s.P;
  s.F.block(0, nu, nv, nv) += A;
  s.decay = (0.5 + 0.1 * draw(spec.filtered, 1).array()).matrix();
  for (int i = 0; i < spec.filtered; ++i) {
    s.F(2 * nv + i, nu + 2 * nv + i) = s.decay[i];
    if (i < nu) s.F(2 * nv + i, i) = 1.0 - s.decay[i];
  }
  return s;
}

inline void fill_expansion(const LqStage& s, const Eigen::VectorXd& z, DynamicsForm form,
                           bool terminal, KnotExpansion& out) {
  const Eigen::VectorXd gradient = s.H * z + s.h;
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    out.gradient[i] = gradient[i];
    for (Eigen::Index j = 0; j <= i; ++j) out.hessian[i * out.stride + j] = s.H(i, j);
  }
  if (terminal) return;
  out.form = form;
  out.step = s.step;
  const RowMatrix& dynamics = form == DynamicsForm::Dense ? s.F : s.P;
  for (Eigen::Index i = 0; i < dynamics.rows(); ++i)
    for (Eigen::Index j = 0; j < z.size(); ++j) out.dynamics[i * out.stride + j] = dynamics(i, j);
  if (form == DynamicsForm::Dense) return;
  double* tangent_blocks = out.tangent_blocks;
  for (std::size_t b = 0; b < s.A.size(); ++b) {
    tangent_blocks = std::copy(s.A[b].data(), s.A[b].data() + s.A[b].size(), tangent_blocks);
    tangent_blocks = std::copy(s.B[b].data(), s.B[b].data() + s.B[b].size(), tangent_blocks);
  }
  std::copy(s.decay.data(), s.decay.data() + s.decay.size(), out.decay);
}

/// Roll and expand allocate, so this problem is not for tests that count allocations.
inline LqProblem random_lq(const LqSpec& spec) {
  LqProblem lq;
  StateShape& shape = lq.problem.shape;
  shape.ndx = shape.nx = spec.nv > 0 ? 2 * spec.nv + spec.filtered : spec.ndx;
  shape.nv = spec.nv;
  shape.filtered = spec.filtered;
  shape.blocks = spec.blocks;
  std::mt19937 random(spec.seed);
  std::vector<int> nu = spec.nu;
  nu.push_back(0);
  for (std::size_t k = 0; k < nu.size(); ++k)
    lq.stages.push_back(random_stage(spec, shape, nu[k], random));
  const auto join = [ndx = shape.ndx](const LqStage& s, const double* x, const double* u) {
    Eigen::VectorXd z(s.nu + ndx);
    z.head(s.nu) = Eigen::Map<const Eigen::VectorXd>(u, s.nu);
    z.tail(ndx) = Eigen::Map<const Eigen::VectorXd>(x, ndx);
    return z;
  };
  for (std::size_t k = 0; k < nu.size(); ++k) {
    const LqStage& s = lq.stages[k];
    const bool terminal = k + 1 == nu.size();
    lq.problem.stages.push_back({s.nu,
                                 [s, join](const double* x, const double* u, double* next) {
                                   const Eigen::VectorXd z = join(s, x, u);
                                   if (next != nullptr)
                                     Eigen::Map<Eigen::VectorXd>(next, s.F.rows()) = s.F * z + s.c;
                                   return 0.5 * z.dot(s.H * z) + s.h.dot(z);
                                 },
                                 [s, join, form = spec.form, terminal](
                                     const double* x, const double* u, KnotExpansion& out) {
                                   fill_expansion(s, join(s, x, u), form, terminal, out);
                                 }});
  }
  std::normal_distribution<double> normal;
  for (int i = 0; i < shape.nx; ++i) lq.problem.start.push_back(normal(random));
  lq.problem.close();
  return lq;
}

}  // namespace burnish::testing
