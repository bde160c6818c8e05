// Guarantees of a solve beside its solution: no allocation, the same bits for any number of
// threads, a stop reason in words, a time budget, names.
#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "base/thread_pool.hpp"
#include "burnish/solver/ddp.hpp"
#include "solver/nonlinear_problems.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

class DdpSolverContract : public ::testing::TestWithParam<StepUpdate> {};

TEST_P(DdpSolverContract, Solve_AllocatesNothing) {
  if (AllocationGuard::unavailable() != nullptr) GTEST_SKIP() << AllocationGuard::unavailable();
  for (const int threads : {1, 2}) {
    TestProblem p = pendulum_swing_up();
    set_bounds(p, -4.0, 4.0);
    DdpSolver solver(
        p, {.update = GetParam(), .threads = threads, .callback = [](const DdpProgress& progress) {
              return progress.cost > 0.0;
            }});
    const AllocationGuard guard;
    EXPECT_GT(solver.solve().log.size(), 3U);
    solver.set_time_budget(1.0);
    solver.set_guess(TrajectoryView{solver.xs().data(), solver.us().data()});
    solver.solve();
    EXPECT_EQ(guard.count(), 0);
  }
}

TEST_P(DdpSolverContract, AnyNumberOfThreads_GivesTheSameBits) {
  RowMatrix first_xs;
  RowMatrix first_us;
  for (const int threads : {1, 2, 3}) {
    TestProblem p = pendulum_swing_up();
    set_bounds(p, -5.0, 5.0);
    DdpSolver solver(p, {.update = GetParam(), .max_iterations = 25, .threads = threads});
    solver.solve();
    EXPECT_EQ(p.prepared, threads);
    if (threads == 1) {
      first_xs = solver.xs();
      first_us = solver.us();
      continue;
    }
    EXPECT_EQ(std::memcmp(first_xs.data(), solver.xs().data(), sizeof(double) * first_xs.size()),
              0);
    EXPECT_EQ(std::memcmp(first_us.data(), solver.us().data(), sizeof(double) * first_us.size()),
              0);
  }
}

TEST_P(DdpSolverContract, ExceptionInAnyThread_IsRethrown) {
  for (const int threads : {1, 2, 3}) {
    for (const int knot : {0, 17, 40}) {
      TestProblem p = unicycle();
      bool broken = true;
      p.stages[static_cast<std::size_t>(knot)].roll =
          [&broken, roll = p.stages[static_cast<std::size_t>(knot)].roll](
              const double* x, const double* u, double* next) {
            if (broken) throw Error("no such place");
            return roll(x, u, next);
          };
      DdpSolver solver(p, {.update = GetParam(), .threads = threads});
      EXPECT_EQ(refusal([&] { solver.solve(); }), "no such place");
      EXPECT_EQ(refusal([&] { solver.solve(); }), "no such place");
      broken = false;
      EXPECT_EQ(solver.solve().reason, StopReason::Converged) << threads << " " << knot;
    }
  }
}

TEST_P(DdpSolverContract, NonFiniteCost_NamesKnotAndTerm) {
  TestProblem p = unicycle();
  p.poisoned_knot = 12;
  DdpSolver solver(p, {.update = GetParam()});
  const DdpSummary& s = solver.solve();
  EXPECT_EQ(s.reason, StopReason::NotEvaluated);
  EXPECT_EQ(s.status, Status::NotFinite);
  EXPECT_EQ(s.knot, 12);
  EXPECT_EQ(solver.text(), "not finite: cost term 'nothing' at stage, knot 12");
}

TEST_P(DdpSolverContract, NonFiniteDerivatives_NameTheKnot) {
  for (const int knot : {0, 7, 40}) {
    TestProblem p = unicycle();
    p.poisoned_derivatives = knot;
    DdpSolver solver(p, {.update = GetParam()});
    EXPECT_EQ(solver.solve().reason, StopReason::NotEvaluated);
    EXPECT_EQ(solver.text(), "not finite: derivatives at stage, knot " + std::to_string(knot));
  }
}

TEST_P(DdpSolverContract, NonFiniteGuess_NamesTheKnot) {
  TestProblem p = unicycle();
  DdpSolver solver(p, {.update = GetParam()});
  RowMatrix xs = RowMatrix::Zero(41, 3);
  xs(5, 2) = std::nan("");
  solver.set_guess(xs, RowMatrix::Zero(40, 2));
  EXPECT_EQ(solver.solve().reason, StopReason::NotEvaluated);
  EXPECT_EQ(solver.summary().knot, 5);
}

TEST_P(DdpSolverContract, StartAtTheSolution_TakesNoIteration) {
  TestProblem p = unicycle();
  DdpSolver solver(p, {.update = GetParam()});
  const int cold = solver.solve().iterations;
  const RowMatrix xs = solver.xs();
  EXPECT_GT(cold, 2);
  EXPECT_EQ(solver.solve().iterations, 0);
  EXPECT_EQ(solver.summary().reason, StopReason::Converged);
  EXPECT_EQ((solver.xs() - xs).cwiseAbs().maxCoeff(), 0.0);
  p.start[0] += 0.01;
  EXPECT_LT(solver.solve().iterations, cold);
  EXPECT_EQ(solver.summary().reason, StopReason::Converged);
  EXPECT_EQ(solver.xs()(0, 0), p.start[0]);
}

TEST_P(DdpSolverContract, IterationLimit_StopsTheSolve) {
  TestProblem p = pendulum_swing_up();
  for (const int count : {0, 1, 4}) {
    DdpSolver solver(p, {.update = GetParam(), .max_iterations = count});
    const DdpSummary& s = solver.solve();
    EXPECT_EQ(s.reason, StopReason::MaxIterations);
    EXPECT_EQ(s.iterations, count);
    EXPECT_EQ(s.log.size(), static_cast<std::size_t>(count));
    expect_words(solver.text(), {"stopped after " + std::to_string(count) + " iterations"});
  }
}

TEST_P(DdpSolverContract, SpentTimeBudget_ReturnsTheBestFeasibleIterate) {
  TestProblem p = pendulum_swing_up();
  auto slow = [step = p.stages[0].roll](const double* x, const double* u, double* next) {
    std::this_thread::sleep_for(std::chrono::microseconds(20));
    return step(x, u, next);
  };
  p.stages[0].roll = slow;
  DdpSolver solver(p, {.update = GetParam(), .time_budget = 0.0});
  EXPECT_EQ(solver.solve().reason, StopReason::TimeBudget);
  EXPECT_EQ(solver.summary().iterations, 0);
  EXPECT_TRUE(std::isfinite(solver.summary().cost));
  expect_words(solver.text(), {"time budget of 0 us spent after 0 iterations"});

  // Stopped after any number of iterations, the solver returns the best feasible iterate, including
  // the guess.
  const double guess = solver.summary().cost;
  for (int count = 1; count < 20; ++count) {
    DdpSolver other(p, {.update = GetParam(), .callback = [count](const DdpProgress& at) {
                          return at.iteration < count;
                        }});
    const DdpSummary& s = other.solve();
    double best = guess;
    for (const DdpProgress& entry : s.log)
      if (entry.feasible) best = std::min(best, entry.cost);
    EXPECT_TRUE(s.feasible) << count;
    EXPECT_NEAR(s.cost, best, 1e-12 * best) << count;
  }
}

TEST_P(DdpSolverContract, Callback_StopsTheSolve) {
  TestProblem p = pendulum_swing_up();
  DdpSolver solver(p, {.update = GetParam(),
                       .callback = [](const DdpProgress& at) { return at.iteration < 3; }});
  EXPECT_EQ(solver.solve().reason, StopReason::Callback);
  EXPECT_EQ(solver.summary().iterations, 3);
}

TEST_P(DdpSolverContract, InfeasibleGuess_NamesTheLargestGap) {
  TestProblem p = unicycle();
  DdpSolver solver(p, {.update = GetParam(), .max_iterations = 0});
  RowMatrix xs = RowMatrix::Zero(41, 3);
  xs.rowwise() = Eigen::RowVector3d(-1.0, -1.0, 1.0);
  xs(9, 1) += 0.5;
  solver.set_guess(xs, RowMatrix::Zero(40, 2));
  const DdpSummary& s = solver.solve();
  EXPECT_FALSE(s.feasible);
  EXPECT_NEAR(s.largest_gap, 0.5, 1e-12);
  EXPECT_EQ(s.gap_entry, 1);
  EXPECT_EQ(s.gap_knot, 9);
  expect_words(solver.text(), {"not feasible: largest gap 0.5 in 'x1' before stage, knot 9"});
}

INSTANTIATE_TEST_SUITE_P(Updates, DdpSolverContract,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& param) {
                           return param.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

TEST(DdpSolver, IndefiniteControlHessian_NamesTheControl) {
  TestProblem p = pendulum_swing_up(10, 0.05, -1e12);
  DdpSolver solver(p);
  EXPECT_EQ(solver.solve().reason, StopReason::NotPositiveDefinite);
  expect_words(solver.text(),
               {"(Quu) is not positive definite at stage, knot 9, control 'u0'", "1e+09"});
}

TEST(DdpSolver, ControlWithoutCost_IsRegularized) {
  TestProblem p = pendulum_swing_up(30, 0.05, 0.0);
  p.stages.back().expand = [](const double*, const double*, KnotExpansion& e) {
    e.gradient[0] = e.gradient[1] = 0.0;
    e.hessian[0] = e.hessian[e.stride] = e.hessian[e.stride + 1] = 0.0;
  };
  DdpSolver solver(p, {.max_iterations = 3});
  solver.solve();
  EXPECT_GE(solver.summary().regularization, 1e-9);
  EXPECT_NE(solver.summary().reason, StopReason::NotPositiveDefinite);
}

TEST(DdpSolver, CostReport_ListsTermsAndKnots) {
  TestProblem p = unicycle();
  DdpSolver solver(p);
  const double cost = solver.solve().cost;
  const CostReport report = solver.cost_report();
  EXPECT_NEAR(report.total, cost, 1e-12);
  ASSERT_EQ(report.terms.size(), 2U);
  EXPECT_EQ(report.terms[0].name, "work");
  EXPECT_NEAR(report.terms[0].cost, cost, 1e-12);
  EXPECT_EQ(report.knots.size(), 41U);
  EXPECT_EQ(report.knots[3].name, "stage, knot 3");
  EXPECT_NE(report.text().find("work"), std::string::npos);
}

TEST(DdpSolver, CostReport_ListsTheLargestViolationPerRow) {
  TestProblem p = unicycle();
  DdpSolver solver(p);
  solver.solve();
  EXPECT_TRUE(solver.cost_report().rows.empty());
  const RowMatrix xs = solver.xs();
  Eigen::Index first = 0, second = 0;
  const double max_x0 = xs.col(0).maxCoeff(&first), max_x1 = xs.col(1).maxCoeff(&second);
  p.row_scales = {1.0, 1.0};
  p.row_limits_below = {-1e3, -1e3};
  p.row_limits_above = {max_x0 - 0.25, max_x1 + 0.5};
  const CostReport report = solver.cost_report();
  ASSERT_EQ(report.rows.size(), 2U);
  EXPECT_EQ(report.rows[0].name, "limit/x0");
  EXPECT_EQ(report.rows[0].knot, p.knot_name(static_cast<int>(first)));
  EXPECT_EQ(report.rows[0].value, max_x0);
  EXPECT_NEAR(report.rows[0].violation, 0.25, 1e-12);
  EXPECT_NEAR(report.rows[1].violation, -0.5, 1e-12);
  const std::string text = report.text();
  EXPECT_NE(text.find("1 of 2 rows are outside"), std::string::npos) << text;
  EXPECT_NE(text.find("limit/x0"), std::string::npos) << text;
  EXPECT_EQ(text.find("limit/x1"), std::string::npos) << text;
  p.row_limits_above[0] = max_x0 - 1e-12 * std::abs(max_x0);  // rounding errors are no violation
  EXPECT_NE(solver.cost_report().text().find("every row is inside"), std::string::npos);
}

TEST(DdpSolver, NamedGain_HasRowAndColumnNames) {
  TestProblem p = unicycle();
  DdpSolver solver(p);
  solver.solve();
  const NamedMatrix gain = solver.named_gain(4);
  EXPECT_EQ(gain.rows, (std::vector<std::string>{"u0", "u1"}));
  EXPECT_EQ(gain.columns, (std::vector<std::string>{"x0", "x1", "x2"}));
  EXPECT_EQ(gain.values, Eigen::MatrixXd(solver.gain(4)));
  EXPECT_EQ(solver.named_value_hessian(40).values, Eigen::MatrixXd::Identity(3, 3) * 10.0);
}

TEST(DdpSolver, PhaseTimes_AddUpToAtMostTheTotal) {
  TestProblem p = pendulum_swing_up();
  DdpSolver solver(p);
  const PhaseTimes t = solver.solve().seconds;
  EXPECT_GT(t.expand, 0.0);
  EXPECT_GT(t.backward, 0.0);
  EXPECT_GT(t.trial, 0.0);
  EXPECT_LE(t.expand + t.backward + t.trial, t.total);
}

#ifdef __linux__
TEST(DdpSolver, PinnedThreads_AreRefusedBeyondTheCores) {
  TestProblem p = unicycle();
  const int cores = allowed_cores();
  DdpSolver solver(p, {.threads = std::min(cores, 3), .pin_threads = true});
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
  const auto refused = [&](DdpOptions options) {
    return refusal([&] { solver.set_options(std::move(options)); });
  };
  expect_words(refused({.threads = cores + 1, .pin_threads = true}),
               {std::to_string(cores + 1) + " workers", std::to_string(cores) + " core"});
  EXPECT_EQ(solver.options().threads, std::min(cores, 3));
  EXPECT_EQ(refused({.threads = cores + 1}), "");
  solver.set_guess(RowMatrix::Zero(41, 3), RowMatrix::Zero(40, 2));
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
}
#endif

TEST(DdpSolver, InvalidOptionsAndGuesses_AreRefused) {
  TestProblem p = unicycle();
  expect_words(refusal([&] { DdpSolver(p, {.max_iterations = -1}); }), {"max_iterations", "-1"});
  expect_words(refusal([&] { DdpSolver(p, {.threads = 0}); }), {"threads", "1 to"});
  expect_words(refusal([&] { DdpSolver(p, {.stop_tolerance = std::nan("")}); }),
               {"stop_tolerance", "nan"});
  expect_words(refusal([&] {
                 DdpSolver solver(p);
                 solver.set_guess(RowMatrix::Zero(40, 3), RowMatrix::Zero(40, 2));
               }),
               {"states", "40 x 3", "41 x 3"});
  p.shape.nv = 2;
  expect_words(refusal([&] { DdpSolver solver(p); }), {"ndx is 3", "4"});
}

}  // namespace
}  // namespace burnish::testing
