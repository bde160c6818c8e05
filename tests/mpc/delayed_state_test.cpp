// Tests of compensated delays: the torque that has acted, and the state in which the next torque
// will act.
#include "mpc/delayed_state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "burnish/mpc/mpc.hpp"
#include "mpc/part_specs.hpp"
#include "support/allocation_guard.hpp"
#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

using testing::expect_words;
using testing::refusal;

/// Arm of the toy task in free motion, which moves exactly as its model predicts.
class DelayCompensation : public ::testing::Test {
 protected:
  void make(double command, double measurement) {
    spec.command_delay = command;
    spec.measurement_delay = measurement;
    spec.limits.stale = 0.02;
    gate.emplace(gate_spec(spec));
    ahead.emplace(spec.problem, loop_times(spec), spec.limits.stale, 1);
    dynamics.emplace(stage_contacts(spec), 1);
  }
  Eigen::VectorXd tau_at(int tick) const {
    const Eigen::VectorXd rest = Eigen::VectorXd::Constant(7, 1.0);
    return rest + Eigen::VectorXd::LinSpaced(7, 4.0, 0.5) * std::sin(0.1 * tick);
  }
  /// Simulates the states at ticks 0, 1, ...; in tick i the torque of tick i - `delay` acts.
  void simulate(int count, int delay) {
    const int fine = 20;
    ContactDynamics arm(spec.problem.model);
    Eigen::VectorXd q = arm7::ready(), v = Eigen::VectorXd::Constant(7, 0.2);
    for (int i = 0; i <= count; ++i) {
      qs.push_back(q);
      vs.push_back(v);
      const double h = spec.tick_period / fine;
      for (int k = 0; k < fine; ++k) {
        ASSERT_EQ(arm.forward(q, v, tau_at(std::max(0, i - delay))), Status::Ok);
        q += h * v + 0.5 * h * h * arm.a();
        v += h * arm.a();
      }
    }
  }
  /// Feeds all measurements up to tick `now` and returns the predicted state. Measurements after
  /// tick `until` are invalid.
  Eigen::VectorXd predicted(int now, int measurement_ticks, int until) {
    Status status = Status::Ok;
    FaultLatch latch;
    for (int i = 0; i <= now; ++i) {
      Measurement m = toy_measurement(spec);
      m.time = i * spec.tick_period;
      const auto then = static_cast<std::size_t>(std::max(0, i - measurement_ticks));
      m.q = qs[then];
      m.v = vs[then];
      if (i > until) m.q[0] = std::nan("");
      gate->take(m, latch, status);
      if (i < now) ahead->send(tau_at(i), none);
    }
    Eigen::VectorXd x(14);
    x << gate->last().q, gate->last().v;
    const AllocationGuard guard;
    EXPECT_TRUE(ahead->predict(
        *dynamics, *gate,
        {.stage = 0,
         .schedule_time = 0.0,
         .torque_error = none,
         .tools = std::array{DelayedState::PredictionTool{2.0, false, Eigen::Vector3d::UnitZ()}}},
        x));
    if (AllocationGuard::unavailable() == nullptr) {
      EXPECT_EQ(guard.count(), 0);
    }
    return x;
  }
  void expect_state(const Eigen::VectorXd& x, int tick) {
    const auto at = static_cast<std::size_t>(tick);
    EXPECT_LT((x.head(7) - qs[at]).cwiseAbs().maxCoeff(), 2e-5);
    EXPECT_LT((x.tail(7) - vs[at]).cwiseAbs().maxCoeff(), 5e-3);
    // Ensures that the measured state differs from the predicted state.
    EXPECT_GT((gate->last().q - qs[at]).cwiseAbs().maxCoeff(), 3e-4);
  }

  MpcSpec spec = toy_spec();
  std::optional<MeasurementGate> gate;
  std::optional<DelayedState> ahead;
  std::optional<ContactForceEstimate> dynamics;
  std::vector<Eigen::VectorXd> qs, vs;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(7);
};

TEST_F(DelayCompensation, BothDelays_PredictTheStateInWhichTheCommandActs) {
  make(3e-3, 2e-3);
  EXPECT_EQ(ahead->ticks(), 5);
  EXPECT_NEAR(ahead->lead(), 3e-3, 1e-12);
  simulate(60, 3);
  expect_state(predicted(50, 2, 50), 53);
  EXPECT_EQ(ahead->acted(), tau_at(44))
      << "torque that acted when the measurement of tick 48 was taken";
}

TEST_F(DelayCompensation, InvalidMeasurements_PredictFromTheLastValidOne) {
  make(3e-3, 0.0);
  simulate(60, 3);
  expect_state(predicted(50, 0, 46), 53);
}

TEST_F(DelayCompensation, NoDelay_ReturnsTheMeasuredState) {
  make(0.0, 0.0);
  simulate(10, 0);
  const Eigen::VectorXd x = predicted(8, 0, 8);
  EXPECT_EQ(x.head(7), qs[8]);
  EXPECT_EQ(x.tail(7), vs[8]);
  EXPECT_EQ(ahead->acted(), tau_at(7));
  EXPECT_EQ(ahead->lead(), 0.0);
}

TEST(MpcSpecDelays, DelayOutOfRange_IsRefused) {
  MpcSpec spec = toy_spec();
  spec.command_delay = -1e-3;
  expect_words(refusal([&] { MpcController{spec}; }), {"command_delay is -0.001 s", "0.1 s"});
  spec.command_delay = 0.0;
  spec.measurement_delay = 0.2;
  expect_words(refusal([&] { MpcController{spec}; }), {"measurement_delay is 0.2 s"});
}

}  // namespace
}  // namespace burnish::test
