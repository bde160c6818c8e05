// Limits on torque, joint range, speed and force in plans, in closed loop on the ideal plant.
#include <gtest/gtest.h>

#include <functional>

#include "burnish/solver/ddp.hpp"
#include "support/mpc_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

/// Limits that are active in a run: without them, the run would violate them.
struct LimitCase {
  const char* name;
  PlanLimits limits;
  double force_weight = 0.1;
  /// Largest allowed fraction of plans that violate a limit by more than 1e-4 of its scale. The
  /// test plans every 10 ms with one iteration each, so linearization errors exceed those of the
  /// shipped task, which plans every 1 ms.
  double max_fraction = 0.03;
};
void PrintTo(const LimitCase& wanted, std::ostream* out) { *out << wanted.name; }

/// Returns the values of a column in the rows in which the controller made a plan.
Eigen::VectorXd at_plans(const Trace& trace, const std::string& column) {
  const auto values = trace.column(column), seconds = trace.column("solve_time");
  std::vector<double> kept;
  for (int row = 0; row < trace.rows(); ++row)
    if (trace.column("tick")[row] != 0.0 && seconds[row] > 0.0) kept.push_back(values[row]);
  return Eigen::Map<const Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
}

MpcCase limited(const LimitCase& limit_case) {
  MpcCase wanted;
  wanted.task.constraints = limit_case.limits;
  wanted.task.weights.force = limit_case.force_weight;
  return wanted;
}

/// Returns the fraction of plans that violate a limit by more than 1e-4 of its scale.
double violating_fraction(const Trace& trace) {
  const Eigen::VectorXd violation = at_plans(trace, "constraint_violation");
  return static_cast<double>((violation.array() > 1e-4).count()) /
         static_cast<double>(violation.size());
}

class TightPlanLimits : public ::testing::TestWithParam<LimitCase> {};

TEST_P(TightPlanLimits, ClosedLoop_PlansAndCommandsKeepThem) {
  const PlanLimits& limits = GetParam().limits;
  MpcRun run(limited(GetParam()));
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Trace& trace = run.loop().trace();
  EXPECT_GT(at_plans(trace, "active_constraints").maxCoeff(), 0.0);
  EXPECT_EQ(at_plans(trace, "constraints_infeasible").maxCoeff(), 0.0);
  EXPECT_LT(violating_fraction(trace), GetParam().max_fraction);
  EXPECT_LT(at_plans(trace, "constraint_violation").maxCoeff(), 0.02);
  const Model& model = run.setting().robot.model;
  const Eigen::VectorXd max_torque = std::min(1.0, limits.torque) * model.effort_limit;
  EXPECT_TRUE((run.watched().largest.array() <= max_torque.array()).all());
  const Metrics metrics = run.metrics();
  EXPECT_LT(metrics.force_peak, std::min(limits.force_band, 1.0) + 0.1);
  EXPECT_GT(metrics.solver->at_limits + metrics.solver->clipped, 0);
}

TEST_P(TightPlanLimits, SecondRunOrThreads_GivesTheSameBits) {
  MpcRun run(limited(GetParam()));
  MpcCase in_threads = limited(GetParam());
  in_threads.change = [](MpcSpec& spec) { spec.solver.threads = 3; };
  MpcRun threads(in_threads);
  const auto torques = [](MpcRun& any_run) {
    EXPECT_EQ(any_run.run(0.9), Status::Ok);
    return Eigen::VectorXd(any_run.loop().command().tau);
  };
  const Eigen::VectorXd first = torques(run);
  run.reset();
  EXPECT_EQ(torques(run), first);
  EXPECT_EQ(torques(threads), first);
}

TEST_P(TightPlanLimits, Ticks_AllocateNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  MpcRun run(limited(GetParam()));
  ASSERT_EQ(run.run(0.8), Status::Ok);
  EXPECT_EQ(run.watched().allocations, 0);
}

INSTANTIATE_TEST_SUITE_P(All, TightPlanLimits,
                         ::testing::Values(LimitCase{"torque", {.torque = 0.204}},
                                           LimitCase{"speed", {.joint_speed = 0.02}},
                                           LimitCase{"band", {.force_band = 0.5}, 1e-6, 0.6}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(PlanLimits, TorqueRateWithActuatorLag_PlansKeepIt) {
  MpcCase wanted;
  wanted.task.torque_cutoff = 60.0;
  wanted.task.disturbances.torque_cutoff = 60.0;
  MpcRun free(wanted);
  ASSERT_EQ(free.polish(), Status::Ok);
  EXPECT_EQ(at_plans(free.loop().trace(), "active_constraints").maxCoeff(), 0.0);
  wanted.task.constraints.joint_torque_rate = 10.0;
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Trace& trace = run.loop().trace();
  EXPECT_GT(at_plans(trace, "active_constraints").maxCoeff(), 0.0);
  EXPECT_LT(violating_fraction(trace), 0.03);
}

TEST(PlanLimits, TorqueRateWithoutActuatorLag_IsRefused) {
  MpcCase wanted;
  wanted.task.constraints.joint_torque_rate = 10.0;
  expect_words(refusal([&] { MpcRun run(wanted); }),
               {"constraints.joint_torque_rate", "controller.torque_cutoff above 0"});
}

/// Range of positions of one joint during the phase Track.
struct Travel {
  int joint = 0;
  double low = 0.0, high = 0.0;
};
/// Returns the travel of the joint that moves most during the phase Track.
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

TEST(PlanLimits, JointRange_IsReachedAndKept) {
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

TEST(PlanLimits, PushViolatesSpeedLimit_PlansReturnWithinIt) {
  MpcCase wanted;
  wanted.task.constraints.joint_speed = 0.03;
  wanted.task.disturbances.pushes = {{0.6, 0.05, Eigen::Vector3d(0.0, 90.0, 0.0)}};
  wanted.task.tool_limits.force = infinity;
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  const Eigen::VectorXd violation = at_plans(run.loop().trace(), "constraint_violation");
  EXPECT_GT(violation.maxCoeff(), 0.1);
  EXPECT_LT(violation.tail(20).maxCoeff(), 1e-3);
}

TEST(PlanLimits, StartViolatesJointMargin_IsRefused) {
  MpcCase wanted;
  wanted.task.constraints.joint_margin = 0.3;
  expect_words(refusal([&] { MpcRun run(wanted); }),
               {"torso_2_joint", "0.2", "constraints.joint_margin", "0.3"});
}

TEST(PlanLimits, InfiniteLimits_AreNeverViolated) {
  PlanLimits none{.joint_margin = infinity, .joint_speed = infinity, .torque = infinity};
  MpcRun run(limited({"none", none}));
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_EQ(at_plans(run.loop().trace(), "constraint_violation").maxCoeff(), 0.0);
}

TEST(PlanLimits, TorqueLimit_ClipsCommandsBetweenPlans) {
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

TEST(PlanLimits, TorqueLimitAboveEffortLimit_EffortLimitStillHolds) {
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

TEST(PlanLimits, InvalidTorqueLimitOrFactorizations_IsRefused) {
  const auto refused = [](const std::function<void(MpcSpec&)>& change) {
    MpcCase wanted;
    wanted.change = change;
    return refusal([&] { MpcRun run(wanted); });
  };
  expect_words(refused([](MpcSpec& s) { s.torque_limit = Eigen::VectorXd::Ones(2); }),
               {"torque_limit has 2 entries", "wanted 6"});
  expect_words(refused([](MpcSpec& s) { s.torque_limit = Eigen::VectorXd::Constant(6, -1.0); }),
               {"torque_limit of", "is -1", "at least 0"});
  expect_words(refused([](MpcSpec& s) { s.first_max_factorizations = 0; }),
               {"first_max_factorizations is 0"});
  expect_words(refused([](MpcSpec& s) { s.max_factorizations = 0; }), {"max_factorizations is 0"});
}

}  // namespace
}  // namespace burnish::test
