// Tests of stability margins of the linear loop on the toy arm. tests/tasks/margins_test.cpp
// compares margins with simulations.
#include "burnish/mpc/margins.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

LoopChain filtered_chain() {
  return {.command_delay = 1e-3, .velocity_cutoff = 300.0, .force_cutoff = 300.0};
}

MpcSpec observed_spec() {
  MpcSpec spec = toy_spec();
  spec.update_period = 1e-3;
  spec.model_error = {.kind = ModelErrorKind::Torque, .bandwidth = 60.0, .transient_scale = 1.0};
  return spec;
}

double delay_margin(const MpcSpec& spec, const LoopChain& chain) {
  return LoopAnalysis(spec, chain, 0).delay_margin(spec.model_error).delay;
}

TEST(Margins, LinearQuadraticLoop_IsStableAtHalfAndTwiceTheGain) {
  MpcSpec spec = toy_spec();
  spec.update_period = spec.tick_period;
  const LoopAnalysis loop(spec, {.difference_velocity = false}, 0);
  EXPECT_LT(loop.growth(1.0, 0.0), 1.0);
  EXPECT_TRUE(loop.tolerates(spec.model_error, 0.0, 2.0));
  const LoopMargins margins = loop.margins(spec.model_error);
  ASSERT_EQ(margins.gains.size(), 7U);
  EXPECT_EQ(margins.gains[2].joint, spec.problem.model.v_name(2));
  for (const GainRange& range : margins.gains) {
    EXPECT_LE(range.below, 0.5) << range.joint;
    EXPECT_GE(range.above, 2.0) << range.joint;
  }
}

TEST(Margins, GrowthAtTheDelayMargin_CrossesItsLimit) {
  MpcSpec spec = observed_spec();
  spec.model_error.bandwidth = 90.0;
  const LoopAnalysis loop(spec, filtered_chain(), 0);
  const double delay = loop.delay_margin(spec.model_error).delay;
  ASSERT_GT(delay, 1e-3);
  ASSERT_LT(delay, 0.95 * LoopAnalysis::max_delay);
  EXPECT_LT(loop.growth(90.0, delay - 6e-4), 8.0);
  EXPECT_GT(loop.growth(90.0, delay + 6e-4), 8.0);
  EXPECT_TRUE(loop.tolerates(spec.model_error, delay - 6e-4, 1.1));
  EXPECT_FALSE(loop.tolerates(spec.model_error, delay + 6e-4, 1.1));
}

TEST(Margins, GainAboveItsRange_MakesTheLoopUnstable) {
  MpcSpec spec = observed_spec();
  const LoopMargins margins = LoopAnalysis(spec, filtered_chain(), 0).margins(spec.model_error);
  double min_gain = LoopAnalysis::largest_gain;
  for (const GainRange& range : margins.gains) min_gain = std::min(min_gain, range.above);
  ASSERT_GT(min_gain, 1.5);
  ASSERT_LT(min_gain, LoopAnalysis::largest_gain);
  const LoopAnalysis loop(spec, filtered_chain(), 0);
  EXPECT_TRUE(loop.tolerates(spec.model_error, 0.0, 0.9 * min_gain));
  EXPECT_FALSE(loop.tolerates(spec.model_error, 0.0, 1.1 * min_gain));
}

TEST(Margins, MoreLagInTheLoop_ReducesTheDelayMargin) {
  const MpcSpec spec = observed_spec();
  const double usual = delay_margin(spec, filtered_chain());
  LoopChain slow_motors = filtered_chain(), slow_filter = filtered_chain();
  slow_motors.torque_cutoff = 600.0;
  slow_filter.velocity_cutoff = 150.0;
  EXPECT_LT(delay_margin(spec, slow_motors), usual - 5e-4);
  EXPECT_LT(delay_margin(spec, slow_filter), usual - 5e-4);
  LoopChain late = filtered_chain();
  late.command_delay += 1e-3;
  EXPECT_NEAR(delay_margin(spec, late), usual - 1e-3, 2e-4);
}

TEST(Margins, ObserverWithTheLag_HasALargerDelayMargin) {
  MpcSpec spec = observed_spec();
  spec.model_error.bandwidth = 120.0;
  const double usual = delay_margin(spec, filtered_chain());
  spec.model_error.lag = 4e-3;
  EXPECT_GT(delay_margin(spec, filtered_chain()), usual + 1e-3);
}

TEST(Margins, TransientScale_ReducesTheDelayMargin) {
  MpcSpec spec = observed_spec();
  const double usual = delay_margin(spec, filtered_chain());
  spec.model_error.transient_scale = 3.0;
  const LoopMargins with_transient =
      LoopAnalysis(spec, filtered_chain(), 0).delay_margin(spec.model_error);
  EXPECT_LT(with_transient.delay, usual - 1e-3);
  EXPECT_EQ(with_transient.bandwidth, 120.0);
}

TEST(Margins, TorqueModelOfTheMotors_IsStableUntilCommandsAreLate) {
  MpcSpec spec = toy_spec();
  spec.update_period = spec.tick_period;
  spec.problem.torque_model = TorqueModel{60.0};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(spec.problem.initial_state.size() + 7);
  x.head(14) = spec.problem.initial_state;
  spec.problem.initial_state = x;
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(21, 10.0);
  weights.tail(7).setConstant(1e-6);  // weights of torques
  for (Stage& stage : spec.problem.stages)
    stage.costs[0] = {.residual = residual::State{x}, .weights = weights};
  LoopChain chain{.torque_cutoff = 60.0, .difference_velocity = false};
  EXPECT_LT(LoopAnalysis(spec, chain, 0).growth(1.0, 0.0), 1.0);
  chain.command_delay = 20e-3;
  EXPECT_GT(LoopAnalysis(spec, chain, 0).growth(1.0, 0.0), 5.0);
}

TEST(Margins, FloatingBase_IsRefused) {
  MpcSpec spec = toy_spec();
  spec.problem.model = arm7::model(Base::FreeFlyer);
  testing::expect_words(testing::refusal([&] { LoopAnalysis(spec, {}, 0); }),
                        {"margins", "base", "floats"});
}

TEST(Margins, TaskWithoutContacts_HasNoPressingPhase) {
  EXPECT_EQ(free_phase(toy_spec()), 0);
  EXPECT_EQ(pressing_phase(toy_spec()), -1);
}

}  // namespace
}  // namespace burnish::test
