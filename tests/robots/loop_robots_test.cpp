// Tests of loops in settings: reading, and postures that close them.
#include <gtest/gtest.h>

#include "burnish/contact/loops.hpp"
#include "burnish/robots/robot.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

class LoopSettings : public ::testing::Test {
 protected:
  /// Writes settings of the four-bar mechanism that refer to its own description.
  std::string write(const std::string& settings) const {
    const std::string file =
        scratch_
            .write("robot.yaml", "urdf: " BURNISH_ROBOTS_DIR "/four_bar/four_bar.urdf\n" + settings)
            .string();
    return file;
  }
  Robot load(const std::string& settings, const RobotOverrides& overrides = {}) const {
    return load_robot(write(settings), overrides);
  }
  Scratch scratch_;
};

const std::string pin =
    "loops: {pin: {between: [coupler, rocker], first: {xyz: [0.3, 0, 0]}, "
    "second: {xyz: [0.25, 0, 0]}}}\n";

TEST_F(LoopSettings, PlacementsAndDirections_AreRead) {
  const Robot robot = load(
      "loops: {pin: {between: [coupler, rocker], first: {xyz: [0.3, 0, 0]}, second: {xyz: [0.25, "
      "0, 0], rpy: [0, 0.1, 0]}, directions: [x, z, rx]}}\ndefault_posture: any\npostures: {any: "
      "{drive: 0.8}}\n");
  ASSERT_EQ(robot.model.loops.size(), 1U);
  EXPECT_EQ(robot.model.loops[0].directions.text(), "x,z,rx");
  EXPECT_EQ(load(pin).model.loops[0].directions, Directions::linear());
}

TEST_F(LoopSettings, BadKeys_AreRefusedWithTheirPlace) {
  const auto refused = [&](const std::string& settings) {
    return refusal([&] { load(settings); });
  };
  expect_words(refused("loops: {pin: {between: [coupler, rocker], first: {xyz: [0, 0]}}}"),
               {"robot.yaml", "line 2", "loops.pin.first.xyz"});
  expect_words(refused("loops: {pin: {between: coupler}}"), {"loops.pin.between", "two links"});
  expect_words(refused("loops: {pin: {between: [coupler, rocker], direction: x}}"),
               {"direction", "directions"});
  expect_words(refused("loops: {pin: {between: [coupler, rocker], directions: [x, w]}}"),
               {"loops.pin.directions", "w"});
  expect_words(refused("loops: {pin: {between: [coupler, rokker]}}"),
               {"loop 'pin'", "'rokker'", "'rocker'"});
}

TEST_F(LoopSettings, LoopOfAVariant_ReplacesTheLoopOfTheSameName) {
  const std::string file = write(pin +
                                 "variants: {off: {loops: {pin: {between: [coupler, world], first: "
                                 "{xyz: [0.3, 0, 0]}, second: {xyz: [0.3, 0, 0.1]}}}}}\n");
  const Robot robot = load_robot(file + ":off");
  ASSERT_EQ(robot.model.loops.size(), 1U);
  EXPECT_EQ(robot.model.frames[robot.model.frame_index("pin/second")].body, -1);
}

TEST_F(LoopSettings, PartialPosture_IsCompletedToCloseTheLoop) {
  const Robot robot = load(pin + "default_posture: start\npostures: {start: {drive: 0.8}}\n");
  EXPECT_TRUE(robot.warnings.empty());
  const Eigen::VectorXd q = robot.reference_configuration();
  EXPECT_EQ(q[robot.model.joints[robot.model.joint_index("drive")].q_index], 0.8);
  EXPECT_LT(loop_misses(robot.model, q)[0].translation, 1e-8);
  // Without a posture, the neutral configuration is projected onto the loop.
  const Robot plain = load(pin);
  EXPECT_LT(loop_misses(plain.model, plain.reference_configuration())[0].translation, 1e-8);
}

TEST_F(LoopSettings, OpenPosture_IsClosedWithAWarningOrRefused) {
  const Robot closed = load(pin + "postures: {start: {drive: 0.8}}\n");
  const Eigen::VectorXd q = closed.posture("start");
  const auto posture = [&](double drive_off) {
    std::string text = "postures: {start: {";
    const char* comma = "";
    for (const Joint& joint : closed.model.joints) {
      const double off = joint.name == "drive" ? drive_off : 0.0;
      text += comma + joint.name + ": " + std::to_string(q[joint.q_index] + off);
      comma = ", ";
    }
    return text + "}}\n";
  };
  EXPECT_TRUE(load(pin + posture(0.0)).warnings.empty()) << "six decimals must be accurate enough";
  const Robot moved = load(pin + posture(0.1));
  ASSERT_EQ(moved.warnings.size(), 1U);
  expect_words(moved.warnings[0],
               {"posture 'start'", "loop 'pin'", "mm", "moves the joints until the loop closes"});
  EXPECT_LT(loop_misses(moved.model, moved.posture("start"))[0].translation, 1e-8);
  RobotOverrides strict;
  strict.strict = true;
  expect_words(refusal([&] { load(pin + posture(0.1), strict); }), {"posture 'start'", "strict"});
  const std::string far =
      "loops: {pin: {between: [coupler, rocker], first: {xyz: [0.3, 0, 0]}, "
      "second: {xyz: [0.25, 2, 0]}}}\npostures: {start: {drive: 0.8}}\ndefault_posture: start\n";
  expect_words(refusal([&] { load(far); }), {"posture 'start'", "loop 'pin'", "mm remain"});
}

}  // namespace
}  // namespace burnish::testing
