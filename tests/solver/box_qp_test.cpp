#include "solver/box_qp.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/decomposition.hpp"
#include "burnish/solver/ddp.hpp"
#include "solver/nonlinear_problems.hpp"

namespace burnish::testing {
namespace {

struct Instance {
  RowMatrix Q;
  Eigen::VectorXd q, lower, upper;
};

Instance draw(int n, std::mt19937& random) {
  std::normal_distribution<double> normal;
  const RowMatrix root = RowMatrix::NullaryExpr(n, n, [&] { return normal(random); });
  Instance p{root * root.transpose() + 0.01 * RowMatrix::Identity(n, n), {}, {}, {}};
  p.q = Eigen::VectorXd::NullaryExpr(n, [&] { return 3.0 * normal(random); });
  p.lower = -Eigen::VectorXd::NullaryExpr(n, [&] { return std::abs(normal(random)); });
  p.upper = Eigen::VectorXd::NullaryExpr(n, [&] { return std::abs(normal(random)); });
  return p;
}

/// Tries every choice of free, lower and upper per entry; returns the choice that satisfies the
/// optimality conditions.
Eigen::VectorXd enumerate(const Instance& p) {
  const auto n = static_cast<int>(p.q.size());
  int choices = 1;
  for (int i = 0; i < n; ++i) choices *= 3;
  for (int choice = 0; choice < choices; ++choice) {
    std::vector<int> free;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
    std::vector<int> where(static_cast<std::size_t>(n));
    for (int i = 0, rest = choice; i < n; ++i, rest /= 3) {
      where[i] = rest % 3;
      if (where[i] == 0) free.push_back(i);
      if (where[i] == 1) x[i] = p.lower[i];
      if (where[i] == 2) x[i] = p.upper[i];
    }
    if (!free.empty()) {
      const Eigen::MatrixXd Qff = p.Q(free, free);
      const Eigen::VectorXd right = -(p.q + p.Q * x);
      const Eigen::VectorXd right_free = right(free);
      const Eigen::VectorXd x_free = solve_positive(Qff, right_free);
      x(free) = x_free;
    }
    const Eigen::VectorXd gradient = p.q + p.Q * x;
    bool optimal = true;
    for (int i = 0; i < n; ++i) {
      optimal = optimal && x[i] >= p.lower[i] && x[i] <= p.upper[i];
      optimal = optimal && (where[i] != 1 || gradient[i] >= 0.0);
      optimal = optimal && (where[i] != 2 || gradient[i] <= 0.0);
    }
    if (optimal) return x;
  }
  ADD_FAILURE() << "no active set is optimal";
  return {};
}

TEST(BoxQp, Solution_EqualsEnumeratedActiveSets) {
  std::mt19937 random(3);
  int clamped = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 1 + trial % 6;
    const Instance p = draw(n, random);
    BoxQp solver(n);
    Eigen::VectorXd x = Eigen::VectorXd::Random(n) * 5.0;
    const BoxQpResult result =
        solver.solve({n, p.Q.data(), n, p.q.data(), 1, p.lower.data(), p.upper.data()}, x.data());
    EXPECT_TRUE(result.positive_definite);
    EXPECT_LT((x - enumerate(p)).cwiseAbs().maxCoeff(), 1e-10) << "trial " << trial;
    EXPECT_TRUE((x.array() >= p.lower.array()).all() && (x.array() <= p.upper.array()).all());
    for (int i = 0; i < n; ++i) clamped += solver.clamped(i) ? 1 : 0;
  }
  EXPECT_GT(clamped, 100) << "the bounds are rarely active";
}

TEST(BoxQp, StartAtTheSolution_TakesAtMostOneStep) {
  std::mt19937 random(4);
  const Instance p = draw(6, random);
  BoxQp solver(6);
  Eigen::VectorXd x = enumerate(p);
  EXPECT_LE(
      solver.solve({6, p.Q.data(), 6, p.q.data(), 1, p.lower.data(), p.upper.data()}, x.data())
          .iterations,
      1);
}

TEST(BoxQp, IndefiniteMatrix_IsReported) {
  const double Q[] = {1.0, 2.0, 0.0, 1.0};
  const double q[] = {0.1, 0.1};
  const double lower[] = {-1.0, -1.0};
  const double upper[] = {1.0, 1.0};
  double x[] = {0.0, 0.0};
  EXPECT_FALSE(BoxQp(2).solve({2, Q, 2, q, 1, lower, upper}, x).positive_definite);
}

/// Minimizes over the stacked controls, with states eliminated, by cyclic coordinate descent.
RowMatrix condensed_solution(const LqProblem& lq) {
  const TestProblem& p = lq.problem;
  const int N = p.knots();
  const int nu = p.max_nu;
  const int ndx = p.shape.ndx;
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(ndx, N * nu);  // x_k = S u + s
  Eigen::VectorXd s = Eigen::Map<const Eigen::VectorXd>(p.start.data(), ndx);
  Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(N * nu, N * nu);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(N * nu);
  for (int k = 0; k <= N; ++k) {
    const LqStage& stage = lq.stages[k];
    Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(stage.nu + ndx, N * nu);
    Eigen::VectorXd z = Eigen::VectorXd::Zero(stage.nu + ndx);
    Z.bottomRows(ndx) = S;
    z.tail(ndx) = s;
    for (int i = 0; i < stage.nu; ++i) Z(i, k * nu + i) = 1.0;
    Q += Z.transpose() * stage.H * Z;
    q += Z.transpose() * (stage.H * z + stage.h);
    if (k == N) break;
    S = (stage.F * Z).eval();
    s = (stage.F * z + stage.c).eval();
  }
  Eigen::VectorXd u = Eigen::VectorXd::Zero(N * nu);
  for (int sweep = 0; sweep < 5000; ++sweep)
    for (int i = 0; i < u.size(); ++i) {
      const double wanted = u[i] - (q[i] + Q.row(i).dot(u)) / Q(i, i);
      u[i] = std::clamp(wanted, p.lower[i / nu][i % nu], p.upper[i / nu][i % nu]);
    }
  return Eigen::Map<const RowMatrix>(u.data(), N, nu);
}

class BoundedLq : public ::testing::TestWithParam<StepUpdate> {};

TEST_P(BoundedLq, BoundedControls_EqualTheCondensedSolution) {
  int active = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    LqSpec spec{.ndx = 4, .nu = std::vector<int>(7, 2), .seed = seed};
    if (seed % 2 == 0)
      spec = {.nv = 2,
              .filtered = 1,
              .nu = std::vector<int>(7, 2),
              .form = DynamicsForm::SecondOrder,
              .seed = seed};
    LqProblem lq = random_lq(spec);
    set_bounds(lq.problem, -0.4, 0.3);
    DdpSolver solver(lq.problem,
                     {.update = GetParam(), .max_iterations = 300, .stop_tolerance = 1e-20});
    solver.set_guess(RowMatrix::Constant(8, lq.problem.shape.nx, 0.1),
                     RowMatrix::Constant(7, 2, 9));
    solver.solve();
    EXPECT_LT(solver.optimality_error(), 1e-8) << solver.text() << " seed " << seed;
    EXPECT_LE(solver.us().maxCoeff(), 0.3 + 1e-10);
    EXPECT_GE(solver.us().minCoeff(), -0.4 - 1e-10);
    EXPECT_LT((solver.us() - condensed_solution(lq)).cwiseAbs().maxCoeff(), 1e-8)
        << "seed " << seed;
    for (int k = 0; k < 7; ++k)
      for (int i = 0; i < 2; ++i) {
        if (solver.us()(k, i) > -0.4 && solver.us()(k, i) < 0.3) continue;
        ++active;
        EXPECT_EQ(solver.gain(k).row(i).cwiseAbs().maxCoeff(), 0.0)
            << "a clamped control must have zero gain";
      }
  }
  EXPECT_GT(active, 20);
}

INSTANTIATE_TEST_SUITE_P(Updates, BoundedLq,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& param) {
                           return param.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

}  // namespace
}  // namespace burnish::testing
