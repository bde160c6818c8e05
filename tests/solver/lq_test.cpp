// Tests of linear-quadratic problems: one iteration finds the solution of a dense KKT system.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "burnish/solver/ddp.hpp"
#include "solver/test_problem.hpp"

namespace burnish::testing {
namespace {

struct Solution {
  RowMatrix xs, us;
};

/// Stationary point of the Lagrangian over all states and controls at once.
Solution solve_kkt(const LqProblem& lq) {
  const TestProblem& p = lq.problem;
  const int N = p.knots();
  const int ndx = p.shape.ndx;
  std::vector<int> first_u;
  int variables = (N + 1) * ndx;
  for (int k = 0; k < N; ++k) {
    first_u.push_back(variables);
    variables += p.controls(k);
  }
  const int rows = (N + 1) * ndx;
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(variables + rows, variables + rows);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(variables + rows);
  for (int k = 0; k <= N; ++k) {
    const LqStage& s = lq.stages[k];
    std::vector<int> index;
    for (int i = 0; i < s.nu; ++i) index.push_back(first_u[k] + i);
    for (int i = 0; i < ndx; ++i) index.push_back(k * ndx + i);
    for (std::size_t i = 0; i < index.size(); ++i) {
      right[index[i]] = -s.h[i];
      for (std::size_t j = 0; j < index.size(); ++j) kkt(index[i], index[j]) = s.H(i, j);
    }
    for (int i = 0; i < ndx; ++i) {
      kkt(variables + k * ndx + i, k * ndx + i) = 1.0;
      if (k == 0) right[variables + i] = p.start[i];
      if (k == N) continue;
      right[variables + (k + 1) * ndx + i] = s.c[i];
      for (std::size_t j = 0; j < index.size(); ++j)
        kkt(variables + (k + 1) * ndx + i, index[j]) = -s.F(i, j);
    }
  }
  kkt.topRightCorner(variables, rows) = kkt.bottomLeftCorner(rows, variables).transpose();
  const Eigen::VectorXd y = kkt.fullPivLu().solve(right);
  Solution solution{RowMatrix(N + 1, ndx), RowMatrix::Zero(N, p.max_nu)};
  for (int k = 0; k <= N; ++k) solution.xs.row(k) = y.segment(k * ndx, ndx);
  for (int k = 0; k < N; ++k)
    solution.us.row(k).head(p.controls(k)) = y.segment(first_u[k], p.controls(k));
  return solution;
}

struct Case {
  const char* name;
  LqSpec spec;
};

std::vector<Case> cases() {
  const auto structured = DynamicsForm::SecondOrder;
  return {
      {"dense", {.ndx = 5, .nu = {2, 2, 2, 2, 2, 2}}},
      {"dense_wide", {.ndx = 9, .nu = {11, 11, 11, 11}, .seed = 2}},
      {"dense_varying", {.ndx = 4, .nu = {1, 3, 0, 2, 3, 0, 1}, .seed = 3}},
      {"second_order", {.nv = 3, .nu = {2, 2, 2, 2, 2}, .form = structured, .seed = 4}},
      {"arm", {.nv = 6, .nu = std::vector<int>(12, 6), .form = structured, .seed = 5}},
      {"filter", {.nv = 3, .filtered = 3, .nu = {3, 3, 3, 3}, .form = structured, .seed = 6}},
      {"filter_more_controls",
       {.nv = 4, .filtered = 2, .nu = {5, 5, 5}, .form = structured, .seed = 7}},
      {"tangent_blocks",
       {.nv = 9, .blocks = {{0, 6}, {7, 2}}, .nu = {3, 3, 3, 3}, .form = structured, .seed = 8}},
      {"lead_blocks_filter_impacts",
       {.nv = 10,
        .filtered = 4,
        .blocks = {{0, 6}, {6, 3}},
        .nu = {4, 4, 0, 4, 4, 0, 4},
        .form = structured,
        .seed = 9}},
      {"whole_body",
       {.nv = 26, .blocks = {{0, 6}}, .nu = {20, 20, 0, 20}, .form = structured, .seed = 10}},
  };
}

class LqLaw : public ::testing::TestWithParam<std::tuple<Case, StepUpdate, bool>> {};

TEST_P(LqLaw, AnyGuess_IsSolvedInOneIteration) {
  const auto& [which, update, from_anywhere] = GetParam();
  LqProblem lq = random_lq(which.spec);
  const Solution wanted = solve_kkt(lq);
  DdpSolver solver(lq.problem, {.update = update});
  if (from_anywhere) {
    std::srand(17);
    solver.set_guess(RowMatrix::Random(wanted.xs.rows(), wanted.xs.cols()),
                     RowMatrix::Random(wanted.us.rows(), wanted.us.cols()));
  }
  const DdpSummary& summary = solver.solve();
  EXPECT_EQ(summary.reason, StopReason::Converged) << solver.text();
  EXPECT_EQ(summary.iterations, 1) << solver.text();
  EXPECT_TRUE(summary.feasible);
  const double scale = std::max(1.0, wanted.xs.cwiseAbs().maxCoeff());
  EXPECT_LT((solver.xs() - wanted.xs).cwiseAbs().maxCoeff(), 1e-12 * scale);
  for (int k = 0; k < lq.problem.knots(); ++k) {
    const int nu = lq.problem.controls(k);
    if (nu == 0) continue;
    const double error = (solver.us().row(k) - wanted.us.row(k)).head(nu).cwiseAbs().maxCoeff();
    EXPECT_LT(error, 1e-12 * std::max(1.0, wanted.us.cwiseAbs().maxCoeff())) << "knot " << k;
  }
  EXPECT_LT(solver.optimality_error(), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(All, LqLaw,
                         ::testing::Combine(::testing::ValuesIn(cases()),
                                            ::testing::Values(StepUpdate::Rollout,
                                                              StepUpdate::MultipleShooting),
                                            ::testing::Bool()),
                         [](const auto& param) {
                           return std::string(std::get<0>(param.param).name) +
                                  (std::get<1>(param.param) == StepUpdate::Rollout ? "_rollout"
                                                                                   : "_shooting") +
                                  (std::get<2>(param.param) ? "_from_anywhere" : "_from_start");
                         });

TEST(Lq, StructuredForm_EqualsDenseForm) {
  for (Case c : cases()) {
    if (c.spec.nv == 0) continue;
    LqProblem structured = random_lq(c.spec);
    c.spec.form = DynamicsForm::Dense;
    LqProblem dense = random_lq(c.spec);
    DdpSolver a(structured.problem);
    DdpSolver b(dense.problem);
    a.solve();
    b.solve();
    for (int k = 0; k <= dense.problem.knots(); ++k) {
      const double scale = b.value_hessian(k).cwiseAbs().maxCoeff();
      EXPECT_LT((a.value_hessian(k) - b.value_hessian(k)).cwiseAbs().maxCoeff(), 1e-12 * scale)
          << c.name << " knot " << k;
      EXPECT_LT((a.value_gradient(k) - b.value_gradient(k)).cwiseAbs().maxCoeff(), 1e-11 * scale);
      if (k == dense.problem.knots() || dense.problem.controls(k) == 0) continue;
      EXPECT_LT((a.gain(k) - b.gain(k)).cwiseAbs().maxCoeff(), 1e-11 * scale)
          << c.name << " knot " << k;
    }
  }
}

/// Trials of a line search, counted from 0. Trials before `which` fail; trial `which` reports a
/// cost that is too high by `more`.
struct Trials {
  int which = 0;
  double more = 0.0;
  int next = -1;
};

/// Counts trials at knot 0: rollouts after an expansion.
void count_trials(TestKnot& knot, Trials& trials) {
  knot.expand = [expand = knot.expand, &trials](const double* x, const double* u,
                                                KnotExpansion& out) {
    trials.next = 0;
    expand(x, u, out);
  };
  knot.roll = [roll = knot.roll, &trials](const double* x, const double* u, double* next) {
    const double cost = roll(x, u, next);
    if (trials.next < 0) return cost;
    const int trial = trials.next++;
    return trial < trials.which ? std::nan("") : cost + (trial == trials.which ? trials.more : 0.0);
  };
}

double cost_of(const LqProblem& lq, const RowMatrix& xs, const RowMatrix& us) {
  double cost = 0.0;
  for (int k = 0; k <= lq.problem.knots(); ++k) {
    const double* u = k < lq.problem.knots() ? us.row(k).data() : nullptr;
    cost += lq.problem.stages[k].roll(xs.row(k).data(), u, nullptr);
  }
  return cost;
}

/// Guess with random controls; the states follow from them or are random as well.
Solution random_guess(const LqProblem& lq, bool feasible) {
  const int N = lq.problem.knots(), ndx = lq.problem.shape.ndx;
  std::srand(23);
  Solution guess{RowMatrix::Random(N + 1, ndx), RowMatrix::Random(N, lq.problem.max_nu)};
  if (!feasible) return guess;
  std::copy(lq.problem.start.begin(), lq.problem.start.end(), guess.xs.row(0).data());
  for (int k = 0; k < N; ++k)
    lq.problem.stages[k].roll(guess.xs.row(k).data(), guess.us.row(k).data(),
                              guess.xs.row(k + 1).data());
  return guess;
}

class ExpectedImprovement : public ::testing::TestWithParam<std::tuple<Case, bool>> {};

TEST_P(ExpectedImprovement, AnyStepLength_IsExact) {
  // Along a step of an LQ problem, states and controls move on straight lines, so the exact cost is
  // available at every length. A trial with a cost just below the acceptance bound is accepted, a
  // trial just above it is not. This brackets the solver's expected improvement.
  const auto& [which, feasible] = GetParam();
  const LineSearch rule;
  for (int halvings = 0; halvings <= 5; ++halvings) {
    const double length = std::pow(0.5, halvings);
    for (const bool accepted : {true, false}) {
      LqProblem lq = random_lq(which.spec);
      const Solution best = solve_kkt(lq), guess = random_guess(lq, feasible);
      const double before = cost_of(lq, guess.xs, guess.us);
      const double saved = before - cost_of(lq, guess.xs + length * (best.xs - guess.xs),
                                            guess.us + length * (best.us - guess.us));
      const double required =
          (saved > 0.0 ? rule.sufficient_decrease : rule.allowed_increase) * saved;
      const bool always = saved > 0.0 && !feasible;  // closing the gaps accepts any cost
      Trials trials{halvings, saved - required + (accepted ? -1e-6 : 1e-6) * std::abs(saved)};
      count_trials(lq.problem.stages[0], trials);
      DdpSolver solver(lq.problem, {.update = StepUpdate::Rollout, .max_iterations = 1});
      solver.set_guess(guess.xs, guess.us);
      const DdpSummary& summary = solver.solve();
      ASSERT_EQ(summary.log.size(), 1U) << solver.text();
      if (accepted || always) {
        EXPECT_EQ(summary.log[0].step_length, length) << "saved " << saved;
      } else {
        EXPECT_LT(summary.log[0].step_length, length) << "saved " << saved;
      }
      if (feasible && halvings == 0) {
        EXPECT_NEAR(summary.log[0].expected_improvement, saved, 1e-9 * std::abs(saved));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ExpectedImprovement,
                         ::testing::Combine(::testing::ValuesIn(cases()), ::testing::Bool()),
                         [](const auto& param) {
                           return std::string(std::get<0>(param.param).name) +
                                  (std::get<1>(param.param) ? "_feasible" : "_with_gaps");
                         });

TEST(Lq, ValueFunction_PredictsTheCostWithActiveBounds) {
  for (const std::size_t which : {0U, 4U, 8U}) {
    LqProblem lq = random_lq(cases()[which].spec);
    const auto nu = static_cast<std::size_t>(lq.problem.max_nu);
    const auto knots = static_cast<std::size_t>(lq.problem.knots());
    const double bound = 0.5 * solve_kkt(lq).us.cwiseAbs().maxCoeff();
    lq.problem.lower.assign(knots, std::vector<double>(nu, -bound));
    lq.problem.upper.assign(knots, std::vector<double>(nu, bound));
    DdpSolver solver(lq.problem, {.stop_tolerance = 1e-15});
    const double cost = solver.solve().cost;
    const RowMatrix us = solver.us();
    EXPECT_EQ(us.cwiseAbs().maxCoeff(), bound) << "no control is at its bounds";
    EXPECT_LT(us.cwiseAbs().minCoeff(), bound) << "every control is at its bounds";
    // Small enough that no control reaches or leaves its bound.
    const Eigen::VectorXd dx = Eigen::VectorXd::LinSpaced(lq.problem.shape.ndx, -3e-4, 4e-4);
    const double change =
        solver.value_gradient(0).dot(dx) + 0.5 * dx.dot(solver.value_hessian(0) * dx);
    const double linear = solver.value_gradient(0).dot(dx);
    for (int i = 0; i < dx.size(); ++i) lq.problem.start[i] += dx[i];
    const double found = solver.solve().cost - cost;
    EXPECT_NEAR(found, change, 1e-3 * std::abs(change - linear) + 1e-12 * std::abs(cost)) << which;
  }
}

TEST(Lq, ValueFunction_PredictsTheCostFromAnotherStart) {
  LqProblem lq = random_lq(cases()[8].spec);
  DdpSolver solver(lq.problem);
  const double cost = solver.solve().cost;
  const Eigen::VectorXd dx = Eigen::VectorXd::LinSpaced(lq.problem.shape.ndx, -0.3, 0.5);
  const double predicted =
      cost + solver.value_gradient(0).dot(dx) + 0.5 * dx.dot(solver.value_hessian(0) * dx);
  const Eigen::VectorXd first_u = solver.us().row(0).transpose().head(4) + solver.gain(0) * dx;
  for (int i = 0; i < dx.size(); ++i) lq.problem.start[i] += dx[i];
  EXPECT_NEAR(solver.solve().cost, predicted, 1e-10 * std::abs(predicted));
  EXPECT_LT((solver.us().row(0).transpose().head(4) - first_u).cwiseAbs().maxCoeff(), 1e-11);
}

}  // namespace
}  // namespace burnish::testing
