// Tests of constraint rows with limits, with both step updates.
#include <gtest/gtest.h>

#include "burnish/solver/ddp.hpp"
#include "solver/nonlinear_problems.hpp"

namespace burnish::testing {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void limit_states(TestProblem& p, std::vector<double> lower, std::vector<double> upper) {
  p.row_scales.assign(lower.size(), 1.0);
  p.row_l1_weights.assign(lower.size(), infinity);
  p.row_quadratic_weights.assign(lower.size(), 0.0);
  p.row_limits_below = std::move(lower);
  p.row_limits_above = std::move(upper);
}

/// Expects a row with nonzero multiplier to be at the limit that the multiplier's sign indicates.
void expect_multipliers_of_limits(TestProblem& p, const DdpSolver& solver) {
  double largest = 0.0;
  for (int k = 0; k <= p.knots(); ++k) {
    const VectorView multipliers = solver.multipliers(k);
    ASSERT_EQ(multipliers.size(), p.rows(k));
    for (int r = 0; r < p.rows(k); ++r) {
      const double value = solver.xs()(k, r), m = multipliers[r];
      const auto at = static_cast<std::size_t>(r);
      if (std::abs(m) > 1e-6) {
        EXPECT_NEAR(value, m > 0.0 ? p.row_limits_above[at] : p.row_limits_below[at], 1e-6) << k;
      }
      largest = std::max(largest, std::abs(m));
    }
  }
  EXPECT_GT(largest, 1e-3) << "no constraint is active";
  const CostReport report = solver.cost_report();
  int active = 0;
  for (const CostReport::Row& row : report.rows) active += row.active;
  EXPECT_GT(active, 0);
  EXPECT_EQ(report.limits.size(), static_cast<std::size_t>(active)) << "no limit may be violated";
  for (const CostReport::ActiveLimit& limit : report.limits) {
    const auto names = p.row_names(limit.knot);
    const auto r = std::find(names.begin(), names.end(), limit.row) - names.begin();
    ASSERT_LT(r, p.rows(limit.knot));
    EXPECT_EQ(limit.multiplier, solver.multipliers(limit.knot)[r]);
    EXPECT_EQ(limit.value, solver.xs()(limit.knot, r));
  }
  EXPECT_NE(report.text().find("active constraints: "), std::string::npos);
}

class LimitedDdp : public ::testing::TestWithParam<StepUpdate> {};

DdpOptions to_convergence(StepUpdate update) {
  return {.update = update, .max_iterations = 200, .stop_tolerance = 1e-11};
}

TEST_P(LimitedDdp, PendulumSwingUp_KeepsSpeedAndTorqueLimits) {
  for (const double speed : {6.0, 4.0, 3.0}) {
    TestProblem p = pendulum_swing_up(80);
    set_bounds(p, -4.0, 4.5);
    limit_states(p, {-infinity, -speed}, {infinity, speed});
    DdpSolver solver(p, to_convergence(GetParam()));
    const DdpSummary& s = solver.solve();
    EXPECT_EQ(s.reason, StopReason::Converged) << solver.text();
    EXPECT_TRUE(s.feasible);
    EXPECT_EQ(s.violation_knot, -1);
    EXPECT_LE(solver.xs().col(1).cwiseAbs().maxCoeff(), speed + 1e-7);
    if (speed < 5.0) expect_multipliers_of_limits(p, solver);
    EXPECT_LT(solver.optimality_error(), 1e-3);
    EXPECT_LE(solver.us().maxCoeff(), 4.5);
    EXPECT_GE(solver.us().minCoeff(), -4.0);
  }
}

TEST_P(LimitedDdp, Unicycle_KeepsPositionAndHeadingLimits) {
  TestProblem p = unicycle();
  limit_states(p, {-infinity, -1.05, -infinity}, {infinity, 0.0, 1.2});
  DdpSolver solver(p, to_convergence(GetParam()));
  EXPECT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
  EXPECT_LE(solver.xs().col(2).maxCoeff(), 1.2 + 1e-7);
  EXPECT_GE(solver.xs().col(1).minCoeff(), -1.05 - 1e-7);
}

TEST_P(LimitedDdp, InactiveLimits_LeaveTheSolution) {
  TestProblem p = unicycle();
  DdpSolver unlimited(p, to_convergence(GetParam()));
  unlimited.solve();
  const RowMatrix xs = unlimited.xs();
  limit_states(p, {-50.0, -50.0, -50.0}, {50.0, 50.0, 50.0});
  DdpSolver solver(p, to_convergence(GetParam()));
  EXPECT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
  EXPECT_LE((solver.xs() - xs).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_P(LimitedDdp, InfeasibleStart_ConvergesToTheFeasibleSolution) {
  TestProblem p = unicycle();
  limit_states(p, {-infinity, -1.05, -infinity}, {infinity, 0.0, 1.2});
  DdpSolver solver(p, to_convergence(GetParam()));
  solver.solve();
  const RowMatrix xs = solver.xs();
  RowMatrix far_xs = xs, far_us = solver.us();
  far_xs.col(1).array() += 3.0;
  far_us.array() += 0.5;
  for (int i = 0; i < 3; ++i) far_xs(0, i) = p.start[static_cast<std::size_t>(i)];
  solver.set_guess(far_xs, far_us);
  EXPECT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
  EXPECT_LE((solver.xs() - xs).cwiseAbs().maxCoeff(), 1e-4);
}

enum class Shift { None, ByNumber, ByKnots };

/// Returns the number of recursions of consecutive plans, each from the second state of the last
/// plan, one knot later.
int recursions_of_consecutive_plans(TestProblem& p, StepUpdate update, Shift shift) {
  std::vector<int> from;
  for (int k = 1; k <= p.knots(); ++k) from.push_back(k);
  int recursions = 0;
  DdpOptions options = to_convergence(update);
  options.callback = [&](const DdpProgress& progress) {
    recursions += progress.factorizations;
    return true;
  };
  DdpSolver solver(p, options);
  solver.solve();
  recursions = 0;
  const std::vector<double> begin = p.start;
  for (int plan = 0; plan < 10; ++plan) {
    RowMatrix xs = solver.xs(), us = solver.us();
    xs.topRows(p.knots()) = solver.xs().bottomRows(p.knots());
    us.topRows(p.knots() - 1) = solver.us().bottomRows(p.knots() - 1);
    for (Eigen::Index i = 0; i < xs.cols(); ++i) p.start[static_cast<std::size_t>(i)] = xs(0, i);
    solver.set_guess(xs, us);
    if (shift == Shift::ByNumber) solver.shift_limits(1);
    if (shift == Shift::ByKnots) solver.shift_limits(from);
    EXPECT_EQ(solver.solve().reason, StopReason::Converged) << plan << ": " << solver.text();
    EXPECT_EQ(solver.summary().violation_knot, -1) << plan;
  }
  p.start = begin;
  return recursions;
}

TEST_P(LimitedDdp, ShiftedMultipliers_TakeFewerRecursionsOneKnotLater) {
  TestProblem p = pendulum_swing_up(80);
  set_bounds(p, -4.0, 4.5);
  limit_states(p, {-infinity, -3.0}, {infinity, 3.0});
  const int shifted = recursions_of_consecutive_plans(p, GetParam(), Shift::ByNumber);
  const int unshifted = recursions_of_consecutive_plans(p, GetParam(), Shift::None);
  EXPECT_LT(shifted, unshifted);
  EXPECT_EQ(recursions_of_consecutive_plans(p, GetParam(), Shift::ByKnots), shifted);
  std::printf("recursions: %d from shifted starts, %d from others\n", shifted, unshifted);
}

TEST_P(LimitedDdp, L1Weight_KeepsLimitsOnlyAboveTheirMultipliers) {
  TestProblem p = unicycle();
  limit_states(p, {-infinity, -infinity, -infinity}, {infinity, infinity, 0.8});
  DdpSolver hard(p, to_convergence(GetParam()));
  hard.solve();
  p.row_l1_weights.assign(3, 1e3);
  DdpSolver large_weight(p, to_convergence(GetParam()));
  EXPECT_EQ(large_weight.solve().reason, StopReason::Converged) << large_weight.text();
  EXPECT_LE((large_weight.xs() - hard.xs()).cwiseAbs().maxCoeff(), 1e-5);
  p.row_l1_weights.assign(3, 1e-3);
  DdpSolver small_weight(p, to_convergence(GetParam()));
  EXPECT_EQ(small_weight.solve().reason, StopReason::Converged) << small_weight.text();
  EXPECT_GT(small_weight.xs().col(2).maxCoeff(), 0.8 + 1e-3);
  EXPECT_EQ(small_weight.summary().violation_knot, -1) << "only hard limits count as violated";
  // Violating the limit lowers the cost by more than the L1 penalty.
  EXPECT_LT(small_weight.summary().cost, hard.summary().cost);
}

TEST_P(LimitedDdp, ConflictingLimits_EndWithLeastViolationAndNames) {
  // The start has zero speed, so the first row is violated by 0.5 in any case.
  TestProblem p = pendulum_swing_up(80);
  set_bounds(p, -4.0, 4.5);
  limit_states(p, {-infinity, 0.5}, {infinity, infinity});
  DdpSolver solver(p, to_convergence(GetParam()));
  const DdpSummary& s = solver.solve();
  EXPECT_EQ(s.reason, StopReason::Infeasible) << solver.text();
  EXPECT_EQ(s.violation_knot, 0);
  EXPECT_EQ(s.violation_row, 1);
  EXPECT_NEAR(s.violation, 0.5, 1e-9);
  const CostReport report = solver.cost_report();
  ASSERT_FALSE(report.limits.empty());
  EXPECT_EQ(report.limits[0].knot, 0) << "the report must name the violated limit";
  EXPECT_EQ(report.limits[0].row, "limit/x1");
  ASSERT_FALSE(s.conflict.empty());
  EXPECT_EQ(s.conflict[0].row, 1);
  EXPECT_NE(solver.text().find("no trajectory near this one satisfies all limits: 'limit/x1'"),
            std::string::npos)
      << solver.text();
  // A position that is out of reach: the solution turns at full speed toward it.
  TestProblem far = unicycle();
  set_bounds(far, -1.0, 1.0);
  limit_states(far, {-infinity, -infinity, 1.0}, {infinity, infinity, -1.0 + 2.5});
  far.start[2] = 0.0;
  DdpSolver turning(far, to_convergence(GetParam()));
  EXPECT_EQ(turning.solve().reason, StopReason::Infeasible) << turning.text();
  // The unicycle turns as fast as allowed: 10 knots of 0.1 rad.
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(turning.us()(k, 1), 1.0, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Updates, LimitedDdp,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& law) {
                           return law.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

}  // namespace
}  // namespace burnish::testing
