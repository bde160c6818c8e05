// Limits that plans keep, in closed loop on the ideal plant: torques, ranges, speeds, a force band.
#include <gtest/gtest.h>

#include <functional>

#include "burnish/solver/ddp.hpp"
#include "support/mpc_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

/// Limits of a run, which reach into what it would do without.
struct LimitCase {
  const char* name;
  PlanLimits limits;
  double force_weight = 0.1;
  /// Of plans that break a limit by more than 1e-4 of its scale. They are made every 10 ms, of one
  /// iteration each: what is not linear is off by more than in the shipped task with its 1 ms.
  double share = 0.03;
};
void PrintTo(const LimitCase& wanted, std::ostream* out) { *out << wanted.name; }

/// Values of a column at the rows in which a plan was made.
Eigen::VectorXd at_plans(const Trace& trace, const std::string& column) {
  const auto values = trace.column(column), seconds = trace.column("solve_time");
  std::vector<double> kept;
  for (int row = 0; row < trace.rows(); ++row)
    if (trace.column("tick")[row] != 0.0 && seconds[row] > 0.0) kept.push_back(values[row]);
  return Eigen::Map<const Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
}

MpcCase limited(const LimitCase& of) {
  MpcCase wanted;
  wanted.task.constraints = of.limits;
  wanted.task.weights.force = of.force_weight;
  return wanted;
}

/// Of all plans, those that break a limit by more than 1e-4 of its scale.
double share_outside(const Trace& trace) {
  const Eigen::VectorXd outside = at_plans(trace, "limits_outside");
  return static_cast<double>((outside.array() > 1e-4).count()) /
         static_cast<double>(outside.size());
}

class PlanLimitsOf : public ::testing::TestWithParam<LimitCase> {};

TEST_P(PlanLimitsOf, are_kept_by_plans_and_by_what_is_sent) {
  const PlanLimits& limits = GetParam().limits;
  MpcRun run(limited(GetParam()));
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Trace& trace = run.loop().trace();
  EXPECT_GT(at_plans(trace, "limits_pushing").maxCoeff(), 0.0);
  EXPECT_EQ(at_plans(trace, "limits_infeasible").maxCoeff(), 0.0);
  EXPECT_LT(share_outside(trace), GetParam().share);
  EXPECT_LT(at_plans(trace, "limits_outside").maxCoeff(), 0.02);
  const Model& model = run.setting().robot.model;
  const Eigen::VectorXd most = std::min(1.0, limits.torque) * model.effort_limit;
  EXPECT_TRUE((run.watched().largest.array() <= most.array()).all());
  const Metrics metrics = run.metrics();
  EXPECT_LT(metrics.force_peak, std::min(limits.force_band, 1.0) + 0.1);
  EXPECT_GT(metrics.solver->at_limits + metrics.solver->clipped, 0);
}

TEST_P(PlanLimitsOf, give_the_same_bits_again_and_in_threads) {
  MpcRun run(limited(GetParam()));
  MpcCase in_threads = limited(GetParam());
  in_threads.change = [](MpcSpec& spec) { spec.solver.threads = 3; };
  MpcRun threads(in_threads);
  const auto torques = [](MpcRun& of) {
    EXPECT_EQ(of.run(0.9), Status::Ok);
    return Eigen::VectorXd(of.loop().command().tau);
  };
  const Eigen::VectorXd first = torques(run);
  run.reset();
  EXPECT_EQ(torques(run), first);
  EXPECT_EQ(torques(threads), first);
}

TEST_P(PlanLimitsOf, take_no_memory_in_ticks) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  MpcRun run(limited(GetParam()));
  ASSERT_EQ(run.run(0.8), Status::Ok);
  EXPECT_EQ(run.watched().allocations, 0);
}

INSTANTIATE_TEST_SUITE_P(All, PlanLimitsOf,
                         ::testing::Values(LimitCase{"torque", {.torque = 0.204}},
                                           LimitCase{"speed", {.joint_speed = 0.02}},
                                           LimitCase{"band", {.force_band = 0.5}, 1e-6, 0.6}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(PlanLimits, OfTorqueRates_AreKeptByPlansWithALag) {
  MpcCase wanted;
  wanted.task.torque_cutoff = 60.0;
  wanted.task.disturbances.torque_cutoff = 60.0;
  MpcRun free(wanted);
  ASSERT_EQ(free.polish(), Status::Ok);
  EXPECT_EQ(at_plans(free.loop().trace(), "limits_pushing").maxCoeff(), 0.0);
  wanted.task.constraints.joint_torque_rate = 10.0;
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Trace& trace = run.loop().trace();
  EXPECT_GT(at_plans(trace, "limits_pushing").maxCoeff(), 0.0);
  EXPECT_LT(share_outside(trace), 0.03);
}

TEST(PlanLimits, OfTorqueRates_AreRefusedWithoutALag) {
  MpcCase wanted;
  wanted.task.constraints.joint_torque_rate = 10.0;
  expect_words(refusal([&] { MpcRun run(wanted); }),
               {"constraints.joint_torque_rate", "controller.torque_cutoff above 0"});
}

/// The joint that moves most while it polishes, and where it goes.
struct Travel {
  int joint = 0;
  double low = 0.0, high = 0.0;
};
Travel widest(MpcRun& run) {
  const Trace& trace = run.loop().trace();
  const auto phase = trace.column("phase");
  Travel best;
  for (int k = 0; k < run.setting().robot.model.nq; ++k) {
    const auto q = trace.column("q_" + run.setting().robot.model.q_name(k));
    Travel own{k, infinity, -infinity};
    for (int row = 0; row < trace.rows(); ++row) {
      if (phase[row] != static_cast<double>(Phase::Track)) continue;
      own.low = std::min(own.low, q[row]);
      own.high = std::max(own.high, q[row]);
    }
    if (own.high - own.low > best.high - best.low) best = own;
  }
  return best;
}

TEST(PlanLimits, of_a_joints_range_are_touched_and_kept) {
  MpcRun free({});
  ASSERT_EQ(free.polish(), Status::Ok);
  const Travel travel = widest(free);
  const double upper = travel.high - 0.2 * (travel.high - travel.low);
  MpcCase wanted;
  wanted.change = [&](MpcSpec& spec) {
    const std::string joint =
        spec.problem.model.joints[static_cast<std::size_t>(travel.joint)].name;
    for (Stage& stage : spec.problem.stages)
      stage.constraints.push_back({.name = "cut",
                                   .residual = residual::JointPosition{{joint}},
                                   .upper = Eigen::VectorXd::Constant(1, upper)});
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Travel cut = widest(run);
  const auto q = run.loop().trace().column("q_" + run.setting().robot.model.q_name(travel.joint));
  EXPECT_LT(q.maxCoeff(), upper + 1e-4);
  EXPECT_GT(q.maxCoeff(), upper - 1e-4);
  EXPECT_LT(cut.high - cut.low, travel.high - travel.low);
  EXPECT_LT(run.metrics().force_peak, 1.0);
}

TEST(PlanLimits, that_a_push_breaks_are_come_back_to) {
  MpcCase wanted;
  wanted.task.constraints.joint_speed = 0.03;
  wanted.task.disturbances.pushes = {{0.6, 0.05, Eigen::Vector3d(0.0, 90.0, 0.0)}};
  wanted.task.tool_limits.force = infinity;
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Eigen::VectorXd outside = at_plans(run.loop().trace(), "limits_outside");
  EXPECT_GT(outside.maxCoeff(), 0.1);
  EXPECT_LT(outside.tail(20).maxCoeff(), 1e-3);
}

TEST(PlanLimits, that_the_start_breaks_are_refused) {
  MpcCase wanted;
  wanted.task.constraints.joint_margin = 0.3;
  expect_words(refusal([&] { MpcRun run(wanted); }),
               {"torso_2_joint", "0.2", "constraints.joint_margin", "0.3"});
}

TEST(PlanLimits, need_not_be_there) {
  PlanLimits none{.joint_margin = infinity, .joint_speed = infinity, .torque = infinity};
  MpcRun run(limited({"none", none}));
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_EQ(at_plans(run.loop().trace(), "limits_outside").maxCoeff(), 0.0);
}

TEST(PlanLimits, cut_what_is_sent_between_plans_too) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    spec.torque_limit = 0.205 * spec.problem.model.effort_limit;
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.5), Status::Ok);
  const Model& model = run.setting().robot.model;
  EXPECT_TRUE((run.watched().largest.array() <= 0.205 * model.effort_limit.array()).all());
  EXPECT_GT(run.loop().trace().column("clipped_torques").maxCoeff(), 0.0);
}

TEST(PlanLimits, that_are_wide_leave_the_robots_own) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    spec.torque_limit = 3.0 * spec.problem.model.effort_limit;
    for (Stage& stage : spec.problem.stages) stage.constraints.clear();
    spec.problem.model.effort_limit *= 0.205;
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.5), Status::Ok);
  EXPECT_TRUE(
      (run.watched().largest.array() <= 0.205 * run.setting().robot.model.effort_limit.array())
          .all());
}

TEST(PlanLimits, are_refused_where_they_are_none) {
  const auto refused = [](const std::function<void(MpcSpec&)>& change) {
    MpcCase wanted;
    wanted.change = change;
    return refusal([&] { MpcRun run(wanted); });
  };
  expect_words(refused([](MpcSpec& s) { s.torque_limit = Eigen::VectorXd::Ones(2); }),
               {"torque_limit has 2 entries", "wanted 6"});
  expect_words(refused([](MpcSpec& s) { s.torque_limit = Eigen::VectorXd::Constant(6, -1.0); }),
               {"torque_limit of", "is -1", "at least 0"});
  expect_words(refused([](MpcSpec& s) { s.first_factors = 0; }), {"first_factors is 0"});
  expect_words(refused([](MpcSpec& s) { s.max_factors = 0; }), {"max_factors is 0"});
}

}  // namespace
}  // namespace burnish::test
