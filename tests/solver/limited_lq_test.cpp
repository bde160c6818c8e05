// Linear-quadratic problems with limits, compared with an interior-point method.
#include "solver/limited_lq.hpp"

#include <gtest/gtest.h>

#include "solver/interior_point.hpp"
#include "solver/test_problem.hpp"

namespace burnish::testing {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct LimitedSpec {
  const char* name;
  LqSpec lq;
  int rows = 0;
  double slack = 1.0;                   ///< mean distance of limits from a feasible point
  double one_sided = 0.3, equal = 0.0;  ///< fractions of rows
  int entries = 0;                      ///< number of leading rows that are entries of dx
};

void PrintTo(const LimitedSpec& spec, std::ostream* out) { *out << spec.name; }

/// Problem with limits, in the memory layout of the solver.
struct LimitedProblem {
  LqProblem lq;
  int N, ndx, nu_max, rows, entries;
  StateShape shape;
  RiccatiRecursion recursion;
  RiccatiLayout layout;
  std::vector<MatrixXd> C;             ///< rows x nz
  std::vector<VectorXd> lower, upper;  ///< limits of controls, then of rows
  std::vector<Buffer> memory;
  std::vector<KnotExpansion> expansions;
  std::vector<int> controls, row_counts;
  std::vector<ValueStorage> values;
  std::vector<PolicyStorage> policies;
  Buffer gaps, hessian_gaps;

  explicit LimitedProblem(const LimitedSpec& spec)
      : lq(random_lq(spec.lq)),
        N(lq.problem.knots()),
        ndx(lq.problem.shape.ndx),
        nu_max(lq.problem.max_nu),
        rows(spec.rows),
        entries(spec.entries),
        shape(lq.problem.shape),
        recursion(shape, nu_max),
        layout(recursion.layout()) {
    fill(spec.lq.form);
    limit(spec);
  }

  Buffer& storage(std::size_t size) {
    memory.emplace_back(size + 64);
    return memory.back();
  }

  void fill(DynamicsForm form) {
    const auto S = static_cast<std::size_t>(layout.expansion_stride);
    const auto vs = static_cast<std::size_t>(layout.value_stride);
    const auto knots = static_cast<std::size_t>(N) + 1;
    gaps = Buffer((knots + 1) * vs);
    hessian_gaps = Buffer((knots + 1) * vs);
    for (std::size_t k = 0; k < knots; ++k) {
      const LqStage& s = lq.stages[k];
      controls.push_back(s.nu);
      row_counts.push_back(rows - entries);
      KnotExpansion e;
      e.stride = layout.expansion_stride;
      e.gradient = storage(S).data();
      e.hessian = storage(S * static_cast<std::size_t>(layout.expansion_rows)).data();
      e.dynamics = storage(S * static_cast<std::size_t>(ndx + dense::lanes)).data();
      e.tangent_blocks = storage(512).data();
      e.decay = storage(64).data();
      e.rows = storage(S * static_cast<std::size_t>(rows + 8)).data();
      fill_expansion(s, VectorXd::Zero(s.nu + ndx), form, k + 1 == knots, e);
      expansions.push_back(e);
      double* value = storage(vs * static_cast<std::size_t>(ndx + 1)).data();
      values.push_back({value, value + vs});
      const auto gs = static_cast<std::size_t>(layout.gain_stride);
      double* policy = storage(gs * static_cast<std::size_t>(nu_max + 2 + dense::lanes)).data();
      policies.push_back({policy, policy + gs});
      double* gap = gaps.data() + k * vs;
      for (int i = 0; i < ndx; ++i)
        gap[i] = k == 0 ? lq.problem.start[static_cast<std::size_t>(i)] : lq.stages[k - 1].c[i];
    }
  }

  /// Sets limits around a random trajectory that satisfies them.
  void limit(const LimitedSpec& spec) {
    std::mt19937 random(spec.lq.seed + 100);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    VectorXd x = Eigen::Map<const VectorXd>(lq.problem.start.data(), ndx);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(N); ++k) {
      const LqStage& s = lq.stages[k];
      VectorXd z(s.nu + ndx);
      z << VectorXd::NullaryExpr(s.nu, [&] { return normal(random); }), x;
      C.push_back(MatrixXd::NullaryExpr(rows, z.size(), [&] { return normal(random); }));
      for (Eigen::Index r = 0; r < entries; ++r)
        C[k].row(r) = Eigen::RowVectorXd::Unit(z.size(), s.nu + r);
      for (Eigen::Index r = entries; r < rows; ++r)
        for (Eigen::Index c = 0; c < z.size(); ++c)
          expansions[k].rows[(r - entries) * expansions[k].stride + c] = C[k](r, c);
      VectorXd y(s.nu + rows);
      y << z.head(s.nu), C[k] * z;
      lower.push_back(y);
      upper.push_back(y);
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        if (k == 0 && i >= s.nu && i < s.nu + entries) {
          lower.back()[i] = -1e300;
          upper.back()[i] = 1e300;
          continue;
        }
        if (i >= s.nu && uniform(random) < spec.equal) continue;
        lower.back()[i] -= spec.slack * uniform(random);
        upper.back()[i] += spec.slack * uniform(random);
        const double side = uniform(random);
        if (side < 0.5 * spec.one_sided) lower.back()[i] = -1e300;
        if (side > 1.0 - 0.5 * spec.one_sided) upper.back()[i] = 1e300;
      }
      // The first state is fixed: rows that depend only on it could not change.
      if (k < static_cast<std::size_t>(N)) x = s.F * z + s.c;
    }
  }

  LqHorizon view() {
    return {expansions,          controls, row_counts, gaps.data(), hessian_gaps.data(),
            layout.value_stride, values,   policies,   0.0};
  }

  /// Returns the place of the c-th control or row of a knot.
  int place(const LimitedLq& lqp, std::size_t knot, int c) const {
    const int behind = controls[knot] + entries;
    return c < behind ? c : lqp.first_row() + c - behind;
  }
  void set_limits(LimitedLq& lqp, double weight) const {
    for (int k = 0; k <= N; ++k) {
      const LimitedLq::Rows r = lqp.rows(k);
      const auto i = static_cast<std::size_t>(k);
      for (int c = 0; c < controls[i] + rows; ++c) {
        const int at = place(lqp, i, c);
        r.lower[at] = lower[i][c];
        r.upper[at] = upper[i][c];
        r.scale[at] = 1.0;
        r.weight[at] = weight;
        r.l1_weight[at] = 1e9;
        r.beyond[at] = 0.0;
        r.multiplier[at] = 0.0;
      }
    }
  }
};

/// Solution of the dense problem in all controls: their values, and the multipliers of each knot's
/// rows.
struct DenseSolution {
  std::vector<VectorXd> z, multiplier;
  bool converged = false;
};

DenseSolution dense_solution(const LimitedProblem& p) {
  int count = 0;
  for (int nu : p.controls) count += nu;
  MatrixXd H = MatrixXd::Zero(count, count);
  VectorXd g = VectorXd::Zero(count);
  std::vector<MatrixXd> by_u;  // z of each knot
  std::vector<VectorXd> at_zero;
  MatrixXd X = MatrixXd::Zero(p.ndx, count);
  VectorXd x = Eigen::Map<const VectorXd>(p.lq.problem.start.data(), p.ndx);
  struct Side {
    std::size_t knot;
    Eigen::Index row;
    double sign;
  };
  std::vector<Side> sides, equals;
  std::vector<VectorXd> left_side, left_side_equal;
  std::vector<double> right_side, right_side_equal;
  int first = 0;
  for (std::size_t k = 0; k < p.controls.size(); ++k) {
    const LqStage& s = p.lq.stages[k];
    MatrixXd Z = MatrixXd::Zero(s.nu + p.ndx, count);
    Z.topRows(s.nu).middleCols(first, s.nu).setIdentity();
    Z.bottomRows(p.ndx) = X;
    VectorXd z = VectorXd::Zero(s.nu + p.ndx);
    z.tail(p.ndx) = x;
    H += Z.transpose() * s.H * Z;
    g += Z.transpose() * (s.H * z + s.h);
    MatrixXd Y(s.nu + p.rows, s.nu + p.ndx);
    Y << MatrixXd::Identity(s.nu, s.nu + p.ndx), p.C[k];
    const MatrixXd rows = Y * Z;
    const VectorXd offset = Y * z;
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
      if (p.lower[k][r] == p.upper[k][r]) {
        equals.push_back({k, r, 1.0});
        left_side_equal.emplace_back(rows.row(r));
        right_side_equal.push_back(p.upper[k][r] - offset[r]);
        continue;
      }
      for (double sign : {-1.0, 1.0}) {
        const double limit = sign < 0.0 ? p.lower[k][r] : p.upper[k][r];
        if (std::abs(limit) > 1e299) continue;
        sides.push_back({k, r, sign});
        left_side.emplace_back(sign * rows.row(r).transpose());
        right_side.push_back(sign * (limit - offset[r]));
      }
    }
    by_u.push_back(Z);
    at_zero.push_back(z);
    if (k + 1 == p.controls.size()) break;
    X = s.F * Z;
    x = s.F * z + s.c;
    first += s.nu;
  }
  const auto matrix = [&](const std::vector<VectorXd>& rows) {
    MatrixXd m(static_cast<Eigen::Index>(rows.size()), count);
    for (std::size_t i = 0; i < rows.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = rows[i];
    return m;
  };
  const auto vector = [](const std::vector<double>& entries) {
    return VectorXd(
        Eigen::Map<const VectorXd>(entries.data(), static_cast<Eigen::Index>(entries.size())));
  };
  const QpSolution qp = solve_qp(H, g, matrix(left_side), vector(right_side),
                                 matrix(left_side_equal), vector(right_side_equal));
  DenseSolution answer;
  answer.converged = qp.converged;
  for (std::size_t k = 0; k < by_u.size(); ++k) {
    answer.z.emplace_back(by_u[k] * qp.x + at_zero[k]);
    answer.multiplier.emplace_back(VectorXd::Zero(p.controls[k] + p.rows));
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    answer.multiplier[sides[i].knot][sides[i].row] +=
        sides[i].sign * qp.multiplier[static_cast<Eigen::Index>(i)];
  for (std::size_t i = 0; i < equals.size(); ++i)
    answer.multiplier[equals[i].knot][equals[i].row] =
        qp.equal_multiplier[static_cast<Eigen::Index>(i)];
  return answer;
}

constexpr int never = 1000;

class LimitedLqLaw : public ::testing::TestWithParam<LimitedSpec> {};

/// Expects the dense solution; `interior_after` selects semismooth steps alone or the
/// interior-point method from the start.
void expect_solution(const LimitedSpec& spec, int interior_after) {
  LimitedProblem p(spec);
  LimitedLq lqp(p.shape, p.N, p.nu_max, p.rows);
  p.set_limits(lqp, 10.0);
  const LimitedLqResult result = lqp.solve(
      p.view(), p.recursion,
      {.factorizations = 200, .sweeps = 2000, .interior_after = interior_after, .tolerance = 1e-10},
      false);
  const DenseSolution wanted = dense_solution(p);
  EXPECT_TRUE(wanted.converged);
  EXPECT_TRUE(result.converged) << result.residual;
  int active = 0;
  for (int k = 0; k <= p.N; ++k) {
    const auto i = static_cast<std::size_t>(k);
    for (Eigen::Index c = 0; c < wanted.z[i].size(); ++c)
      EXPECT_NEAR(lqp.z(k)[c], wanted.z[i][c], 1e-8) << "knot " << k << ", entry " << c;
    for (Eigen::Index r = 0; r < wanted.multiplier[i].size(); ++r) {
      const int at = p.place(lqp, i, static_cast<int>(r));
      EXPECT_NEAR(lqp.rows(k).multiplier[at], wanted.multiplier[i][r], 1e-6)
          << "knot " << k << ", row " << r;
      active += std::abs(wanted.multiplier[i][r]) > 1e-6;
    }
  }
  std::printf("%-12s %d active, %d factorizations, %d sweeps\n", spec.name, active,
              result.factorizations, result.sweeps);
}

TEST_P(LimitedLqLaw, SemismoothSteps_GiveTheDenseSolution) { expect_solution(GetParam(), never); }

TEST_P(LimitedLqLaw, InteriorPointStart_GivesTheDenseSolution) { expect_solution(GetParam(), 0); }

std::vector<LimitedSpec> specs() {
  const auto structured = DynamicsForm::SecondOrder;
  return {
      {"dense", {.ndx = 5, .nu = {2, 2, 2, 2, 2, 2}}, 1},
      {"wide", {.ndx = 4, .nu = {5, 5, 5, 5}, .seed = 2}, 3},
      {"varying", {.ndx = 4, .nu = {1, 3, 0, 2, 3, 0, 1}, .seed = 3}, 1},
      {"second_order", {.nv = 3, .nu = std::vector<int>(10, 3), .form = structured, .seed = 4}, 1},
      {"arm", {.nv = 6, .nu = std::vector<int>(20, 6), .form = structured, .seed = 5}, 2},
      {"filter",
       {.nv = 3, .filtered = 3, .nu = std::vector<int>(6, 3), .form = structured, .seed = 6},
       1},
      {"tangent_blocks",
       {.nv = 9, .blocks = {{0, 6}, {7, 2}}, .nu = {3, 3, 3, 3}, .form = structured, .seed = 8},
       1},
      {"equalities",
       {.nv = 4, .nu = std::vector<int>(8, 4), .form = structured, .seed = 9},
       2,
       1.0,
       0.3,
       0.5},
      {"entries",
       {.nv = 3, .nu = std::vector<int>(10, 3), .form = structured, .seed = 10},
       7,
       0.5,
       0.3,
       0.0,
       6},
  };
}

TEST(LimitedLq, InteriorPointStartWithManyActiveRows_TakesFewFactorizations) {
  for (const LimitedSpec& spec : specs())
    for (unsigned seed = 100; seed < 110; ++seed) {
      LimitedSpec tight = spec;
      tight.lq.seed = seed;
      tight.slack *= 0.05;
      LimitedProblem p(tight);
      LimitedLq lqp(p.shape, p.N, p.nu_max, p.rows);
      p.set_limits(lqp, 1000.0);
      const LimitedLqResult result = lqp.solve(
          p.view(), p.recursion,
          {.factorizations = 200, .sweeps = 2000, .interior_after = 0, .tolerance = 1e-9}, false);
      EXPECT_TRUE(result.converged) << spec.name << ", seed " << seed << ": " << result.residual;
      EXPECT_LE(result.factorizations, 30) << spec.name << ", seed " << seed;
    }
}

TEST(LimitedLq, ManyActiveRowsAndSmallWeights_Converge) {
  for (const LimitedSpec& spec : specs())
    for (unsigned seed = 100; seed < 130; ++seed) {
      LimitedSpec other = spec;
      other.lq.seed = seed;
      other.slack *= 0.5;
      LimitedProblem p(other);
      LimitedLq lqp(p.shape, p.N, p.nu_max, p.rows);
      p.set_limits(lqp, 10.0);
      const LimitedLqResult result = lqp.solve(
          p.view(), p.recursion,
          {.factorizations = 200, .sweeps = 2000, .interior_after = never, .tolerance = 1e-9},
          false);
      EXPECT_TRUE(result.converged) << spec.name << ", seed " << seed << ": " << result.residual;
    }
}

/// Solves the problem, then the problem one knot later from that solution. Returns the second
/// result.
LimitedLqResult solve_a_knot_later(LimitedProblem p, bool shifted) {
  LimitedLq lqp(p.shape, p.N, p.nu_max, p.rows);
  const auto N = static_cast<std::size_t>(p.N);
  for (std::size_t k = N - 1; k <= N; ++k) {  // leaves the last two knots without limits
    p.lower[k].setConstant(-1e300);
    p.upper[k].setConstant(1e300);
  }
  p.set_limits(lqp, 10.0);
  const LimitedLqBudget budget{.factorizations = 200, .sweeps = 2000, .tolerance = 1e-8};
  EXPECT_TRUE(lqp.solve(p.view(), p.recursion, budget, false).converged);
  if (shifted) lqp.shift(p.controls);
  std::vector<VectorXd> multipliers, guesses;
  for (std::size_t k = 0; k <= N; ++k)
    multipliers.emplace_back(
        Eigen::Map<VectorXd>(lqp.rows(static_cast<int>(k)).multiplier, lqp.places()));
  for (std::size_t k = 0; k < N; ++k) {
    const PolicyStorage& policy = p.policies[shifted ? std::min(k + 1, N - 1) : k];
    guesses.emplace_back(Eigen::Map<VectorXd>(policy.feedforward, p.controls[k]));
  }
  const int vs = p.layout.value_stride;
  std::copy_n(lqp.z(1) + p.controls[1], p.ndx, p.gaps.data());
  std::copy_n(p.gaps.data() + 2 * vs, (p.N - 1) * vs, p.gaps.data() + vs);
  for (std::size_t k = 0; k + 1 < N; ++k) {
    p.expansions[k] = p.expansions[k + 1];
    p.lower[k] = p.lower[k + 1];
    p.upper[k] = p.upper[k + 1];
  }
  p.set_limits(lqp, 10.0);
  for (std::size_t k = 0; k <= N; ++k)
    std::copy_n(multipliers[k].data(), lqp.places(), lqp.rows(static_cast<int>(k)).multiplier);
  for (std::size_t k = 0; k < N; ++k)
    std::copy_n(guesses[k].data(), guesses[k].size(), p.policies[k].feedforward);
  return lqp.solve(p.view(), p.recursion, budget, true);
}

TEST(LimitedLq, ShiftedStart_TakesFewerFactorizationsOneKnotLater) {
  int shifted = 0, unshifted = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    LimitedSpec spec{
        "arm",
        {.nv = 6, .nu = std::vector<int>(20, 6), .form = DynamicsForm::SecondOrder, .seed = seed},
        2};
    const LimitedLqResult from_shifted = solve_a_knot_later(LimitedProblem(spec), true);
    const LimitedLqResult from_unshifted = solve_a_knot_later(LimitedProblem(spec), false);
    EXPECT_TRUE(from_shifted.converged && from_unshifted.converged) << "seed " << seed;
    EXPECT_LT(from_shifted.factorizations, from_unshifted.factorizations) << "seed " << seed;
    shifted += from_shifted.factorizations;
    unshifted += from_unshifted.factorizations;
  }
  std::printf("factorizations: %d from shifted starts, %d from others\n", shifted, unshifted);
}

INSTANTIATE_TEST_SUITE_P(All, LimitedLqLaw, ::testing::ValuesIn(specs()),
                         [](const auto& law) { return std::string(law.param.name); });

}  // namespace
}  // namespace burnish::testing
