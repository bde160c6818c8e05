// Model predictive control in closed loop on the ideal plant: accuracy, repeatability, robustness.
#include <gtest/gtest.h>

#include <random>

#include "burnish/mpc/mpc.hpp"
#include "support/mpc_run.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

MpcCase with_bias(ModelErrorKind kind) {
  MpcCase wanted;
  wanted.task.disturbances.torque_bias = Eigen::VectorXd::Constant(6, 1.0);
  wanted.task.model_error.kind = kind;
  return wanted;
}

void expect_no_fault(MpcRun& run) {
  EXPECT_EQ(run.mpc().fault().kind, FaultKind::None) << run.mpc().fault().text();
}

Eigen::VectorXd last_row(const Trace& trace) {
  Eigen::VectorXd row(static_cast<Eigen::Index>(trace.columns().size()));
  for (Eigen::Index i = 0; i < row.size(); ++i)
    row[i] = trace.at(trace.rows() - 1, static_cast<int>(i));
  row[trace.index("solve_time")] = 0.0;  // measured by the wall clock
  return row;
}

TEST(MpcController, WholeTask_PressesAndFollowsThePath) {
  MpcRun run({});
  ASSERT_EQ(run.polish_and_retreat(), Status::Ok);
  expect_no_fault(run);
  const Metrics m = run.metrics();
  EXPECT_LT(m.force_mae, 0.1);
  EXPECT_LT(m.force_peak, 0.2);
  EXPECT_LT(m.position_rmse, 3e-4);
  EXPECT_EQ(m.without_contact, 0.0);
  EXPECT_LT(m.estimate_rmse, 0.01);
  const Trace& trace = run.loop().trace();
  const Trace::Column phase = trace.column("phase");
  for (int row = 1; row < trace.rows(); ++row) ASSERT_GE(phase[row], phase[row - 1]);
  EXPECT_EQ(phase[0], static_cast<double>(Phase::Reach));
  EXPECT_EQ(phase[trace.rows() - 1], static_cast<double>(Phase::Retreat));
  // The tool is in the air again.
  EXPECT_EQ(trace.column("in_contact")[trace.rows() - 1], 0.0);
  EXPECT_EQ(run.mpc().plan().rows(), 31);
}

TEST(MpcController, SecondRunOrReset_GivesTheSameBits) {
  MpcCase wanted = with_bias(ModelErrorKind::Torque);
  wanted.task.solver_delay = 0.005;
  MpcRun once(wanted), again(wanted);
  ASSERT_EQ(once.run(0.8), Status::Ok);
  const Eigen::VectorXd first = last_row(once.loop().trace());
  // A second controller gives the same row, before and after a run with a fault.
  ASSERT_EQ(again.run(0.8), Status::Ok);
  EXPECT_EQ(last_row(again.loop().trace()), first);
  again.watched().spoil = [](Measurement& m) { m.q.setConstant(std::nan("")); };
  ASSERT_EQ(again.run(0.1), Status::Ok);
  EXPECT_NE(again.mpc().fault().kind, FaultKind::None);
  again.watched().spoil = nullptr;
  again.reset();
  ASSERT_EQ(again.run(0.8), Status::Ok);
  EXPECT_EQ(last_row(again.loop().trace()), first);
}

TEST(MpcController, Ticks_AllocateNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  std::vector<MpcCase> cases(6);
  cases[1].task.model_error.kind = ModelErrorKind::Force;
  cases[2].task.solver_delay = 0.005;
  cases[2].task.model_error.kind = ModelErrorKind::None;
  cases[3].task.torque_cutoff = cases[3].task.disturbances.torque_cutoff = 100.0;
  cases[4].task.disturbances.surface_height = 0.002;  // contact is early
  // A fault and the fallback after it.
  cases[5].spoil = [](Measurement& m) {
    if (m.time > 0.5) m.v[1] = infinity;
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    MpcRun run(cases[i]);
    ASSERT_EQ(run.run(0.8), Status::Ok);
    EXPECT_EQ(run.watched().ticks, 1600);
    EXPECT_EQ(run.watched().allocations, 0) << "case " << i;
    EXPECT_EQ(run.mpc().fault().kind != FaultKind::None, i == 5) << run.mpc().fault().text();
  }
}

TEST(MpcController, SolverDelay_LeavesTheErrorsUnchanged) {
  MpcRun at_once({});
  ASSERT_EQ(at_once.polish(), Status::Ok);
  // With 10 ms, a plan takes effect when the controller makes the next one.
  for (const double delay : {5e-3, 10e-3}) {
    MpcCase wanted;
    wanted.task.solver_delay = delay;
    MpcRun delayed(wanted);
    ASSERT_EQ(delayed.polish(), Status::Ok);
    expect_no_fault(delayed);
    EXPECT_NEAR(delayed.metrics().force_mae, at_once.metrics().force_mae, 0.02) << delay;
    EXPECT_NEAR(delayed.metrics().position_rmse, at_once.metrics().position_rmse, 5e-5) << delay;
  }
}

TEST(MpcController, SolverDelay_PlanTakesEffectAfterIt) {
  MpcCase wanted;
  wanted.task.solver_delay = 5e-3;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.7), Status::Ok);
  // The update at 0.7 s takes effect at 0.705 s; the gain changes only then.
  Eigen::MatrixXd gain = run.mpc().feedback().gain;
  std::vector<int> changed;
  for (int tick = 0; tick < 20; ++tick) {
    ASSERT_EQ(run.run(5e-4), Status::Ok);
    // The knots of a plan are 10 ms apart.
    if (run.mpc().feedback().gain != gain) changed.push_back(tick);
    gain = run.mpc().feedback().gain;
  }
  EXPECT_EQ(changed, std::vector<int>{10});
}

int plans_of(MpcRun& run) {
  return static_cast<int>((run.loop().trace().column("solve_time").array() > 0.0).count());
}

TEST(MpcController, MeasuredTiming_PlansTakeTheirSolveTime) {
  MpcCase quick;
  quick.task.timing = PlanTiming::Measured;
  quick.task.slowdown = 1e-6;
  MpcRun run(quick);
  ASSERT_EQ(run.polish_and_retreat(), Status::Ok);
  expect_no_fault(run);
  EXPECT_LT(run.metrics().force_rmse, 1.0);

  MpcCase stuck = quick;
  stuck.task.slowdown = 1e9;  // the second plan is never done
  MpcRun waits(stuck);
  ASSERT_EQ(waits.run(0.1), Status::Ok);
  EXPECT_EQ(plans_of(waits), 2);
  expect_no_fault(waits);
}

TEST(MpcController, SettleTime_RobotStaysAtItsStart) {
  MpcCase wanted;
  wanted.change = [](MpcSpec& spec) { spec.settle = 0.1; };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.09), Status::Ok);
  EXPECT_EQ(plans_of(run), 0);
  EXPECT_EQ(run.mpc().schedule().time(), 0.0);
  EXPECT_LT((run.plant().q() - run.setting().q_start).norm(), 1e-6);
  ASSERT_EQ(run.run(0.05), Status::Ok);
  EXPECT_GT(plans_of(run), 0);
  EXPECT_NEAR(run.mpc().schedule().time(), 0.04, 2e-3);
}

TEST(MpcController, SolverDelay_PlanStartsFromThePredictedState) {
  for (const double delay : {4e-3, 10e-3, 15e-3}) {  // the last one is longer than a knot
    MpcCase wanted;
    wanted.task.update_rate = 50.0;
    wanted.task.solver_delay = delay;
    wanted.task.path.rate = 8.0;
    MpcRun run(wanted);
    ASSERT_EQ(run.run(1.0), Status::Ok);
    ASSERT_EQ(run.run(5e-4), Status::Ok);  // the tick of an update
    const Eigen::VectorXd planned = run.mpc().plan().row(0).transpose();
    const Eigen::VectorXd from = run.watched().seen.q;
    ASSERT_EQ(run.run(delay - 5e-4), Status::Ok);
    const double moved = (run.plant().q() - from).norm();
    const double error = (run.plant().q() - planned.head(6)).norm();
    EXPECT_GT(moved, 1e-4);
    EXPECT_LT(error, 0.02 * moved) << delay;
  }
}

TEST(MpcController, NoModelErrorEstimate_ForceErrorRemains) {
  MpcRun run(with_bias(ModelErrorKind::None));
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_no_fault(run);
  EXPECT_GT(run.metrics().force_mae, 5.0);
  EXPECT_TRUE(run.mpc().torque_error().isZero(0.0));
  EXPECT_EQ(run.mpc().force_error()[0], 0.0);
}

TEST(MpcController, TorqueErrorEstimate_RemovesTheForceError) {
  MpcCase wanted = with_bias(ModelErrorKind::Torque);
  // A friction estimate would take part of the bias as friction.
  wanted.task.model_error.joint_friction = false;
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_no_fault(run);
  EXPECT_LT(run.metrics().force_mae, 0.1);
  // The bias counts once, although the torque sensors measure it too.
  EXPECT_LT(run.metrics().estimate_rmse, 0.01);
  EXPECT_LT((run.mpc().torque_error() - Eigen::VectorXd::Constant(6, 1.0)).norm(), 0.05);
}

TEST(MpcController, ForceErrorEstimate_RemovesTheForceError) {
  MpcRun run(with_bias(ModelErrorKind::Force));
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_no_fault(run);
  EXPECT_LT(run.metrics().force_mae, 0.1);
  EXPECT_GT(std::abs(run.mpc().force_error()[0]), 5.0);
  EXPECT_TRUE(run.mpc().torque_error().isZero(0.0));
}

TEST(MpcController, ActuatorLag_ForceAndPathStayAccurate) {
  for (const double bias : {0.0, 1.0}) {
    MpcCase wanted;
    wanted.task.torque_cutoff = wanted.task.disturbances.torque_cutoff = 100.0;
    wanted.task.disturbances.torque_bias = Eigen::VectorXd::Constant(6, bias);
    // A friction estimate would take part of the bias as friction.
    wanted.task.model_error.joint_friction = false;
    MpcRun run(wanted);
    ASSERT_EQ(run.polish(), Status::Ok);
    expect_no_fault(run);
    EXPECT_EQ(run.mpc().feedback().gain.cols(), 18);
    EXPECT_LT(run.metrics().force_mae, 0.15) << bias;
    EXPECT_LT(run.metrics().position_rmse, 3e-4) << bias;
    // The estimate does not include the lag of the actuators.
    EXPECT_LT((run.mpc().torque_error() - Eigen::VectorXd::Constant(6, bias)).norm(), 0.02);
  }
}

TEST(MpcController, NoFeedback_SendsTheFeedforwardTorque) {
  MpcCase wanted;
  wanted.task.feedback = false;
  MpcRun run(wanted);
  ASSERT_EQ(run.run(0.8051), Status::Ok);
  expect_no_fault(run);
  EXPECT_EQ(run.loop().command().tau, run.mpc().feedback().feedforward);
}

TEST(MpcController, UpdatePeriodBetweenKnots_ForceAndPathStayAccurate) {
  for (const double rate : {400.0, 80.0}) {
    MpcCase wanted;
    wanted.task.update_rate = rate;
    MpcRun run(wanted);
    ASSERT_EQ(run.polish(), Status::Ok);
    expect_no_fault(run);
    EXPECT_LT(run.metrics().force_mae, 0.1) << rate;
    EXPECT_LT(run.metrics().position_rmse, 3e-4) << rate;
  }
}

TEST(MpcController, SurfaceHeightWrong_RampStartsAtTheTouch) {
  for (const double height : {0.003, -0.01}) {
    MpcCase wanted;
    wanted.task.disturbances.surface_height = height;
    MpcRun run(wanted);
    // Contact is planned at 0.3 s; until the touch, the schedule repeats the last 50 ms before it.
    ASSERT_EQ(run.run(2.0), Status::Ok);
    expect_no_fault(run);
    const Trace& trace = run.loop().trace();
    const Trace::Column contact = trace.column("in_contact"), phase = trace.column("phase");
    int touch = 0, ramp = 0;
    for (int row = 0; row < trace.rows(); ++row) {
      if (touch == 0 && contact[row] != 0.0) touch = row;
      if (ramp == 0 && phase[row] == static_cast<double>(Phase::Ramp)) ramp = row;
    }
    EXPECT_EQ(trace.at(touch, 0) < 0.3, height > 0.0);
    EXPECT_LE(std::abs(ramp - touch), 1) << height;
    EXPECT_GT(contact.segment(touch + 400, 1600).minCoeff(), 0.0) << height;
    EXPECT_NEAR(trace.column("tool_force_z_world")[touch + 1400], 30.0, 0.6) << height;
  }
}

TEST(MpcController, Push_TorquesKeepEffortLimits) {
  MpcCase wanted;
  Eigen::VectorXd limit;
  wanted.change = [&](MpcSpec& spec) {
    limit = 0.35 * spec.problem.model.effort_limit;
    spec.problem.model.effort_limit = limit;
  };
  wanted.task.disturbances.pushes = {{0.4, 0.05, Eigen::Vector3d(60.0, 0.0, 0.0)}};
  MpcRun run(wanted);
  ASSERT_EQ(run.polish(), Status::Ok);
  EXPECT_TRUE(run.watched().finite);
  EXPECT_TRUE((run.watched().largest.array() <= limit.array()).all())
      << run.watched().largest.transpose();
  EXPECT_TRUE((run.watched().largest.array() == limit.array()).any())
      << "no torque reached its limit";
}

TEST(MpcController, CorruptMeasurements_TorqueStaysFinite) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  const double corrupt_values[] = {std::nan(""), infinity, -infinity, 1e300, -1e300, 0.0, 50.0};
  for (int trial = 0; trial < 20; ++trial) {
    MpcCase wanted;
    wanted.spoil = [&](Measurement& m) {
      if (draw(generator) > 0.2) return;
      const double value = corrupt_values[generator() % 7];
      const auto entry = static_cast<Eigen::Index>(generator() % 6);
      switch (generator() % 6) {
        case 0:
          m.time = value;
          break;
        case 1:
          m.q[entry] = value;
          break;
        case 2:
          m.v[entry] = value;
          break;
        case 3:
          m.tau[entry] = value;
          break;
        case 4:
          m.wrenches(entry % 3, 0) = value;
          break;
        default:
          m.q.resize(entry);
      }
    };
    MpcRun run(wanted);
    ASSERT_EQ(run.run(0.05), Status::Ok);
    EXPECT_TRUE(run.watched().finite);
  }
}

TEST(MpcController, FirstMeasurementsInvalid_WaitsForAValidOne) {
  MpcCase wanted;
  wanted.spoil = [](Measurement& m) {
    if (m.time < 0.004) m.v[0] = std::nan("");
  };
  MpcRun run(wanted);
  ASSERT_EQ(run.run(5e-4), Status::Ok);
  EXPECT_EQ(run.loop().command().status, Status::NotFinite);
  EXPECT_GT(run.loop().command().tau.norm(), 1.0)
      << "the command does not support the robot against gravity";
  ASSERT_EQ(run.run(0.0045), Status::Ok);
  // The first solve happens at once, not at the next update period.
  EXPECT_GT(run.mpc().feedback().gain.norm(), 0.0);
  ASSERT_EQ(run.polish(), Status::Ok);
  expect_no_fault(run);
  EXPECT_LT(run.metrics().force_mae, 0.1);
}

TEST(MpcController, ClockOffset_ChangesNothing) {
  MpcCase wanted;
  wanted.spoil = [](Measurement& m) { m.time += 1.7e9; };  // seconds since 1970
  MpcRun run(wanted), plain({});
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(plain.polish(), Status::Ok);
  expect_no_fault(run);
  EXPECT_NEAR(run.metrics().force_mae, plain.metrics().force_mae, 0.01);
  EXPECT_NEAR(run.mpc().schedule().time(), plain.mpc().schedule().time(), 1e-3);
}

TEST(MpcController, LostTicks_ScheduleStillAdvances) {
  MpcCase wanted;
  // Every tenth measurement is invalid, some of them at updates.
  wanted.spoil = [tick = 0](Measurement& m) mutable {
    if (tick++ % 10 == 0) m.q[2] = std::nan("");
  };
  MpcRun run(wanted), plain({});
  ASSERT_EQ(run.polish(), Status::Ok);
  ASSERT_EQ(plain.polish(), Status::Ok);
  expect_no_fault(run);
  EXPECT_NEAR(run.mpc().schedule().time(), plain.mpc().schedule().time(), 2e-3);
  EXPECT_NEAR(run.metrics().force_mae, plain.metrics().force_mae, 0.05);
}

TEST(MpcController, InvalidSpec_IsRefused) {
  const polishing::Task task = short_task();
  const polishing::Setting setting = polishing::make_setting(task);
  const MpcSpec good = polishing::make_mpc(task, setting);
  const auto with = [&](auto&& change) {
    MpcSpec spec = good;
    change(spec);
    return refusal([&] { MpcController{spec}; });
  };
  using S = MpcSpec;
  const double nan = std::nan("");
  EXPECT_EQ(with([](S&) {}), "");
  expect_words(with([](S& s) { s.tools[0].normal_base.setZero(); }), {"normal"});
  expect_words(with([&](S& s) { s.tools[0].normal_base[1] = nan; }), {"normal"});
  expect_words(with([](S& s) { s.tools[0].frame = "tolo"; }), {"tolo", "tool"});
  expect_words(with([](S& s) { s.schedule.clear(); }), {"phases"});
  expect_words(with([](S& s) { s.schedule[0].stage = "raech"; }), {"raech", "reach"});
  expect_words(with([](S& s) { s.update_period = 7.3e-4; }), {"multiple", "0.00073", "0.0005"});
  expect_words(with([](S& s) { s.update_period = 0.0; }), {"update_period is 0 s"});
  expect_words(with([](S& s) { s.tick_period = 0.0; }), {"tick"});
  expect_words(with([&](S& s) { s.tick_period = nan; }), {"tick"});
  expect_words(with([](S& s) { s.tick_period = s.update_period = 1e-9; }),
               {"tick_period is 1e-09 s; wanted at least 1e-05 s"});
  expect_words(with([](S& s) { s.solver_delay = 0.02; }), {"solver_delay", "0.02", "0.01"});
  expect_words(with([](S& s) { s.solver_delay = -1e-3; }), {"solver_delay"});
  expect_words(with([](S& s) { s.problem.horizon[0].knots = 2; }), {"horizon", "0.02"});
  expect_words(with([](S& s) { s.problem.stages[1].step = 0.02; }), {"approach", "step", "0.02"});
  expect_words(with([](S& s) { s.problem.stages[2].impact = true; }), {"press", "impact"});
  expect_words(with([](S& s) { s.problem.stages.clear(); }), {"no stages"});
  expect_words(with([](S& s) { s.first_iterations = 0; }),
               {"first_iterations", "is 0; wanted at least 1"});
  expect_words(with([](S& s) { s.fallback.damping = -1.0; }), {"damping", "-1"});
  expect_words(with([](S& s) {
                 s.touches = {{s.tools[0].frame, WrenchSensor::None}};
                 s.model_error.kind = ModelErrorKind::Force;
               }),
               {"has no force sensor", "model_error.kind torque", "touches"});
  expect_words(with([&](S& s) { s.fallback.stiffness = nan; }), {"stiffness", "nan", "at least 0"});
  expect_words(with([](S& s) { s.fallback.saturation_fraction = 1.5; }),
               {"saturation_fraction", "1.5", "between 0 and 1"});
  const auto with_task = [&](auto&& change) {
    return with([&](S& s) {
      PressingTask pressing = *s.task.target<PressingTask>();
      change(pressing);
      s.task = pressing;
    });
  };
  using P = PressingTask;
  EXPECT_EQ(with_task([](P&) {}), "");
  expect_words(with_task([](P& p) { p.target = nullptr; }), {"target"});
  expect_words(with_task([](P& p) { p.touch.pop_back(); }), {"touch has 4 entries", "5 phases"});
  expect_words(with_task([](P& p) { p.limits.late_contact_travel = -0.1; }),
               {"late_contact_travel"});
  expect_words(with_task([&](P& p) { p.limits.late_contact_time = nan; }), {"late_contact_time"});
  expect_words(with_task([](P& p) { p.limits.release = -1.0; }), {"release"});
  expect_words(with_task([&](P& p) { p.limits.force = nan; }), {"limit", "force"});
  expect_words(with_task([](P& p) { p.limits.force_window = 2.0; }), {"force_window"});
  expect_words(with([](S& s) { s.limits.bad = -1.0; }), {"bad", "-1"});
  expect_words(with([](S& s) { s.limits.stale = 5e-4; }), {"stale", "tick"});
  expect_words(with([](S& s) { s.limits.failed_solves = 0; }), {"failed_solves", "0"});
  expect_words(with([](S& s) { s.model_error.bandwidth = 0.0; }), {"bandwidth"});
}

}  // namespace
}  // namespace burnish::test
