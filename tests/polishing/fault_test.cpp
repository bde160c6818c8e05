// Every fault except those of contact (contact_fault_test.cpp), provoked in closed loop: the
// report, and the robot coming to rest.
#include "burnish/mpc/fault.hpp"

#include <gtest/gtest.h>

#include "support/fault_checks.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

TEST(Fault, TimeStandsStill_ReportsStaleMeasurement) {
  MpcCase wanted;
  wanted.spoil = between(0.6, 0.64, [](Measurement& m) { m.time = 0.5995; });
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.65), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::StaleMeasurement, 0.62, 1e-3);
  EXPECT_EQ(run.mpc().fault().limit, 0.02);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, TimeLeaps_ReportsStaleMeasurement) {
  MpcCase wanted;
  wanted.spoil = between(0.6, 100.0, [](Measurement& m) { m.time += 0.1; });
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.65), Status::Ok);
  const FaultReport& fault = run.mpc().fault();
  EXPECT_EQ(fault.kind, FaultKind::StaleMeasurement);
  EXPECT_NEAR(fault.value, 0.1005, 1e-9);
  EXPECT_NEAR(fault.time, 0.7, 1e-9);
  expect_fallback(run);
}

TEST(Fault, InvalidMeasurement_ReportsBadMeasurement) {
  const double nan = std::nan("");
  const std::vector<std::function<void(Measurement&)>> corruptions{
      [&](Measurement& m) { m.q[3] = nan; },
      [&](Measurement& m) { m.v[0] = nan; },
      [&](Measurement& m) { m.tau[5] = std::numeric_limits<double>::infinity(); },
      [&](Measurement& m) { m.wrenches(1, 0) = nan; },
      [&](Measurement& m) { m.time = nan; },
      [](Measurement& m) { m.q.conservativeResize(5); },
      [](Measurement& m) { m.v.conservativeResize(7); },
      [](Measurement& m) { m.tau.resize(0); }};
  for (std::size_t i = 0; i < corruptions.size(); ++i) {
    SCOPED_TRACE(i);
    MpcCase wanted;
    wanted.spoil = between(0.6, 0.63, corruptions[i]);
    MpcRun run(wanted);
    ASSERT_EQ(run.run(0.64), Status::Ok);
    expect_report(run.mpc().fault(), FaultKind::BadMeasurement, 0.61, 1e-3);
    expect_fallback(run);
    expect_rest(run);

    // The controller bridges a single corrupt tick, at an update or between updates.
    for (const double when : {0.6, 0.6005}) {
      wanted.spoil = between(when, when + 5e-4, corruptions[i]);
      MpcRun bridged(wanted);
      ASSERT_EQ(bridged.polish(), Status::Ok);
      EXPECT_EQ(bridged.mpc().fault().kind, FaultKind::None) << bridged.mpc().fault().text();
      EXPECT_LT(bridged.metrics().force_mae, 0.1);
    }
  }
}

TEST(Fault, MeasurementsStop_DampingDecays) {
  // Measurements stop during a motion: the torque must not keep damping an old velocity.
  MpcCase wanted;
  wanted.task.path.rate = 8.0;
  wanted.spoil =
      between(1.0, 100.0, [](Measurement& m) { m.q.setConstant(std::nan("")), m.v = m.q; });
  MpcRun run(wanted);
  ASSERT_EQ(run.run(1.02), Status::Ok);
  ASSERT_EQ(run.mpc().fault().kind, FaultKind::BadMeasurement);
  const Model& model = run.mpc().problem().model();
  const Trace& last = run.mpc().fault().last_second;
  Eigen::VectorXd q(6), v(6);
  for (int k = 0; k < 6; ++k) {
    q[k] = last.column("q_" + model.q_name(k))[last.rows() - 1];
    v[k] = last.column("v_" + model.v_name(k))[last.rows() - 1];
  }
  ASSERT_GT(v.norm(), 0.1);
  const Eigen::VectorXd gravity = fallback_torque(model, q, Eigen::VectorXd::Zero(6));
  const Eigen::VectorXd damping = fallback_torque(model, q, v) - gravity;
  for (const double duration : {0.1, 0.4}) {
    ASSERT_EQ(run.run(duration), Status::Ok);
    const double decay =
        std::exp(-Fallback{}.damping * (run.now() - 5e-4 - run.mpc().fault().time));
    const Eigen::VectorXd due = gravity + decay * damping;
    EXPECT_LT((run.loop().command().tau - due).norm(), 1e-2 * damping.norm()) << duration;
  }
}

TEST(Fault, JointBeyondItsRange_ReportsOutOfRange) {
  MpcCase wanted;
  double limit = 0.0;
  wanted.change = [&](MpcSpec& spec) {
    // The approach moves the elbow beyond this limit.
    limit = spec.problem.initial_state[5] - 0.002;
    spec.problem.model.q_lower[5] = limit;
    spec.problem.model.q_upper[5] = limit + 0.004;
    spec.limits.joint_margin = 1e-3;
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  const FaultReport& fault = run.mpc().fault();
  ASSERT_EQ(fault.kind, FaultKind::OutOfRange) << fault.text();
  EXPECT_EQ(fault.joint, 5);
  EXPECT_NE(fault.value, fault.limit);
  EXPECT_NEAR(fault.value, fault.limit, 2e-3);
  expect_report(fault, FaultKind::OutOfRange, fault.time, 1e-9);
  expect_words(fault.text(), {"joint out of range", "joint 'arm_right_4_joint': position ",
                              " rad; the limit is "});
  expect_fallback(run);
  expect_rest(run);
}

/// Replaces the target of the tool's position in the stage "press".
void aim(MpcSpec& spec, const Signal::Function& function) {
  for (CostTerm& term : spec.problem.stages[2].costs)
    if (auto* position = std::get_if<residual::FramePosition>(&term.residual)) {
      const Signal before = position->target;
      position->target = Signal::over_time(3, [before, function](double t, auto p) {
        before.at(t, p);
        function(t, p);
      });
    }
}

TEST(Fault, TargetNotFinite_ReportsSolverFailed) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    aim(spec, [](double t, Eigen::Ref<Eigen::VectorXd> p) {
      if (t > 1.0) p[0] = std::nan("");
    });
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  // The horizon reaches 1 s at 0.7 s; the fifth update without a plan comes 40 ms later.
  expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.76, 0.011);
  EXPECT_EQ(run.mpc().fault().value, 5.0);
  expect_words(run.mpc().fault().text(),
               {"no usable plan for 5 updates", "a knot of the plan cannot be evaluated"});
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, TargetThrows_ReportsSolverFailed) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    aim(spec, [](double t, const Eigen::Ref<Eigen::VectorXd>&) {
      if (t > 1.0) throw std::runtime_error("no such point");
    });
    PressingTask pressing = *spec.task.target<PressingTask>();
    pressing.target = [target = pressing.target](double t) {
      if (t > 0.72) throw std::runtime_error("no such target");
      return target(t);
    };
    spec.task = pressing;
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.73), Status::Ok);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
  EXPECT_NE(run.loop().command().status, Status::Ok);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.76, 0.011);
  expect_fallback(run);
  const std::exception_ptr thrown = run.mpc().take_exception();
  ASSERT_TRUE(thrown);
  try {
    std::rethrow_exception(thrown);
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no such point");  // the first one
  }
  EXPECT_FALSE(run.mpc().take_exception());
}

/// Residual of a user that throws after a given time.
struct Throwing {
  int rows = 1;
  double after = 0.0;
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> out) const {
    if (at.time() > after) throw std::out_of_range("no such entry");
    out[0] = at.q()[0];
  }
};

TEST(Fault, ResidualThrowsInSolverThread_ReportsSolverFailed) {
  for (const int threads : {1, 2}) {
    MpcCase wanted;
    wanted.change = [threads](MpcSpec& spec) {
      spec.solver.threads = threads;
      for (Stage& stage : spec.problem.stages)
        stage.costs.push_back({.name = "throwing",
                               .residual = residual::custom(Throwing{.after = 1.0}),
                               .weight = 1e-6});
    };
    MpcRun run(wanted);
    ASSERT_EQ(run.run(0.69), Status::Ok);
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
    EXPECT_FALSE(run.mpc().take_exception());
    ASSERT_EQ(run.polish(), Status::Ok);
    expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.76, 0.011);
    expect_fallback(run);
    expect_rest(run);
    EXPECT_THROW(std::rethrow_exception(run.mpc().take_exception()), std::out_of_range);
    run.mpc().reset();
    EXPECT_FALSE(run.mpc().take_exception());
  }
}

TEST(Fault, FirstPlanFails_ReportsSolverFailedAtOnce) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) {
    spec.problem.stages[0].costs.push_back(
        {.name = "impossible",
         .residual = residual::FramePosition{
             "tool", Signal::over_time(3, [](double, Eigen::Ref<Eigen::VectorXd> p) {
               p.setConstant(std::nan(""));
             })}});
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.01), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::SolverFailed, 0.0, 0.0);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, FourFailedUpdates_ReportsNoFault) {
  for (const bool throws : {false, true}) {
    bool broken = false;
    MpcCase wanted;
    wanted.change = [&](MpcSpec& spec) {
      aim(spec, [&](double, Eigen::Ref<Eigen::VectorXd> p) {
        if (broken && throws) throw std::runtime_error("broken");
        if (broken) p[1] = std::nan("");
      });
    };
    MpcRun run(wanted);
    ASSERT_EQ(run.run(0.795), Status::Ok);
    broken = true;
    ASSERT_EQ(run.run(0.04), Status::Ok);  // four updates
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None);
    broken = false;
    ASSERT_EQ(run.run(0.6), Status::Ok);
    EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
    EXPECT_LT(run.metrics().force_mae, 0.1) << throws;
    EXPECT_LT(run.metrics().position_rmse, 3e-4) << throws;
  }
}

TEST(Fault, FiveMissedDeadlines_ReportsSolverLate) {
  MpcCase wanted;
  wanted.task.limits.deadline = 0.0;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.1), Status::Ok);
  // The first solve has no deadline; the five after it miss theirs.
  expect_report(run.mpc().fault(), FaultKind::SolverLate, 0.05, 1e-9);
  EXPECT_EQ(run.mpc().fault().value, 5.0);
  const Trace::Column missed = run.loop().trace().column("missed_deadline");
  EXPECT_EQ(missed[0], 0.0);
  EXPECT_EQ(missed[20], 1.0);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, PushIntoTheSurface_ReportsForceLimit) {
  MpcCase wanted;
  wanted.task.disturbances.pushes = {{0.8, 0.2, Eigen::Vector3d(0.0, 0.0, -150.0)}};
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_report(run.mpc().fault(), FaultKind::ForceLimit, 0.8025, 2.6e-3);
  EXPECT_GT(run.mpc().fault().value, 100.0);
  expect_fallback(run);
  expect_rest(run);
}

TEST(Fault, SingleForceSample_ReportsNoForceLimit) {
  // The touchdown on a rigid surface is an impulse of 0.1 Ns within one step of 0.5 ms.
  MpcRun run({});
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_GT(run.loop().trace().column("tool_force_z_world").maxCoeff(), 100.0);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();

  MpcCase strict;
  strict.task.tool_limits.force_window = 0.0;
  MpcRun hasty(strict);
  ASSERT_EQ(hasty.polish(), Status::Ok);
  EXPECT_EQ(hasty.mpc().fault().kind, FaultKind::ForceLimit);
}

TEST(Fault, FastToolOrJoint_ReportsSpeedLimit) {
  MpcCase wanted;
  wanted.task.tool_limits.tool_speed = 0.2;
  wanted.task.disturbances.pushes = {{0.05, 0.2, Eigen::Vector3d(0.0, 100.0, 0.0)}};
  MpcRun tool(wanted);
  ASSERT_EQ(tool.run(0.3), Status::Ok);
  expect_report(tool.mpc().fault(), FaultKind::SpeedLimit, 0.15, 0.1);
  EXPECT_EQ(tool.mpc().fault().joint, -1);
  EXPECT_NEAR(tool.mpc().fault().value, 0.2, 0.02);
  expect_fallback(tool);
  expect_rest(tool);

  wanted.task.tool_limits.tool_speed = 100.0;
  wanted.task.limits.joint_speed_ratio = 0.05;
  MpcRun joint(wanted);
  ASSERT_EQ(joint.run(0.3), Status::Ok);
  expect_report(joint.mpc().fault(), FaultKind::SpeedLimit, 0.15, 0.1);
  EXPECT_GE(joint.mpc().fault().joint, 0);
  expect_fallback(joint);
  expect_rest(joint);
}

TEST(Fault, Reset_ClearsTheFault) {
  MpcCase wanted;
  wanted.task.disturbances.pushes = {{0.8, 0.2, Eigen::Vector3d(0.0, 0.0, -150.0)}};
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_NE(run.mpc().fault().kind, FaultKind::None);
  run.reset();
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None);
  EXPECT_EQ(run.mpc().fault().last_second.rows(), 0);
  EXPECT_EQ(run.mpc().fault().text(), "no fault");
  ASSERT_EQ(run.run(0.7), Status::Ok);
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None);
}

TEST(Fault, EveryKind_HasItsOwnName) {
  std::vector<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(FaultKind::Watched); ++kind) {
    FaultReport report;
    report.kind = static_cast<FaultKind>(kind);
    names.emplace_back(name_of(report.kind));
    EXPECT_EQ(report.text().rfind(names.back(), 0), 0U) << report.text();
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace burnish::test
