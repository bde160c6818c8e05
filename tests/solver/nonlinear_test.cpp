// Tests of nonlinear problems: both step updates reach a point where the gradient of the Lagrangian
// vanishes.
#include <gtest/gtest.h>

#include "burnish/solver/ddp.hpp"
#include "solver/nonlinear_problems.hpp"

namespace burnish::testing {
namespace {

/// Cost of rolled-out controls, for finite differences.
double cost_of(TestProblem& p, const RowMatrix& us) {
  std::vector<double> x = p.start;
  std::vector<double> next = x;
  double cost = 0.0;
  for (int k = 0; k <= p.knots(); ++k) {
    cost += p.stages[k].roll(x.data(), k < p.knots() ? us.row(k).data() : nullptr,
                             k < p.knots() ? next.data() : nullptr);
    x = next;
  }
  return cost;
}

/// Largest derivative of the cost by a control that is free to move, by central differences.
double slope_by_differences(TestProblem& p, const RowMatrix& us) {
  double largest = 0.0;
  const double h = 1e-5;
  for (int k = 0; k < p.knots(); ++k)
    for (int i = 0; i < p.controls(k); ++i) {
      RowMatrix moved = us;
      moved(k, i) = us(k, i) + h;
      const double up = cost_of(p, moved);
      moved(k, i) = us(k, i) - h;
      const double slope = (up - cost_of(p, moved)) / (2.0 * h);
      if (!p.lower.empty() && ((us(k, i) <= p.lower[k][i] && slope > 0.0) ||
                               (us(k, i) >= p.upper[k][i] && slope < 0.0)))
        continue;
      largest = std::max(largest, std::abs(slope));
    }
  return largest;
}

class Nonlinear : public ::testing::TestWithParam<StepUpdate> {};

TEST_P(Nonlinear, Pendulum_SwingsUp) {
  TestProblem p = pendulum_swing_up();
  DdpSolver solver(p, {.update = GetParam(), .max_iterations = 200, .stop_tolerance = 1e-12});
  const DdpSummary& s = solver.solve();
  EXPECT_EQ(s.reason, StopReason::Converged) << solver.text();
  EXPECT_TRUE(s.feasible);
  EXPECT_NEAR(solver.xs()(p.knots(), 0), std::numbers::pi, 0.05);
  EXPECT_LT(solver.optimality_error(), 1e-5);
  EXPECT_LT(slope_by_differences(p, solver.us()), 1e-5);
  EXPECT_NEAR(cost_of(p, solver.us()), s.cost, 1e-7);
}

TEST_P(Nonlinear, Pendulum_SwingsUpWithBoundedTorque) {
  TestProblem p = pendulum_swing_up(80);
  set_bounds(p, -4.0, 4.5);
  DdpSolver solver(p, {.update = GetParam(), .max_iterations = 500, .stop_tolerance = 1e-11});
  const DdpSummary& s = solver.solve();
  EXPECT_EQ(s.reason, StopReason::Converged) << solver.text();
  EXPECT_GE(solver.us().minCoeff(), -4.0 - 1e-10);
  EXPECT_LE(solver.us().maxCoeff(), 4.5 + 1e-10);
  EXPECT_GT(solver.us().maxCoeff(), 4.5 - 1e-9) << "no bound is active";
  EXPECT_LT(slope_by_differences(p, solver.us()), 1e-4);
}

TEST_P(Nonlinear, UnicycleWithInfeasibleGuess_Parks) {
  TestProblem p = unicycle();
  DdpSolver solver(p, {.update = GetParam(), .stop_tolerance = 1e-13});
  RowMatrix xs(p.knots() + 1, 3);
  for (int k = 0; k <= p.knots(); ++k)
    for (int i = 0; i < 3; ++i) xs(k, i) = p.start[i] * (1.0 - k / 40.0);
  solver.set_guess(xs, RowMatrix::Zero(p.knots(), 2));
  const DdpSummary& s = solver.solve();
  EXPECT_EQ(s.reason, StopReason::Converged) << solver.text();
  EXPECT_LT(s.iterations, 30);
  EXPECT_LT(slope_by_differences(p, solver.us()), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Updates, Nonlinear,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& param) {
                           return param.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

TEST(Nonlinear, BothUpdates_FindTheSameCost) {
  TestProblem p = unicycle();
  DdpSolver rollout(p, {.stop_tolerance = 1e-12});
  DdpSolver shooting(p, {.update = StepUpdate::MultipleShooting, .stop_tolerance = 1e-12});
  EXPECT_NEAR(rollout.solve().cost, shooting.solve().cost, 1e-9);
}

TEST(Nonlinear, UnconvergedSolve_HasTheLargestSlopeAsOptimalityError) {
  TestProblem p = pendulum_swing_up();
  DdpSolver solver(p, {.max_iterations = 3});
  solver.solve();
  ASSERT_TRUE(solver.summary().feasible);
  const double slope = slope_by_differences(p, solver.us());
  EXPECT_GT(slope, 1e-3);
  EXPECT_NEAR(solver.optimality_error(), slope, 1e-5 * slope);
}

}  // namespace
}  // namespace burnish::testing
