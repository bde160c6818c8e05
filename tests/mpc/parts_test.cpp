// Tests of the parts of an MpcController, each by itself: measurement gate, horizon and shift,
// policy, prediction, monitors, black box.
#include <gtest/gtest.h>

#include "burnish/mpc/mpc.hpp"
#include "estimate/contact_force_estimate.hpp"
#include "mpc/black_box.hpp"
#include "mpc/horizon.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/part_specs.hpp"
#include "mpc/policy.hpp"
#include "mpc/prediction.hpp"
#include "mpc/watch.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

TEST(MeasurementGate, InvalidMeasurements_AreBridgedInTime) {
  const MpcSpec spec = toy_spec();
  MeasurementGate gate(gate_spec(spec));
  FaultLatch latch;
  Status status = Status::Ok;
  Measurement m = toy_measurement(spec);
  m.time = 5.0;
  gate.take(m, latch, status);
  EXPECT_TRUE(gate.is_fresh() && gate.is_first());
  EXPECT_EQ(gate.dt(), 0.0);
  // A repeated time, values that are not finite, and wrong sizes.
  gate.take(m, latch, status);
  EXPECT_FALSE(gate.is_fresh());
  EXPECT_EQ(status, Status::NotEvaluated);
  EXPECT_DOUBLE_EQ(gate.now(), 5.001);
  for (const auto& spoil : std::vector<std::function<void(Measurement&)>>{
           [](Measurement& s) { s.tau[0] = std::nan(""); },
           [](Measurement& s) { s.q.conservativeResize(3); },
           [](Measurement& s) { s.time = std::nan(""); }}) {
    Measurement bad = m;
    bad.time = gate.now() + 1e-3;
    spoil(bad);
    gate.take(bad, latch, status);
    EXPECT_FALSE(gate.is_fresh());
    EXPECT_EQ(status, Status::NotFinite);
  }
  m.time = 5.006;
  m.q[0] += 0.1;
  gate.take(m, latch, status);
  EXPECT_TRUE(gate.is_fresh() && !gate.is_first());
  EXPECT_NEAR(gate.dt(), 6e-3, 1e-12);
  EXPECT_EQ(gate.last().q, m.q);
  EXPECT_FALSE(latch.is_set());
}

TEST(MeasurementGate, InvalidMeasurementsBeyondTheLimit_RaiseAFault) {
  const MpcSpec spec = toy_spec();
  const Measurement good = toy_measurement(spec);
  const auto ticks_until_fault = [&](FaultKind kind,
                                     const std::function<void(Measurement&)>& spoil) {
    MeasurementGate gate(gate_spec(spec));
    FaultLatch latch;
    Status status = Status::Ok;
    Measurement m = good;
    gate.take(m, latch, status);
    int ticks = 0;
    for (; ticks < 100 && !latch.is_set(); ++ticks) {
      m = good;
      m.time = 1e-3 * (ticks + 1);
      spoil(m);
      gate.take(m, latch, status);
    }
    EXPECT_EQ(latch.report.kind, kind);
    EXPECT_NEAR(latch.report.value, 1e-3 * ticks, 1e-12);
    // While the fault is latched, position and velocity suffice.
    m = good;
    m.time = 1.0;
    m.tau.setConstant(std::nan(""));
    gate.take(m, latch, status);
    EXPECT_TRUE(gate.is_fresh());
    return ticks;
  };
  EXPECT_EQ(ticks_until_fault(FaultKind::BadMeasurement, [](Measurement& m) { m.v[1] = NAN; }), 11);
  EXPECT_EQ(ticks_until_fault(FaultKind::StaleMeasurement, [](Measurement& m) { m.time = 0.0; }),
            21);
}

/// Toy task with one solved plan.
struct PlannedToy {
  explicit PlannedToy(MpcSpec mpc_spec = toy_spec())
      : spec(std::move(mpc_spec)),
        problem(spec.problem),
        solver(problem, {.max_iterations = 50}),
        schedule(spec.schedule) {
    horizon.place(0.0);
    const Eigen::VectorXd rest = problem.quasi_static(0, spec.problem.initial_state).control;
    horizon.guess_rest(spec.problem.initial_state, rest);
    solver.set_guess({horizon.guess_x().data(), horizon.guess_u().data()});
    solver.solve();
    horizon.solved_from(0.0);
  }
  MpcSpec spec;
  Problem problem;
  DdpSolver solver;
  Schedule schedule;
  Horizon horizon{problem, schedule};
};

TEST(Horizon, Stages_AreAtTheKnotsOfTheirTimes) {
  PlannedToy plan;
  EXPECT_EQ(plan.horizon.stage_at(0.049), 0);
  EXPECT_EQ(plan.horizon.stage_at(0.051), 1);
  plan.horizon.place(0.0);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(plan.problem.stage_of(k), k >= 5 ? 1 : 0) << k;
  plan.horizon.place(0.025);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(plan.problem.stage_of(k), k >= 3 ? 1 : 0) << k;
}

/// Toy task in contact with a surface that turns by 2 rad/s about x, or that is frozen at time
/// `stays_at`.
MpcSpec turning_surface(std::optional<double> frozen_at = {}) {
  MpcSpec spec = toy_spec();
  ContactSpec touch{.name = "touch", .tool = "tool", .directions = Directions::z()};
  touch.reference = {
      .origin = Anchor::Tool,
      .axes = Anchor::Base,
      .rotation_over_time = Signal::over_time(4, [](double t, Eigen::Ref<Eigen::VectorXd> xyzw) {
        xyzw << std::sin(t), 0.0, 0.0, std::cos(t);
      })};
  if (frozen_at) touch.reference = touch.reference.at(*frozen_at);
  spec.problem.contacts = {touch};
  for (Stage& stage : spec.problem.stages) stage.contacts = {"touch"};
  return spec;
}

TEST(Horizon, RotatingReference_TurnsWithTheScheduleTime) {
  const MpcSpec spec = turning_surface();
  Problem problem(spec.problem);
  Schedule schedule(spec.schedule);
  Horizon horizon(problem, schedule);
  const Eigen::VectorXd x = spec.problem.initial_state, u = Eigen::VectorXd::Constant(7, 3.0);
  for (const double now : {0.0, 0.025, 0.5}) {
    horizon.place(now);
    for (int k = 0; k < problem.knots(); ++k) {
      Problem frozen(turning_surface(now + 0.01 * k).problem);
      EXPECT_NEAR(problem.forces(k, x, u)[0], frozen.forces(0, x, u)[0], 1e-9)
          << k << " at " << now;
    }
  }
}

TEST(ContactForceEstimate, RotatingReference_TurnsTheForce) {
  ContactForceEstimate estimate(stage_contacts(turning_surface()), 1);
  MeasurementGate gate(gate_spec(turning_surface()));
  const Eigen::VectorXd q = turning_surface().problem.initial_state.head(7);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(7);
  ASSERT_EQ(gate.state().update(q, rest), Status::Ok);
  Eigen::Matrix3Xd first(3, 1), force(3, 1), wanted(3, 1);
  ASSERT_TRUE(estimate.forces_at(gate.state(), 0, 0.0, rest, first));
  for (const double time : {0.2, 0.6}) {
    ContactForceEstimate frozen(stage_contacts(turning_surface(time)), 1);
    MeasurementGate frozen_gate(gate_spec(turning_surface(time)));
    ASSERT_EQ(frozen_gate.state().update(q, rest), Status::Ok);
    ASSERT_TRUE(frozen.forces_at(frozen_gate.state(), 0, 0.0, rest, wanted));
    ASSERT_TRUE(estimate.forces_at(gate.state(), 0, time, rest, force));
    EXPECT_LT((force - wanted).norm(), 1e-9 * wanted.norm()) << time;
    EXPECT_GT((force - first).norm(), 0.1 * wanted.norm()) << time;
  }
}

TEST(ContactForceEstimate, ReferenceWithoutRotation_GivesNoForce) {
  MpcSpec spec = turning_surface();
  spec.problem.contacts[0].reference.rotation_over_time =
      Signal::over_time(4, [](double t, Eigen::Ref<Eigen::VectorXd> xyzw) {
        if (t > 2.0) throw Error("no more");
        xyzw << 0.0, 0.0, 0.0, t < 1.0 ? 1.0 : 0.0;
      });
  ContactForceEstimate estimate(stage_contacts(spec), 1);
  MeasurementGate gate(gate_spec(spec));
  const Eigen::VectorXd q = spec.problem.initial_state.head(7), rest = Eigen::VectorXd::Zero(7);
  ASSERT_EQ(gate.state().update(q, rest), Status::Ok);
  Eigen::Matrix3Xd force(3, 1);
  EXPECT_TRUE(estimate.forces_at(gate.state(), 0, 0.5, rest, force));
  for (const double time : {1.5, 2.5}) {
    EXPECT_FALSE(estimate.forces_at(gate.state(), 0, time, rest, force)) << time;
    EXPECT_TRUE(force.isZero(0.0));
  }
}

TEST(Horizon, LaterTime_ShiftsTheGuess) {
  PlannedToy plan;
  const MatrixView xs = plan.solver.xs(), us = plan.solver.us();
  Eigen::VectorXd x = xs.row(2);
  x[0] += 0.01;  // the measured state
  plan.horizon.guess_shifted(x, plan.solver, 0.02);
  EXPECT_EQ(plan.horizon.guess_x().row(0).transpose(), x);
  for (int k = 1; k <= 6; ++k)
    EXPECT_LT((plan.horizon.guess_x().row(k) - xs.row(std::min(k + 2, 6))).norm(), 1e-12) << k;
  for (int k = 0; k < 6; ++k)
    EXPECT_EQ(plan.horizon.guess_u().row(k), us.row(std::min(k + 2, 5))) << k;
  // A time half way between two knots gives the mean of both states.
  plan.horizon.guess_shifted(x, plan.solver, 0.015);
  EXPECT_LT((plan.horizon.guess_x().row(3) - 0.5 * (xs.row(4) + xs.row(5))).norm(), 1e-12);
}

/// Toy task, planned 0.3 s ahead with steps of 10, 15, 22.5 ms and so on.
MpcSpec growing_spec() {
  MpcSpec spec = toy_spec();
  spec.problem.horizon = {
      {.stage = "rest", .knots = 7, .step = 0.01, .duration = 0.01 * (std::pow(1.5, 7) - 1) / 0.5}};
  return spec;
}

TEST(UnevenHorizon, PhaseChange_StartsAKnot) {
  PlannedToy plan(growing_spec());
  // Knots lie at 0, 10, 25, 47.5, 81.25 ms and so on; stage 'wave' begins at 50 ms.
  for (const double now : {0.0, 0.003, 0.011, 0.024, 0.038, 0.0431}) {
    SCOPED_TRACE(now);
    plan.horizon.place(now);
    int waving = 0;
    while (plan.problem.stage_of(waving) == 0) ++waving;
    EXPECT_DOUBLE_EQ(plan.problem.time_of(waving), 0.05);
    double time = now;
    for (int k = 0; k < plan.problem.knots(); ++k) {
      EXPECT_NEAR(plan.problem.time_of(k), time, 1e-12);
      EXPECT_GT(plan.problem.step_of(k), 0.0);
      EXPECT_NEAR(plan.problem.step_of(k), plan.horizon.times().step(k), 1e-15);
      time += plan.problem.step_of(k);
    }
    EXPECT_NEAR(plan.problem.time_of(7), now + growing_spec().problem.horizon[0].duration, 1e-12);
  }
  // Nearer than half of the first step, the knot belongs to the phase in which it begins.
  plan.horizon.place(0.047);
  EXPECT_EQ(plan.problem.stage_of(0), 0);
  EXPECT_EQ(plan.problem.stage_of(1), 1);
  EXPECT_NEAR(plan.problem.time_of(1), 0.057, 1e-12);
}

TEST(UnevenHorizon, LaterTime_InterpolatesStatesAndAveragesControls) {
  PlannedToy plan(growing_spec());
  plan.horizon.place(0.0);
  plan.solver.solve();
  plan.horizon.solved_from(0.0);
  const KnotTimes before = plan.horizon.times();
  const MatrixView xs = plan.solver.xs(), us = plan.solver.us();
  for (const double later : {0.0, 0.004, 0.013}) {
    SCOPED_TRACE(later);
    plan.horizon.place(later);
    const KnotTimes& now = plan.horizon.times();
    plan.horizon.guess_shifted(xs.row(0), plan.solver, later);
    for (int k = 0; k <= 7; ++k) {
      const double at = before.place(now.after(k) + later);
      const int i = std::min(static_cast<int>(at), 6);
      const Eigen::RowVectorXd wanted = xs.row(i) + (at - i) * (xs.row(i + 1) - xs.row(i));
      if (k > 0) {
        EXPECT_LT((plan.horizon.guess_x().row(k) - wanted).norm(), 1e-12) << k;
      }
      if (k == 7) break;
      // Mean control over the knot, from a thousand samples.
      Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(us.cols());
      for (int s = 0; s < 1000; ++s) {
        const double there = now.after(k) + later + (s + 0.5) / 1000.0 * now.step(k);
        mean += 1e-3 * us.row(std::min(static_cast<int>(before.place(there)), 6));
      }
      EXPECT_LT((plan.horizon.guess_u().row(k) - mean).norm(),
                2e-3 * us.cwiseAbs().maxCoeff() + 1e-12)
          << k;
    }
  }
  plan.horizon.place(0.0);
  plan.horizon.guess_shifted(xs.row(0), plan.solver, 0.0);
  EXPECT_EQ(plan.horizon.guess_u(), RowMatrix(us)) << "a shift by zero must change nothing";
}

TEST(UnevenHorizon, Policy_FollowsTheKnotTimes) {
  PlannedToy plan(growing_spec());
  plan.horizon.place(0.0);
  plan.solver.solve();
  Policy policy(policy_spec(plan.spec), plan.problem);
  policy.load(plan.solver, 2.0, plan.horizon.times());
  policy.take_over(2.0);
  Eigen::VectorXd u(7);
  const KnotTimes& times = plan.horizon.times();
  for (int k = 0; k < 3; ++k) {
    const double middle = 0.5 * (times.after(k) + times.after(k + 1));
    policy.control(2.0 + middle, plan.spec.problem.initial_state, u);
    EXPECT_EQ(policy.feedback().gain, plan.solver.gain(k)) << k;
    const Eigen::VectorXd wanted =
        0.5 * (plan.solver.xs().row(k) + plan.solver.xs().row(k + 1)).transpose();
    EXPECT_LT((policy.feedback().state - wanted).norm(), 1e-12) << k;
  }
}

TEST(UnevenHorizon, Tick_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  MpcSpec spec = growing_spec();
  spec.solver_delay = 3e-3;
  spec.problem.stages[1].constraints = {
      {.residual = residual::JointVelocity{}, .upper = Eigen::VectorXd::Constant(1, 0.2)}};
  MpcController mpc(spec);
  Measurement m = toy_measurement(spec);
  for (int i = 0; i < 100; ++i) {
    m.time = 1e-3 * i;
    const AllocationGuard guard;
    const Command& command = mpc.tick(m);
    EXPECT_EQ(guard.count(), 0) << i;
    EXPECT_EQ(command.status, Status::Ok);
  }
  EXPECT_EQ(mpc.fault().kind, FaultKind::None);
  EXPECT_NEAR(mpc.problem().time_of(7) - mpc.problem().time_of(0), spec.problem.horizon[0].duration,
              1e-12);
}

TEST(UnevenHorizon, StepsThatDifferBetweenStages_AreRefused) {
  MpcSpec spec = toy_spec();
  spec.problem.stages[1].step = 0.02;
  testing::expect_words(testing::refusal([&] { MpcController{spec}; }),
                        {"stage 'wave'", "0.02", "segments with their own steps"});
  spec.problem.horizon[0].step = 0.01;
  EXPECT_NO_THROW(MpcController{spec});
}

TEST(Policy, LoadedPlan_ActsFromItsStartTime) {
  PlannedToy plan;
  Policy policy(policy_spec(plan.spec), plan.problem);
  const Eigen::VectorXd x = plan.spec.problem.initial_state;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(7);
  policy.load(plan.solver, 0.01, plan.horizon.times());
  policy.take_over(0.009);
  policy.control(0.009, x, u);
  EXPECT_TRUE(u.isZero(0.0)) << "the plan starts later";
  policy.take_over(0.01);
  policy.control(0.01, x, u);
  EXPECT_LT((u - plan.solver.us().row(0).transpose()).norm(), 1e-12);
  EXPECT_EQ(policy.feedback().gain, plan.solver.gain(0));
  // The control stays within the effort limits for any state.
  Eigen::VectorXd far = x;
  far.head(7).array() += 100.0;
  policy.control(0.01, far, u);
  const Eigen::ArrayXd limit = plan.spec.problem.model.effort_limit.array();
  EXPECT_TRUE((u.array().abs() <= limit).all() && (u.array().abs() == limit).any());
  policy.reset();
  policy.take_over(1.0);
  EXPECT_EQ(policy.feedback().gain, plan.solver.gain(0)) << "an empty plan changes nothing";
}

TEST(Prediction, Advance_FollowsThePolicy) {
  PlannedToy plan;
  Policy policy(policy_spec(plan.spec), plan.problem);
  policy.load(plan.solver, 0.0, plan.horizon.times());
  policy.take_over(0.0);
  Prediction prediction(plan.problem);
  Eigen::VectorXd x = plan.spec.problem.initial_state;
  ASSERT_TRUE(prediction.advance(plan.problem, plan.horizon, policy, {.duration = 0.03}, x));
  // The prediction integrates positions with second order, plans with first order. They differ by
  // half a step of the acceleration.
  const Eigen::VectorXd planned = plan.solver.xs().row(3);
  EXPECT_LT((x - planned).tail(7).norm(), 0.02 * planned.tail(7).norm());
  EXPECT_LT((x - planned).head(7).norm(), 0.01 * planned.tail(7).norm());
  // If the prediction fails, the state stays unchanged.
  Eigen::VectorXd broken = Eigen::VectorXd::Constant(14, std::nan(""));
  EXPECT_FALSE(prediction.advance(plan.problem, plan.horizon, policy, {.duration = 0.03}, broken));
  EXPECT_TRUE(broken.array().isNaN().all());
}

TEST(JointWatch, SpeedOrPositionBeyondLimits_NamesTheJoint) {
  MpcSpec spec = toy_spec();
  const Model& model = spec.problem.model;
  const auto fault_of = [&](const std::function<void(Measurement&)>& change) {
    MeasurementGate gate(gate_spec(spec));
    FaultLatch latch;
    Status status = Status::Ok;
    Measurement m = toy_measurement(spec);
    change(m);
    gate.take(m, latch, status);
    watch_joints(model, spec.limits, gate, latch);
    return latch.report;
  };
  EXPECT_EQ(fault_of([](Measurement&) {}).kind, FaultKind::None);
  const FaultReport fast =
      fault_of([&](Measurement& m) { m.v[2] = -1.21 * model.velocity_limit[2]; });
  EXPECT_EQ(fast.kind, FaultKind::SpeedLimit);
  EXPECT_EQ(fast.joint, 2);
  const FaultReport near = fault_of([&](Measurement& m) { m.q[3] = model.q_upper[3] + 0.04; });
  EXPECT_EQ(near.kind, FaultKind::None);
  const FaultReport out = fault_of([&](Measurement& m) { m.q[3] = model.q_lower[3] - 0.06; });
  EXPECT_EQ(out.kind, FaultKind::OutOfRange);
  EXPECT_EQ(out.joint, 3);
  EXPECT_EQ(out.limit, model.q_lower[3]);
}

TEST(BaseWatch, BaseLostForTooLong_IsAFault) {
  MpcSpec spec = toy_spec();
  spec.limits.base_lost = 0.1;
  for (const double lost : {0.0, 0.1, 0.11}) {
    MeasurementGate gate(gate_spec(spec));
    FaultLatch latch;
    Status status = Status::Ok;
    Measurement m = toy_measurement(spec);
    m.base_lost_for = lost;
    gate.take(m, latch, status);
    watch_base(spec.limits, gate, latch);
    EXPECT_EQ(latch.is_set(), lost > 0.1);
    if (!latch.is_set()) continue;
    EXPECT_EQ(latch.report.kind, FaultKind::BaseLost);
    EXPECT_NE(latch.report.text().find("no estimate of the base for 0.11 s"), std::string::npos);
  }
}

TEST(PlanWatch, ConsecutiveFailedOrLateSolves_AreAFault) {
  PlanWatch watch(SafetyLimits{.failed_solves = 3, .deadline = 0.1, .late_solves = 2});
  FaultLatch latch;
  EXPECT_FALSE(watch.judge(0.0, true, true, 100.0, latch)) << "the first solve may be late";
  for (const bool usable : {false, false, true, false, false})
    watch.judge(0.0, usable, false, 0.0, latch);
  EXPECT_FALSE(latch.is_set());
  watch.judge(1.0, false, false, 0.0, latch);
  EXPECT_EQ(latch.report.kind, FaultKind::SolverFailed);
  EXPECT_EQ(latch.report.value, 3.0);
  latch.reset();
  watch.reset();
  EXPECT_TRUE(watch.judge(0.0, true, false, 0.2, latch));
  EXPECT_FALSE(latch.is_set());
  watch.judge(2.0, true, false, 0.2, latch);
  EXPECT_EQ(latch.report.kind, FaultKind::SolverLate);
  EXPECT_EQ(latch.report.time, 2.0);
  latch.reset();
  watch.reset();
  watch.judge(0.0, false, true, 0.0, latch);
  EXPECT_EQ(latch.report.kind, FaultKind::SolverFailed) << "a failed first solve is a fault";
}

TEST(BlackBox, Fault_FreezesTheLastSecond) {
  const MpcSpec spec = toy_spec();
  FaultLatch latch;
  BlackBox box(spec.problem.model, spec.tools, spec.tick_period, latch);
  Command command{Eigen::VectorXd::Constant(7, 2.0)};
  Measurement m = toy_measurement(spec);
  MeasurementGate gate(gate_spec(spec));
  Status status = Status::Ok;
  for (int tick = 0; tick < 1500; ++tick) {
    m.time = 1e-3 * tick;
    gate.take(m, latch, status);
    if (tick == 1499) latch.raise(m.time, FaultKind::Watched, 2.0, 1.0);
    box.record(gate, 0.5, command, latch);
  }
  const Trace& trace = latch.report.last_second;
  ASSERT_EQ(trace.rows(), 1000);
  EXPECT_DOUBLE_EQ(trace.column("time")[0], 0.5);
  EXPECT_DOUBLE_EQ(trace.column("time")[999], 1.499);
  EXPECT_EQ(trace.column("fault")[999], static_cast<double>(FaultKind::Watched));
  EXPECT_EQ(trace.column("fault")[998], 0.0);
  EXPECT_EQ(trace.column("q_" + spec.problem.model.q_name(0))[3], m.q[0]);
  box.record(gate, 0.5, command, latch);
  EXPECT_EQ(trace.rows(), 1000);
}

}  // namespace
}  // namespace burnish::test
