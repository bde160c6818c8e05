// What a fault says: of which joint or part, in which unit, and what led to it.
#include <gtest/gtest.h>

#include <cmath>

#include "mpc/descriptions.gen.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/torque_lag.hpp"
#include "mpc/watch.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;

TEST(FaultReport, Text_OfAJoint_NamesItAndItsUnit) {
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
                                     "a torque of 12 Nm off what was sent; allowed are 8 Nm: a "
                                     "first clause; a second one");
  // What a fault before said is forgotten.
  latch.reset();
  latch.raise(2.0, FaultKind::SpeedLimit, 1.2, 1.0);
  EXPECT_EQ(latch.report.text(), "speed limit at 2.0000 s: the tool: 1.2 m/s, allowed 1 m/s");
  latch.reset();
  EXPECT_EQ(latch.report.text(), "no fault");
}

TEST(FaultReport, Text_OfAJointThatSlides_IsInMetres) {
  Model model = toy_spec().problem.model;
  model.joints[3].kind = JointKind::Prismatic;
  FaultLatch latch(model);
  latch.raise(0.0, FaultKind::SpeedLimit, 0.5, 0.4, 3);
  expect_words(latch.report.text(), {"0.5 m/s, allowed 0.4 m/s"});
  latch.reset();
  latch.raise(0.0, FaultKind::MotorLost, 50.0, 40.0, 3);
  expect_words(latch.report.text(), {"50 N off what was sent"});
}

TEST(FaultReport, Text_OfEveryKind_IsOneSentenceWithBothNumbers) {
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

TEST(FaultLatch, Raise_InATick_AllocatesNothing) {
  const MpcSpec spec = toy_spec();
  FaultLatch latch(spec.problem.model);
  const AllocationGuard guard;
  latch.raise(1.5, FaultKind::SpeedLimit, 3.9, 3.6, 2);
  for (int i = 0; i < 20; ++i) latch.explain("a clause that is longer than a short string holds");
  if (AllocationGuard::unavailable() == nullptr) {
    EXPECT_EQ(guard.count(), 0);
  }
  EXPECT_LT(latch.report.cause.size(), 400U) << "what there is no room for is left out";
}

TEST(MeasurementGate, BadMeasurement_NamesWhatIsWrong) {
  MpcSpec spec = toy_spec();
  const std::string joint = spec.problem.model.v_name(3);
  const auto text_of = [&](const std::function<void(Measurement&)>& spoil) {
    MeasurementGate gate(spec);
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
               {"v has 3 entries, and 7 are wanted"});
  expect_words(text_of([=](Measurement& m) { m.tool_force_world.x() = nan; }),
               {"the force at the tool is not finite"});
  expect_words(text_of([=](Measurement& m) { m.time = nan; }), {"its time is not finite"});
  expect_words(text_of([](Measurement& m) { m.time = 0.0; }),
               {"stale measurement at ", "its time stands still at 0.0000 s"});
}

/// A controller's torques, which swing, and what comes of them.
class Motors : public ::testing::Test {
 protected:
  void SetUp() override {
    spec.limits.torque_gap = 0.25;
    effort = spec.problem.model.effort_limit;
    watch.emplace(spec);
    m = toy_measurement(spec);
  }
  /// Until this time, with torques that come so late, a joint's but a share of them.
  void run(double until, double delay, int joint = -1, double share = 1.0) {
    MeasurementGate gate(spec);
    FaultLatch latch(spec.problem.model);
    Status status = Status::Ok;
    for (int i = 0; m.time < until; ++i) {
      m.time = 1e-3 * i;
      const Eigen::VectorXd before = tau_at(m.time - 1e-3);
      m.tau = tau_at(m.time - 1e-3 - delay);
      if (joint >= 0) m.tau[joint] *= share;
      gate.take(m, latch, status);
      watch->look(gate, before);
    }
    watch->watch(m.time, latch);
    text = latch.report.text();
  }
  Eigen::VectorXd tau_at(double time) const {
    return effort * (0.3 + 0.6 * std::sin(2.0 * M_PI * 25.0 * time));
  }

  MpcSpec spec = toy_spec();
  Eigen::VectorXd effort;
  std::optional<MotorWatch> watch;
  Measurement m;
  std::string text;
};

TEST_F(Motors, TorquesThatComeLate_AreNoLostMotorAndTellTheirDelay) {
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

TEST_F(Motors, AMotorThatGivesNothing_IsFoundByItsJointThoughTorquesComeLate) {
  for (const double delay : {0.0, 5e-3}) {
    watch->reset();
    m.time = 0.0;
    run(0.3, delay, 2, 0.0);
    EXPECT_EQ(watch->lost(), 2) << delay;
    expect_words(text, {"motor lost", "joint '" + spec.problem.model.v_name(2) + "'", "were sent",
                        "came, means over 30 ms"});
  }
}

}  // namespace
}  // namespace burnish::test
