// Record of the plans of a run: contents, and no influence on the run.
#include "burnish/report/plan_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/decomposition.hpp"
#include "burnish/tasks/polishing/run.hpp"

namespace burnish::polishing {
namespace {

RunSpec short_run(double plan_rate) {
  RunSpec spec;
  spec.task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm";
  spec.task.polish_duration = 0.3;
  spec.task.reach_duration = 0.2;
  spec.task.path.start_up = 0.2;
  spec.task.horizon = 0.5;
  spec.task.disturbances.force_noise = 0.3;
  spec.plant = PlantKind::Ideal;
  spec.plan_rate = plan_rate;
  return spec;
}

TEST(PlanRecord, Recording_LeavesTheRunUnchanged) {
  const RunResult with = run_task(short_run(100.0)), without = run_task(short_run(0.0));
  EXPECT_GT(with.plans.time.size(), 100U);
  EXPECT_TRUE(without.plans.time.empty());
  ASSERT_EQ(with.trace.rows(), without.trace.rows());
  for (const TraceColumn& column : with.trace.columns()) {
    if (column.name == "solve_time") continue;  // measured by the wall clock
    EXPECT_EQ(Eigen::VectorXd(with.trace.column(column.name)),
              Eigen::VectorXd(without.trace.column(column.name)))
        << column.name;
  }
  EXPECT_EQ(with.outcome.substr(0, 12), without.outcome.substr(0, 12));
}

TEST(PlanRecord, Plans_StartAtTheRobotAndNameTheirCosts) {
  RunSpec spec = short_run(20.0);
  spec.task.disturbances = {};
  const RunResult result = run_task(spec);
  const PlanRecord& plans = result.plans;
  const std::size_t count = plans.time.size();
  const double duration = result.trace.at(result.trace.rows() - 1, 0);
  EXPECT_NEAR(static_cast<double>(count), 20.0 * duration, 2.0);
  EXPECT_EQ(plans.knots, 11);
  EXPECT_DOUBLE_EQ(plans.step, 0.05);
  ASSERT_EQ(plans.q.size(), count * 11 * 6);
  const Model& model = result.setting.robot.model;
  const auto time = result.trace.column("time");
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Index row = 0;
    (time.array() - plans.time[i]).abs().minCoeff(&row);
    EXPECT_NEAR(time[row], plans.time[i], 1e-9);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(plans.q[i * 66 + static_cast<std::size_t>(k)],
                  result.trace.column("q_" + model.q_name(k))[row], 1e-6);
  }
  ASSERT_EQ(plans.costs.size(), plans.terms.size());
  const auto costs_of = [&](const std::string& name) {
    const auto found = std::find(plans.terms.begin(), plans.terms.end(), name);
    EXPECT_NE(found, plans.terms.end()) << name;
    return plans.costs.at(static_cast<std::size_t>(found - plans.terms.begin()));
  };
  for (const std::vector<double>& costs : plans.costs) {
    ASSERT_EQ(costs.size(), count);
    for (const double cost : costs) EXPECT_GE(cost, 0.0);
  }
  // The last plans retreat, so their force cost is zero.
  const std::vector<double> force = costs_of("force");
  EXPECT_EQ(force.back(), 0.0);
  EXPECT_GT(*std::max_element(force.begin(), force.end()), 0.0);
  EXPECT_GT(costs_of("position").front(), 0.0);
}

TEST(PlanRecord, PlanStarts_HavePolicyAndValueFunction) {
  const RunResult result = run_task(short_run(20.0));
  const PlanStart& start = result.plans.start;
  const std::size_t count = result.plans.time.size();
  ASSERT_EQ(start.nx, 12);
  ASSERT_EQ(start.ndx, 12);
  ASSERT_EQ(start.nu, 6);
  ASSERT_EQ(start.x.size(), count * 12);
  ASSERT_EQ(start.u.size(), count * 6);
  ASSERT_EQ(start.K.size(), count * 6 * 12);
  ASSERT_EQ(start.Vx.size(), count * 12);
  ASSERT_EQ(start.Vxx.size(), count * 12 * 12);
  for (std::size_t i = 0; i < count; ++i) {
    // The posture of the plan, which the record stores in single precision.
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_NEAR(start.x[12 * i + k], result.plans.q[i * 66 + k], 1e-6);
    const Eigen::MatrixXd Vxx =
        Eigen::Map<const Eigen::MatrixXd>(start.Vxx.data() + 144 * i, 12, 12);
    EXPECT_LT((Vxx - Vxx.transpose()).norm(), 1e-9 * Vxx.norm());
    EXPECT_GT(symmetric_eigen(Vxx).values[0], 0.0);
  }
}

TEST(PlanRecord, BaselineRun_RecordsNoPlans) {
  RunSpec spec = short_run(20.0);
  spec.controller = ControllerKind::Baseline;
  EXPECT_TRUE(run_task(spec).plans.time.empty());
}

/// Recorded postures are evenly spaced in time, also with knots of growing length.
TEST(PlanRecord, UnevenKnots_AreRecordedEvenly) {
  RunSpec even = short_run(20.0);
  even.task.disturbances = {};
  even.task.approach_speed *= 2.0;  // so that the postures of a plan differ
  RunSpec growing = even;
  growing.task.knots = 25;
  const RunResult wanted = run_task(even), got = run_task(growing);
  EXPECT_EQ(got.outcome.substr(0, 8), wanted.outcome.substr(0, 8));
  ASSERT_EQ(got.plans.knots, wanted.plans.knots);
  EXPECT_EQ(got.plans.step, wanted.plans.step);
  ASSERT_GE(got.plans.time.size(), 3U);
  // The first plan, before contact, has nearly the same postures as with even knots.
  const auto values_per_plan = static_cast<std::size_t>(got.plans.knots * got.plans.nq);
  double moved = 0.0;
  for (std::size_t i = 0; i < values_per_plan; ++i) {
    EXPECT_NEAR(got.plans.q[i], wanted.plans.q[i], 5e-3) << i;
    moved = std::max(moved, std::abs(static_cast<double>(got.plans.q[i]) -
                                     static_cast<double>(got.plans.q[i % 6])));
  }
  EXPECT_GT(moved, 0.02);
}

}  // namespace
}  // namespace burnish::polishing
