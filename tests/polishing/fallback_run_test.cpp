// Accuracy of the fallback controller after each fault, with an inexact model of the robot.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "support/mpc_run.hpp"

namespace burnish::test {
namespace {

/// Robot 5 % heavier than its model, with a torque bias of 2 Nm at every joint.
MpcCase wrong_model() {
  MpcCase wanted;
  wanted.task.disturbances.mass_scale = 1.05;
  wanted.task.disturbances.torque_bias = Eigen::VectorXd::Constant(6, 2.0);
  return wanted;
}

struct FaultCase {
  FaultKind kind;
  double until;                           ///< Time at which the cause of the fault ends [s]
  std::function<void(MpcCase&)> arrange;  ///< Sets up the cause
};

void push(MpcCase& wanted, double start, const Eigen::Vector3d& force) {
  wanted.task.disturbances.pushes = {{start, 0.2, force}};
}

std::vector<FaultCase> fault_cases() {
  const auto spoil = [](MpcCase& wanted, auto change) {
    wanted.spoil = [change](Measurement& m) {
      if (m.time > 0.7 && m.time < 0.75) change(m);
    };
  };
  return {
      {FaultKind::StaleMeasurement, 0.8,
       [=](MpcCase& w) { spoil(w, [](Measurement& m) { m.time = 0.7; }); }},
      {FaultKind::BadMeasurement, 0.8,
       [=](MpcCase& w) { spoil(w, [](Measurement& m) { m.q[2] = std::nan(""); }); }},
      {FaultKind::OutOfRange, 0.5,
       [](MpcCase& w) {
         w.change = [](MpcSpec& spec) {
           spec.problem.model.q_lower[5] = spec.problem.initial_state[5] - 0.002;
           spec.problem.model.q_upper[5] = spec.problem.initial_state[5] + 0.002;
           spec.limits.joint_margin = 1e-3;
         };
       }},
      {FaultKind::SolverFailed, 0.8,
       [](MpcCase& w) {
         w.change = [](MpcSpec& spec) {
           spec.problem.stages[2].costs.push_back(
               {.name = "impossible",
                .residual =
                    residual::FramePosition{
                        "tool", Signal::over_time(3,
                                                  [](double t, Eigen::Ref<Eigen::VectorXd> p) {
                                                    p.setConstant(t > 1.0 ? std::nan("") : 0.0);
                                                  })},
                .weight = 1e-9});
         };
       }},
      {FaultKind::SolverLate, 0.1, [](MpcCase& w) { w.task.limits.deadline = 0.0; }},
      {FaultKind::ContactLost, 1.0,
       [](MpcCase& w) {
         w.task.tool_limits.contact_lost = 0.02;
         push(w, 0.8, {0.0, 0.0, 80.0});
       }},
      {FaultKind::NoContact, 1.6, [](MpcCase& w) { w.task.disturbances.surface_height = -0.2; }},
      {FaultKind::ContactLate, 0.5,
       [](MpcCase& w) {
         w.task.disturbances.surface_height = -0.2;
         w.task.tool_limits.late_contact_time = 0.1;
       }},
      {FaultKind::UnexpectedContact, 0.5,
       [](MpcCase& w) {
         w.task.reach_duration = 0.5;
         w.task.point_base = polishing::make_setting(w.task).p_start -
                             (w.task.tip_radius + 0.04) * w.task.normal_base;
         w.task.disturbances.surface_height = 0.02;
       }},
      {FaultKind::ForceLimit, 1.0,
       [](MpcCase& w) {
         push(w, 0.8, {0.0, 0.0, -150.0});
       }},
      {FaultKind::SpeedLimit, 0.25, [](MpcCase& w) {
         w.task.tool_limits.tool_speed = 0.3;
         push(w, 0.05, {0.0, 100.0, 0.0});
       }}};
}

Eigen::Vector3d tool_of(MpcRun& run) {
  return frame_placement(run.setting().robot.model, run.plant().q(), "tool").translation();
}

/// Runs until the fault occurs and on until its cause has ended.
void run_into_fault(MpcRun& run, const FaultCase& fault_case) {
  while (run.mpc().fault().kind == FaultKind::None && run.now() < 2.5)
    ASSERT_EQ(run.run(5e-4), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, fault_case.kind) << run.mpc().fault().text();
  if (run.now() < fault_case.until) {
    ASSERT_EQ(run.run(fault_case.until - run.now()), Status::Ok);
  }
}

TEST(Fallback, AnyFaultWithWrongModel_KeepsTheRobotInPlace) {
  for (const FaultCase& fault_case : fault_cases()) {
    SCOPED_TRACE(name_of(fault_case.kind));
    MpcCase wanted = wrong_model();
    fault_case.arrange(wanted);
    MpcRun run(wanted);
    run_into_fault(run, fault_case);
    const Eigen::Vector3d at_fault = tool_of(run);
    ASSERT_EQ(run.run(0.5), Status::Ok);
    const Eigen::Vector3d at_rest = tool_of(run);
    double drift = 0.0, max_force = 0.0;
    for (int i = 0; i < 60; ++i) {
      ASSERT_EQ(run.run(0.05), Status::Ok);
      drift = std::max(drift, (tool_of(run) - at_rest).norm());
      max_force = std::max(max_force, run.plant().wrenches().col(0).head<3>().norm());
    }
    RecordProperty(std::string(name_of(fault_case.kind)) + " mm",
                   std::to_string(1e3 * (at_rest - at_fault).norm()) + " + " +
                       std::to_string(1e3 * drift) + ", N " + std::to_string(max_force));
    EXPECT_LT(drift, 1e-3) << "the tool sinks";
    EXPECT_LT((at_rest - at_fault).norm(), 0.015);
    EXPECT_LT(run.plant().v().norm(), 1e-3);
    EXPECT_LT(max_force, 30.0);
    EXPECT_TRUE(run.watched().finite);
    EXPECT_TRUE(
        (run.watched().largest.array() <= run.mpc().problem().model().effort_limit.array()).all());
    if (AllocationGuard::unavailable() == nullptr) {
      EXPECT_EQ(run.watched().allocations, 0);
    }
  }
}

TEST(Fallback, ZeroStiffness_LetsTheRobotSink) {
  MpcCase wanted = wrong_model();
  wanted.task.limits.deadline = 0.0;
  wanted.task.fallback.stiffness = 0.0;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.5), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::SolverLate);
  const Eigen::Vector3d before = tool_of(run);
  ASSERT_EQ(run.run(1.5), Status::Ok);
  EXPECT_GT((tool_of(run) - before).norm(), 0.03);
}

TEST(Fallback, WeakOrHardPush_SpringsBackOrYields) {
  const auto pushed = [](double force, double duration) {
    MpcCase wanted;
    wanted.task.limits.deadline = 0.0;
    wanted.task.disturbances.pushes = {{0.5, duration, Eigen::Vector3d(0.0, force, 0.0)}};
    return wanted;
  };
  // 20 N displace the tool a little, and it springs back.
  MpcRun gentle(pushed(20.0, 1.0));
  ASSERT_EQ(gentle.run(0.5), Status::Ok);
  ASSERT_EQ(gentle.mpc().fault().kind, FaultKind::SolverLate);
  const Eigen::Vector3d start = tool_of(gentle);
  ASSERT_EQ(gentle.run(1.0), Status::Ok);
  const double moved = (tool_of(gentle) - start).norm();
  ASSERT_EQ(gentle.run(1.0), Status::Ok);
  RecordProperty("20 N mm", std::to_string(1e3 * moved));
  EXPECT_GT(moved, 1e-3);
  EXPECT_LT(moved, 0.02);
  EXPECT_LT((tool_of(gentle) - start).norm(), 1e-3);

  // 150 N displace the tool slowly, and it stays near the place where the push ends.
  MpcRun hard(pushed(150.0, 0.3));
  ASSERT_EQ(hard.run(0.8), Status::Ok);
  const Eigen::Vector3d left = tool_of(hard);
  EXPECT_GT((left - start).norm(), 0.05);
  ASSERT_EQ(hard.run(1.0), Status::Ok);
  EXPECT_LT((tool_of(hard) - left).norm(), 0.05);
  EXPECT_LT(hard.plant().v().norm(), 1e-3);
  EXPECT_TRUE(
      (hard.watched().largest.array() <= hard.mpc().problem().model().effort_limit.array()).all());
}

TEST(Fallback, NoisyLateOrLostMeasurements_KeepsTheRobotInPlace) {
  MpcCase wanted = wrong_model();
  Disturbances& d = wanted.task.disturbances;
  d.command_delay = 2e-3;
  d.encoder_bits = 17;
  d.finite_difference_velocity = true;
  d.velocity_cutoff = 314.0;
  d.torque_noise = 0.05;
  wanted.task.limits.deadline = 0.0;
  wanted.spoil = [tick = 0](Measurement& m) mutable {
    if (++tick % 10 == 0) m.q[1] = std::nan("");
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.5), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::SolverLate) << run.mpc().fault().text();
  const Eigen::Vector3d before = tool_of(run);
  ASSERT_EQ(run.run(3.0), Status::Ok);
  EXPECT_LT((tool_of(run) - before).norm(), 1e-3);
  EXPECT_LT(run.plant().v().norm(), 0.02);
}

}  // namespace
}  // namespace burnish::test
