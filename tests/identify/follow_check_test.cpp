// Tests of the check that a simulated arm follows its planned motion.
#include <gtest/gtest.h>

#include <functional>

#include "burnish/identify/trial.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

/// A motion of arm7 about its posture "ready"; joint_5 is continuous.
struct ShortMotion {
  Model model = [] {
    TreeSpec tree = arm7::tree();
    tree.joints[4].type = JointType::Continuous;
    return build_model(tree, arm7::options(Base::Fixed));
  }();
  Excitation motion{
      model,
      configuration(
          model,
          {{"joint_2", {0.23}}, {"joint_4", {-1.94}}, {"joint_5", {M_PI}}, {"joint_6", {-0.67}}}),
      "tool",
      {.duration = 5.0, .candidates = 1}};

  /// Returns the planned motion with joint_5 off by `angle`, joint_2 off by `lift` [rad] and a
  /// commanded torque `torque` of joint_2 [Nm], each a function of time [s].
  using AtTime = std::function<double(double)>;
  Trace trace(const AtTime& angle, const AtTime& lift, const AtTime& torque) const {
    std::vector<TraceColumn> columns{{"time", "s"}};
    for (int k = 0; k < model.nq; ++k) columns.push_back({"q_" + model.q_name(k), "-"});
    for (int k = 0; k < model.nv; ++k) columns.push_back({"tau_command_" + model.v_name(k), "Nm"});
    Trace result(columns, 501);
    Eigen::VectorXd q, v, a, off = Eigen::VectorXd::Zero(model.nv);
    for (int i = 0; i < 501; ++i) {
      const double t = 0.01 * i;
      motion.at(t, q, v, a);
      off[4] = angle(t);
      off[1] = lift(t);
      double* const row = result.add_row();
      row[0] = t;
      Eigen::Map<Eigen::VectorXd>(row + 1, model.nq) = integrate(model, q, off);
      row[1 + model.nq + 1] = torque(t);
    }
    return result;
  }
};
const ShortMotion& short_motion() {
  static const ShortMotion one;
  return one;
}
double zero(double) { return 0.0; }

std::vector<std::string> sentences(const Trace& trace) {
  return check_followed(short_motion().model, short_motion().motion, trace);
}

TEST(FollowCheck, MotionAsPlanned_HasNoWarning) {
  EXPECT_TRUE(sentences(short_motion().trace(zero, zero, zero)).empty());
  // A wrist may swing, and a joint may lag while its torque is below the limit.
  const auto swing = [](double t) { return 0.6 * std::sin(t); };
  const auto late = [](double t) { return 0.05 * std::sin(t); };
  EXPECT_TRUE(sentences(short_motion().trace(swing, late, zero)).empty());
  // The torque is at its limit for a moment, while the joint follows.
  EXPECT_TRUE(sentences(short_motion().trace(swing, late, [](double) { return 181.0; })).empty());
}

TEST(FollowCheck, JointOffItsMotion_IsAWarningWithDistanceAndTime) {
  const auto away = [](double t) { return t < 2.0 ? 0.0 : -2.0; };
  const std::vector<std::string> warnings = sentences(short_motion().trace(away, zero, zero));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(
      warnings[0].rfind("joint 'joint_5' leaves the planned motion at 2 s and is 2 rad from it", 0),
      0U)
      << warnings[0];
}

TEST(FollowCheck, JointFallingAtItsEffortLimit_IsRefusedWithDistanceAndTimes) {
  const auto sagging = [](double t) { return t < 3.0 ? 0.0 : 0.2 * (t - 3.0); };
  const Trace trace = short_motion().trace(zero, sagging, [](double) { return -180.1; });
  try {
    (void)sentences(trace);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what())
                  .rfind("the simulated arm cannot follow the motion: joint 'joint_2' leaves the "
                         "planned motion at 3.51 s and is 0.4 rad from it at 5 s, with its torque "
                         "at its effort limit of 180 Nm; wanted",
                         0),
              0U)
        << error.what();
  }
}

TEST(FollowCheck, ArmTooWeakForThePayload_IsRefused) {
  // A payload of 3 kg needs at least 15 Nm more of joint_2, which has little reserve.
  Model weak = arm7::model(Base::Fixed);
  weak.effort_limit[1] = 36.0;
  const Excitation motion(weak, arm7::ready(), "tool", {.duration = 5.0, .candidates = 4});
  std::uint64_t heavy = 0;
  while (drawn_payload("tool", heavy).inertia.mass < 2.5) ++heavy;
  try {
    (void)try_identification(weak, motion, disturbance_preset("sensors"), {}, heavy);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot follow the motion: joint 'joint_2'"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace burnish::test
