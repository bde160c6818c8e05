// Tests of fault reports: the joint or part they name, the unit, and the cause.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mpc/descriptions.gen.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/part_specs.hpp"
#include "mpc/torque_lag.hpp"
#include "mpc/watch.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

TEST(FaultReport, FaultOfAJoint_NamesTheJointAndItsUnit) {
  const MpcSpec spec = toy_spec();
  const Model& model = spec.problem.model;
  const std::string joint = "joint '" + model.v_name(2) + "': ";
  FaultLatch latch(model);
  latch.raise(1.5, FaultKind::SpeedLimit, 3.9, 3.6, 2);
  EXPECT_EQ(latch.report.text(),
            "speed limit at 1.5000 s: " + joint + "3.9 rad/s, allowed 3.6 rad/s");
  latch.reset();
  latch.raise(1.5, FaultKind::OutOfRange, -2.1, -2.0, 2);
  expect_words(latch.report.text(), {joint + "position -2.1 rad; the limit is -2 rad"});
  latch.reset();
  latch.raise(1.5, FaultKind::MotorLost, 12.0, 8.0, 2);
  latch.explain("a first clause");
  latch.explain("");
  latch.explain("a second one");
  EXPECT_EQ(latch.report.text(), "motor lost at 1.5000 s: " + joint +
                                     "the torque differs by 12 Nm from the command; "
                                     "allowed are 8 Nm: a first clause; a second one");
  // The cause of an earlier fault does not appear again.
  latch.reset();
  latch.raise(2.0, FaultKind::SpeedLimit, 1.2, 1.0);
  EXPECT_EQ(latch.report.text(), "speed limit at 2.0000 s: the tool: 1.2 m/s, allowed 1 m/s");
  latch.reset();
  EXPECT_EQ(latch.report.text(), "no fault");
}

TEST(FaultReport, FaultOfAPrismaticJoint_IsInMetres) {
  Model model = toy_spec().problem.model;
  model.joints[3].kind = JointKind::Prismatic;
  FaultLatch latch(model);
  latch.raise(0.0, FaultKind::SpeedLimit, 0.5, 0.4, 3);
  expect_words(latch.report.text(), {"0.5 m/s, allowed 0.4 m/s"});
  latch.reset();
  latch.raise(0.0, FaultKind::MotorLost, 50.0, 40.0, 3);
  expect_words(latch.report.text(), {"differs by 50 N from the command"});
}

TEST(FaultReport, EveryKind_IsOneSentenceWithValueAndLimit) {
  for (int kind = 1; kind <= static_cast<int>(FaultKind::BaseLost); ++kind) {
    FaultReport report;
    report.kind = static_cast<FaultKind>(kind);
    report.time = 0.5;
    report.value = 7.0;
    report.limit = 5.0;
    report.quantity = "hand 'left'";
    const std::string text = report.text();
    expect_words(text, {std::string(name_of(report.kind)) + " at 0.5000 s: ", "7", "5"});
    EXPECT_EQ(text.find('{'), std::string::npos) << text;
    EXPECT_EQ(text.find('%'), std::string::npos) << text;
  }
}

TEST(FaultKind, EveryValue_HasItsWord) {
  const std::vector<Words::Word>& words = words_of(FaultKind{}).words;
  ASSERT_EQ(words.size(), static_cast<std::size_t>(FaultKind::BaseLost) + 1);
  EXPECT_EQ(words[static_cast<std::size_t>(FaultKind::SupportSlipped)].word, "support_slipped");
  EXPECT_EQ(words[static_cast<std::size_t>(FaultKind::MotorLost)].word, "motor_lost");
  EXPECT_EQ(words.back().word, "base_lost");
}

TEST(FaultLatch, Raise_AllocatesNothing) {
  const MpcSpec spec = toy_spec();
  FaultLatch latch(spec.problem.model);
  const AllocationGuard guard;
  latch.raise(1.5, FaultKind::SpeedLimit, 3.9, 3.6, 2);
  for (int i = 0; i < 20; ++i) latch.explain("a clause that is longer than a short string holds");
  if (AllocationGuard::unavailable() == nullptr) {
    EXPECT_EQ(guard.count(), 0);
  }
  EXPECT_LT(latch.report.cause.size(), 400U) << "clauses that do not fit must be left out";
}

TEST(MeasurementGate, InvalidMeasurement_IsNamedInTheReport) {
  MpcSpec spec = toy_spec();
  const std::string joint = spec.problem.model.v_name(3);
  const auto text_of = [&](const std::function<void(Measurement&)>& spoil) {
    MeasurementGate gate(gate_spec(spec));
    FaultLatch latch(spec.problem.model);
    Status status = Status::Ok;
    Measurement m = toy_measurement(spec);
    gate.take(m, latch, status);
    for (int i = 0; i < 40 && !latch.is_set(); ++i) {
      m.time += 1e-3;
      Measurement bad = m;
      spoil(bad);
      gate.take(bad, latch, status);
    }
    return latch.report.text();
  };
  const double nan = std::nan("");
  expect_words(text_of([=](Measurement& m) { m.q[3] = nan; }),
               {"bad measurement at ", "q of '" + joint + "' is not finite"});
  expect_words(text_of([=](Measurement& m) { m.v[3] = nan; }), {"v of '" + joint + "'"});
  expect_words(text_of([=](Measurement& m) { m.tau[3] = nan; }), {"tau of '" + joint + "'"});
  expect_words(text_of([](Measurement& m) { m.v.conservativeResize(3); }),
               {"v has 3 entries; wanted 7"});
  expect_words(text_of([=](Measurement& m) { m.wrenches(0, 0) = nan; }),
               {"the force on the tool 'tool' is not finite", "sensor none", "MpcSpec.touches"});
  expect_words(text_of([](Measurement& m) { m.wrenches.resize(6, 0); }),
               {"wrenches has 0 columns; wanted 1, one per entry of the controller's touches"});
  expect_words(text_of([=](Measurement& m) { m.time = nan; }),
               {"measurement's time is not finite"});
  expect_words(text_of([](Measurement& m) { m.time = 0.0; }),
               {"stale measurement at ", "measurement's time stays at 0.0000 s"});
}

/// Motors with oscillating torque commands and delayed torque measurements.
class MotorMonitor : public ::testing::Test {
 protected:
  void SetUp() override {
    spec.limits.torque_gap = 0.25;
    effort = spec.problem.model.effort_limit;
    watch.emplace(spec.problem.model, spec.limits, spec.tick_period);
    m = toy_measurement(spec);
  }
  /// Runs until this time with torques that arrive after `delay`; `joint` yields only a fraction of
  /// its torque.
  void run(double until, double delay, int joint = -1, double fraction = 1.0) {
    MeasurementGate gate(gate_spec(spec));
    FaultLatch latch(spec.problem.model);
    Status status = Status::Ok;
    for (int i = 0; m.time < until; ++i) {
      m.time = 1e-3 * i;
      const Eigen::VectorXd before = tau_at(m.time - 1e-3);
      m.tau = tau_at(m.time - 1e-3 - delay);
      if (joint >= 0) m.tau[joint] *= fraction;
      gate.take(m, latch, status);
      watch->look(gate, before);
    }
    watch->watch(m.time, latch);
    text = latch.report.text();
  }
  MpcSpec spec = toy_spec();
  Eigen::VectorXd effort;
  /// Commanded torque at a time [s].
  std::function<Eigen::VectorXd(double)> tau_at = [this](double time) -> Eigen::VectorXd {
    return effort * (0.3 + 0.6 * std::sin(2.0 * M_PI * 25.0 * time));
  };
  std::optional<MotorWatch> watch;
  Measurement m;
  std::string text;
};

TEST_F(MotorMonitor, DelayedTorques_AreNoFaultAndYieldTheDelay) {
  for (const double delay : {2e-3, 5e-3, 9e-3, 15e-3}) {
    watch->reset();
    m.time = 0.0;
    run(0.3, delay);
    EXPECT_EQ(watch->lost(), -1) << delay;
    EXPECT_NEAR(watch->lag(), delay, 1e-9);
  }
  watch->reset();
  m.time = 0.0;
  run(0.3, 0.0);
  EXPECT_EQ(watch->lag(), 0.0);
}

TEST_F(MotorMonitor, MotorWithoutTorque_IsFoundByJointDespiteDelay) {
  for (const double delay : {0.0, 5e-3}) {
    watch->reset();
    m.time = 0.0;
    run(0.3, delay, 2, 0.0);
    EXPECT_EQ(watch->lost(), 2) << delay;
    expect_words(text, {"motor lost", "joint '" + spec.problem.model.v_name(2) + "'", "commanded",
                        "as means over 30 ms"});
  }
}

TEST_F(MotorMonitor, SmallCommand_FindsADeadMotorLaterThanALargeOneAndNoWeakMotor) {
  tau_at = [this](double) -> Eigen::VectorXd { return 0.12 * effort; };
  run(0.1, 0.0, 2, 0.0);
  EXPECT_EQ(watch->lost(), -1) << "below 0.6 of the limit, found at once";
  run(0.4, 0.0, 2, 0.0);
  EXPECT_EQ(watch->lost(), 2);
  watch->reset();
  m.time = 0.0;
  run(0.4, 0.0, 2, 0.25);
  EXPECT_EQ(watch->lost(), -1);
}

TEST_F(MotorMonitor, CommandAfterRest_IsNoFault) {
  tau_at = [this](double time) -> Eigen::VectorXd { return (time > 0.5 ? 0.3 : 0.0) * effort; };
  run(1.0, 15e-3);
  EXPECT_EQ(watch->lost(), -1);
}

}  // namespace
}  // namespace burnish::test
