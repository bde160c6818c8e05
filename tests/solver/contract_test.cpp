// What a solve promises beside its answer: no allocation, the same bits for any number of threads,
// a reason in words, a time budget, names.
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

class Contract : public ::testing::TestWithParam<StepUpdate> {};

TEST_P(Contract, allocates_nothing_in_a_solve) {
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

TEST_P(Contract, has_the_same_bits_for_any_number_of_threads) {
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

TEST_P(Contract, throws_what_a_function_of_the_problem_throws_in_any_thread) {
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

TEST_P(Contract, names_the_knot_and_the_term_that_are_not_finite) {
  TestProblem p = unicycle();
  p.poisoned_knot = 12;
  DdpSolver solver(p, {.update = GetParam()});
  const DdpSummary& s = solver.solve();
  EXPECT_EQ(s.reason, StopReason::NotEvaluated);
  EXPECT_EQ(s.status, Status::NotFinite);
  EXPECT_EQ(s.knot, 12);
  EXPECT_EQ(solver.text(), "not finite: cost term 'nothing' at stage, knot 12");
}

TEST_P(Contract, names_the_knot_whose_derivatives_are_not_finite) {
  for (const int knot : {0, 7, 40}) {
    TestProblem p = unicycle();
    p.poisoned_derivatives = knot;
    DdpSolver solver(p, {.update = GetParam()});
    EXPECT_EQ(solver.solve().reason, StopReason::NotEvaluated);
    EXPECT_EQ(solver.text(), "not finite: derivatives at stage, knot " + std::to_string(knot));
  }
}

TEST_P(Contract, names_the_knot_where_a_guess_is_not_finite) {
  TestProblem p = unicycle();
  DdpSolver solver(p, {.update = GetParam()});
  RowMatrix xs = RowMatrix::Zero(41, 3);
  xs(5, 2) = std::nan("");
  solver.set_guess(xs, RowMatrix::Zero(40, 2));
  EXPECT_EQ(solver.solve().reason, StopReason::NotEvaluated);
  EXPECT_EQ(solver.summary().knot, 5);
}

TEST_P(Contract, started_at_the_solution_stops_at_once) {
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

TEST_P(Contract, stops_after_so_many_iterations) {
  TestProblem p = pendulum_swing_up();
  for (const int most : {0, 1, 4}) {
    DdpSolver solver(p, {.update = GetParam(), .max_iterations = most});
    const DdpSummary& s = solver.solve();
    EXPECT_EQ(s.reason, StopReason::MaxIterations);
    EXPECT_EQ(s.iterations, most);
    EXPECT_EQ(s.log.size(), static_cast<std::size_t>(most));
    expect_words(solver.text(), {"stopped after " + std::to_string(most) + " iterations"});
  }
}

TEST_P(Contract, returns_the_best_iterate_when_the_time_is_spent) {
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

  // Stopped after any number of iterations: the best feasible one, the guess (which hangs still)
  // included.
  const double guess = solver.summary().cost;
  for (int most = 1; most < 20; ++most) {
    DdpSolver other(p, {.update = GetParam(),
                        .callback = [most](const DdpProgress& at) { return at.iteration < most; }});
    const DdpSummary& s = other.solve();
    double best = guess;
    for (const DdpProgress& entry : s.log)
      if (entry.feasible) best = std::min(best, entry.cost);
    EXPECT_TRUE(s.feasible) << most;
    EXPECT_NEAR(s.cost, best, 1e-12 * best) << most;
  }
}

TEST_P(Contract, the_callback_may_stop) {
  TestProblem p = pendulum_swing_up();
  DdpSolver solver(p, {.update = GetParam(),
                       .callback = [](const DdpProgress& at) { return at.iteration < 3; }});
  EXPECT_EQ(solver.solve().reason, StopReason::Callback);
  EXPECT_EQ(solver.summary().iterations, 3);
}

TEST_P(Contract, says_where_the_largest_gap_is) {
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

INSTANTIATE_TEST_SUITE_P(Updates, Contract,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& param) {
                           return param.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

TEST(Solver, says_which_control_costs_nothing_and_does_nothing) {
  TestProblem p = pendulum_swing_up(10, 0.05, -1e12);
  DdpSolver solver(p);
  EXPECT_EQ(solver.solve().reason, StopReason::NotPositiveDefinite);
  expect_words(solver.text(),
               {"Quu is not positive definite at stage, knot 9, control 'u0'", "1e+09"});
}

TEST(Solver, regularises_a_control_without_cost) {
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

TEST(Solver, reports_cost_by_term_and_by_knot) {
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

TEST(Solver, reports_rows_where_they_are_furthest_outside_their_limits) {
  TestProblem p = unicycle();
  DdpSolver solver(p);
  solver.solve();
  EXPECT_TRUE(solver.cost_report().rows.empty());
  const RowMatrix xs = solver.xs();
  Eigen::Index first = 0, second = 0;
  const double most = xs.col(0).maxCoeff(&first), highest = xs.col(1).maxCoeff(&second);
  p.row_scales = {1.0, 1.0};
  p.row_limits_below = {-1e3, -1e3};
  p.row_limits_above = {most - 0.25, highest + 0.5};
  const CostReport report = solver.cost_report();
  ASSERT_EQ(report.rows.size(), 2U);
  EXPECT_EQ(report.rows[0].name, "limit/x0");
  EXPECT_EQ(report.rows[0].knot, p.knot_name(static_cast<int>(first)));
  EXPECT_EQ(report.rows[0].value, most);
  EXPECT_NEAR(report.rows[0].outside, 0.25, 1e-12);
  EXPECT_NEAR(report.rows[1].outside, -0.5, 1e-12);
  const std::string text = report.text();
  EXPECT_NE(text.find("1 of 2 rows are outside"), std::string::npos) << text;
  EXPECT_NE(text.find("limit/x0"), std::string::npos) << text;
  EXPECT_EQ(text.find("limit/x1"), std::string::npos) << text;
  p.row_limits_above[0] = most - 1e-12 * std::abs(most);  // rounding breaks no limit
  EXPECT_NE(solver.cost_report().text().find("every row is inside"), std::string::npos);
}

TEST(Solver, gains_come_with_names) {
  TestProblem p = unicycle();
  DdpSolver solver(p);
  solver.solve();
  const NamedMatrix gain = solver.named_gain(4);
  EXPECT_EQ(gain.rows, (std::vector<std::string>{"u0", "u1"}));
  EXPECT_EQ(gain.columns, (std::vector<std::string>{"x0", "x1", "x2"}));
  EXPECT_EQ(gain.values, Eigen::MatrixXd(solver.gain(4)));
  EXPECT_EQ(solver.named_value_hessian(40).values, Eigen::MatrixXd::Identity(3, 3) * 10.0);
}

TEST(Solver, adds_up_the_time_of_its_phases) {
  TestProblem p = pendulum_swing_up();
  DdpSolver solver(p);
  const PhaseTimes t = solver.solve().seconds;
  EXPECT_GT(t.expand, 0.0);
  EXPECT_GT(t.backward, 0.0);
  EXPECT_GT(t.trial, 0.0);
  EXPECT_LE(t.expand + t.backward + t.trial, t.total);
}

#ifdef __linux__
TEST(Solver, pins_threads_when_told_and_refuses_more_of_them_than_cores) {
  TestProblem p = unicycle();
  const int cores = allowed_cores();
  DdpSolver solver(p, {.threads = std::min(cores, 3), .pin_threads = true});
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
  const auto ask = [&](DdpOptions options) {
    return refusal([&] { solver.set_options(std::move(options)); });
  };
  expect_words(ask({.threads = cores + 1, .pin_threads = true}),
               {std::to_string(cores + 1) + " workers", std::to_string(cores) + " core"});
  EXPECT_EQ(solver.options().threads, std::min(cores, 3));
  EXPECT_EQ(ask({.threads = cores + 1}), "");
  solver.set_guess(RowMatrix::Zero(41, 3), RowMatrix::Zero(40, 2));
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
}
#endif

TEST(Solver, refuses_options_and_guesses_in_a_sentence) {
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
