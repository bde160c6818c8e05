// Tests of settings files of robots: keys, refusals, and variants.
#include "robots/robot_settings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "robots/descriptions.gen.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

RobotSettingsFile parse(const std::string& lines) {
  return parse_robot_settings("urdf: arm.urdf\n" + lines, "robot.yaml");
}

std::string sentence(const std::string& lines) {
  return refusal([&] { parse(lines); });
}

TEST(RobotSettings, InfiniteLimits_AreRead) {
  const double infinity = std::numeric_limits<double>::infinity();
  const RobotSettings settings =
      parse("limits: {a: {lower: -.inf, upper: inf, velocity: .inf}, b: {lower: -inf, effort: 0}}")
          .common;
  const JointLimits &a = settings.limits.at("a"), &b = settings.limits.at("b");
  EXPECT_EQ(a.lower, -infinity);
  EXPECT_EQ(a.upper, infinity);
  EXPECT_EQ(a.velocity, infinity);
  EXPECT_EQ(a.effort, std::nullopt);
  EXPECT_EQ(b.lower, -infinity);
  EXPECT_EQ(b.effort, 0.0);
  EXPECT_EQ(sentence("limits: {a: {upper: never}}"),
            "robot.yaml: line 2: limits.a.upper: 'never' is not a number");
  EXPECT_EQ(sentence("limits: {a: {velocity: -.inf}}"),
            "robot.yaml: line 2: limits.a.velocity: it is -inf; wanted at least 0");
  EXPECT_EQ(sentence("joints: {a: {armature: .inf}}"),
            "robot.yaml: line 2: joints.a.armature: '.inf' is not a number");
}

TEST(RobotSettings, BadKeys_AreRefusedWithTheValidKeys) {
  const std::string error = sentence("colour_of_paint: red");
  EXPECT_TRUE(error.ends_with("loops, inertias, payload or variants")) << error;
  EXPECT_EQ(sentence("variants: {a: {mjcf: a.xml, urdf: a.urdf}}"),
            "robot.yaml: line 2: variants.a: keys 'urdf' and 'mjcf' are both stated; wanted "
            "only one");
  EXPECT_EQ(sentence("frames: {world: {parent: hand}}"),
            "robot.yaml: line 2: frames.world: the name 'world' is reserved; wanted another name");
  EXPECT_EQ(sentence("joints: {a: {rotor_inertia: 1e-5, gear_ratio: 0}}"),
            "robot.yaml: line 2: joints.a.gear_ratio: it is 0; wanted a number of rotor turns "
            "per joint turn other than 0");
  EXPECT_EQ(sentence("postures: {a: {from: b}, b: {j: 1}}"),
            "robot.yaml: line 2: postures.a.from: posture 'b' is not one of the postures earlier "
            "in the file");
}

/// A key with a default value would let every variant reset it.
TEST(RobotSettings, EveryKey_IsOptional) {
  using Kind = ValueType::Kind;
  for (const Field& field : description_of(static_cast<const RobotSettings*>(nullptr)).fields) {
    const Kind kind = field.type->kind;
    const bool is_named = kind == Kind::List && field.type->element().kind == Kind::Struct;
    EXPECT_TRUE(kind == Kind::Optional || kind == Kind::Map || is_named) << field.key;
    EXPECT_FALSE(field.meaning.empty()) << field.key;
  }
}

TEST(RobotSettings, Variant_OverridesTheFile) {
  const RobotSettingsFile file = parse(R"(srdf: arm.srdf
base: free_flyer
base_placement: {xyz: [1, 2, 3]}
lock: [a]
postures: {low: {a: 1}, high: {a: 2}}
frames: {tool: {parent: hand, xyz: [1, 0, 0]}, tip: {parent: tool}}
limits: {a: {lower: -1, effort: 5}, b: {effort: 6}}
joints: {a: {damping: 1}}
inertias: {hand: {mass: 1}}
payload: {mass: 3}
variants:
  none: {}
  other:
    mjcf: arm.xml
    base: fixed
    free: [b]
    postures: {low: {a: 3}, middle: {a: 4}}
    frames: {more: {parent: hand}, tool: {parent: arm}}
    limits: {a: {velocity: 2}}
    joints: {b: {damping: 2}}
    inertias: {hand: {mass: 2}}
    payload: {mass: 4, frame: tip}
)");
  const RobotSettings same = with_variant(file.common, file.variants.at("none"));
  EXPECT_EQ(same.urdf, "arm.urdf");
  EXPECT_EQ(same.base, Base::FreeFlyer);
  EXPECT_EQ(same.lock, std::vector<std::string>{"a"});
  EXPECT_EQ(same.postures, file.common.postures);
  EXPECT_EQ(same.frames.size(), 2U);
  EXPECT_EQ(same.payload->inertia.mass, 3.0);

  const RobotSettings other = with_variant(file.common, file.variants.at("other"));
  EXPECT_EQ(other.urdf, std::nullopt);
  EXPECT_EQ(other.mjcf, "arm.xml");
  EXPECT_EQ(other.srdf, "arm.srdf");
  EXPECT_EQ(other.base, Base::Fixed);
  EXPECT_EQ(other.base_placement->translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(other.lock, std::nullopt);
  EXPECT_EQ(other.free, std::vector<std::string>{"b"});
  EXPECT_EQ(other.postures,
            (std::map<std::string, Posture>{
                {"high", {{"a", {2}}}}, {"low", {{"a", {3}}}}, {"middle", {{"a", {4}}}}}));
  ASSERT_EQ(other.frames.size(), 3U);
  EXPECT_EQ(other.frames[0].name, "tool");
  EXPECT_EQ(other.frames[0].parent, "arm");
  EXPECT_EQ(other.frames[0].placement.translation(), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(other.frames[1].name, "tip");
  EXPECT_EQ(other.frames[2].name, "more");
  EXPECT_EQ(other.limits.at("a").lower, std::nullopt) << "an entry is replaced as a whole";
  EXPECT_EQ(other.limits.at("a").velocity, 2.0);
  EXPECT_EQ(other.limits.at("b").effort, 6.0);
  EXPECT_EQ(other.joints.at("a").damping, 1.0);
  EXPECT_EQ(other.joints.at("b").damping, 2.0);
  EXPECT_EQ(other.inertias.at("hand").mass, 2.0);
  EXPECT_EQ(other.payload->frame, "tip");
}

}  // namespace
}  // namespace burnish::testing
