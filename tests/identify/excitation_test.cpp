// Tests of excitation about postures that need a large part of the joints' effort limits.
#include "burnish/identify/excitation.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

constexpr ExcitationSpec few{.candidates = 4};
constexpr int lifting = 1;  // entry of joint_2 in v; joint_2 carries most of the arm

/// Returns the torque of joint_2 that holds arm7 in its posture "ready" [Nm].
double holding_torque() {
  const Model model = arm7::model(Base::Fixed);
  ContactDynamics dynamics(model);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv), none;
  EXPECT_EQ(dynamics.inverse(arm7::ready(), rest, rest, none), Status::Ok);
  return std::abs(dynamics.tau()[lifting]);
}

Model arm_with_effort(double limit) {
  Model model = arm7::model(Base::Fixed);
  model.effort_limit[lifting] = limit;
  return model;
}

std::string refusal_with_effort(double limit, const ExcitationSpec& spec = few) {
  try {
    const Excitation motion(arm_with_effort(limit), arm7::ready(), "tool", spec);
    return "not refused: " + (motion.warnings().empty() ? "" : motion.warnings().front());
  } catch (const Error& error) {
    return error.what();
  }
}

void expect_in(const std::string& sentence, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(sentence.find(word), std::string::npos) << word << " is missing in: " << sentence;
}

TEST(Excitation, StartBeyondAnEffortLimit_IsRefusedWithTheJoint) {
  const double torque = holding_torque();
  expect_in(refusal_with_effort(0.9 * torque),
            {"joint 'joint_2' needs ", " Nm to hold the start", "more than its effort limit of ",
             "--posture", "robot.yaml"});
  expect_in(refusal_with_effort(0.0), {"more than its effort limit of 0 Nm"});
}

TEST(Excitation, StartBeyondTheEffortFraction_IsRefusedWithTheFraction) {
  const double limit = holding_torque() / 0.9;
  expect_in(refusal_with_effort(limit), {"joint 'joint_2'", "more than 0.8 of its effort limit of",
                                         "--posture", "--effort-share"});
  expect_in(refusal_with_effort(limit, {.effort_share = 1.0, .candidates = 4}),
            {"not refused: the motion is reduced to "});
}

TEST(Excitation, NoMotionWithinAnEffortLimit_IsRefusedWithTheJoint) {
  expect_in(
      refusal_with_effort(holding_torque() / 0.79999),
      {"no motion was found", "joint 'joint_2' would need ", "not even at 7 % of the full size"});
}

TEST(Excitation, MotionBeyondAnEffortLimit_IsReducedWithAWarning) {
  const Model model = arm_with_effort(holding_torque() / 0.75);
  const Excitation motion(model, arm7::ready(), "tool", few);
  ASSERT_EQ(motion.warnings().size(), 1U);
  expect_in(motion.warnings()[0], {"the motion is reduced to ", " % of the size", "joint 'joint_2'",
                                   "more than 0.8 of its effort limit of "});
  ContactDynamics dynamics(model);
  Eigen::VectorXd q, v, a;
  for (double t = 0.0; t <= motion.duration(); t += 0.04) {
    motion.at(t, q, v, a);
    ASSERT_EQ(dynamics.inverse(q, v, a, Eigen::VectorXd()), Status::Ok);
    EXPECT_LE(std::abs(dynamics.tau()[lifting]), 0.8 * model.effort_limit[lifting]);
  }
}

TEST(Excitation, MotionWithinTheLimits_HasNoWarning) {
  const Model model = arm7::model(Base::Fixed);
  EXPECT_TRUE(Excitation(model, arm7::ready(), "tool", few).warnings().empty());
}

TEST(Excitation, RobotWithALoop_IsRefused) {
  if (!is_available("four_bar")) GTEST_SKIP() << "no robots in files";
  const Model model = named_robot("four_bar");
  try {
    const Excitation motion(model, model.q_neutral, "tool", few);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    expect_in(error.what(), {"'four_bar' has the loop ", "--lock"});
  }
}

}  // namespace
}  // namespace burnish::test
