// Tests of the check of a plan's steps before a controller runs.
#include "burnish/mpc/plan_check.hpp"

#include <gtest/gtest.h>

#include "support/refusal.hpp"
#include "support/toy_task.hpp"

namespace burnish::test {
namespace {

MpcSpec with_step(double step, int knots) {
  MpcSpec spec = toy_spec();
  for (Stage& stage : spec.problem.stages) stage.step = step;
  spec.problem.horizon = {{"rest", knots}};
  return spec;
}

TEST(PlanSteps, ShortSteps_GiveNoComplaint) {
  EXPECT_EQ(step_complaints(with_step(0.01, 6)), std::vector<std::string>{});
}

TEST(PlanSteps, StepsTooLongForTheFirstPlan_AreNamed) {
  const std::vector<std::string> sentences = step_complaints(with_step(0.3, 5));
  ASSERT_EQ(sentences.size(), 1U);
  testing::expect_words(sentences[0], {"the first plan", "too coarse", "0.3 s", "short enough"});
}

TEST(PlanSteps, StepsTooLongForAContact_NameTheContact) {
  MpcSpec spec = with_step(0.01, 6);
  ContactSpec pad{.name = "pad", .tool = "tool", .directions = Directions::z()};
  spec.problem.contacts = {pad.with_gains(0.0, 300.0)};
  spec.problem.stages[1].contacts = {"pad"};
  const std::vector<std::string> sentences = step_complaints(spec);
  ASSERT_FALSE(sentences.empty());
  testing::expect_words(sentences[0], {"stage 'wave'", "contact 'pad'", "kd 300", "0.0066 s"});
}

TEST(PlanSteps, TooManyKnots_AreRefusedBeforeASolve) {
  testing::expect_words(testing::refusal([] { (void)step_complaints(with_step(0.01, 100'000)); }),
                        {"horizon of 1000 s", "100000 knots", "at most 10000"});
}

}  // namespace
}  // namespace burnish::test
