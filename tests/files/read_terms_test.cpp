// Tests of the keys of a cost in a problem file: the residual that they describe.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/files/problem_file.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

/// Returns a problem with a foot that presses, and a friction cone with further keys.
ProblemFile with_cone(const std::string& keys) {
  const Scratch scratch;
  return read_problem_file(
      scratch.write("cone.yaml", "robot: " BURNISH_ROBOTS_DIR "/arm7\n"
                                 "contacts: {foot: {tool: tool, directions: [x, y, z], kd: 50}}\n"
                                 "stages:\n"
                                 "  press:\n"
                                 "    contacts: [foot]\n"
                                 "    costs: {rest: {type: state}}\n"
                                 "    constraints: {cone: {type: friction_cone, contact: foot" +
                                     keys +
                                     "}}\n"
                                     "horizon: [press: 2]\n"));
}

TEST(TermReader, ConeSides_AreNamedByTheirDirections) {
  const ProblemFile file = with_cone(", friction: 0.7, sides: 4, lower: {side_90deg: 3, other: 2}");
  const Problem problem(file.spec);
  const std::vector<std::string> names{"cone/side_0deg", "cone/side_90deg", "cone/side_180deg",
                                       "cone/side_270deg"};
  EXPECT_EQ(problem.row_names(0), names);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(problem.row_lower(0)[i], i == 1 ? 3.0 : 2.0);
}

TEST(TermReader, ConeWithoutSides_IsExact) {
  const std::vector<std::string> names{"cone/cone", "cone/normal"};
  EXPECT_EQ(Problem(with_cone("").spec).row_names(0), names);
  EXPECT_EQ(Problem(with_cone(", sides: 0").spec).row_names(0), names);
}

TEST(TermReader, BadNumberOfSides_IsRefusedWithItsPlace) {
  for (const char* sides : {"1", "2", "33", "1000000000"})
    expect_words(refusal([&] { with_cone(std::string(", sides: ") + sides); }),
                 {"cone.sides: sides is ", sides, "wanted 3 to 32, or 0 for the cone itself"});
  expect_words(refusal([] { with_cone(", sides: -4"); }),
               {"cone.sides: it is -4; wanted at least 0"});
  expect_words(refusal([] { with_cone(", sides: 4.5"); }), {"cone.sides", "whole number"});
}

/// Returns a problem with a limit on torques, of a robot one of whose joints has no effort limit.
ProblemFile with_torque_limit(const std::string& keys) {
  const Scratch scratch;
  scratch.write("loose.yaml",
                "urdf: " BURNISH_ROBOTS_DIR "/arm7/arm7.urdf\nlimits: {joint_2: {effort: .inf}}\n");
  return read_problem_file(scratch.write("torque.yaml",
                                         "robot: loose.yaml\n"
                                         "stages:\n"
                                         "  move:\n"
                                         "    costs: {rest: {type: state}}\n"
                                         "    constraints: {tau: {type: joint_torque" +
                                             keys +
                                             "}}\n"
                                             "horizon: [move: 2]\n"));
}

TEST(TermReader, RobotLimits_SkipJointsWithoutALimit) {
  const Problem problem(with_torque_limit(", limits: 0.9").spec);
  for (int row = 0; row < 7; ++row)
    EXPECT_EQ(std::isinf(problem.row_upper(0)[row]), row == 1) << row;
}

TEST(TermReader, RowWithoutAScale_IsNamed) {
  expect_words(refusal([] { Problem(with_torque_limit(", upper: 5").spec); }),
               {"row 'joint_2'", "wanted a scale"});
}

TEST(TermReader, EmptyOrRepeatedJoints_AreRefusedWithTheirPlace) {
  expect_words(refusal([] { with_torque_limit(", limits: 0.9, joints: []"); }),
               {"tau.joints: the list is empty; wanted at least one joint"});
  expect_words(refusal([] { with_torque_limit(", limits: 0.9, joints: [joint_1, joint_1]"); }),
               {"tau.joints: joint 'joint_1' is listed twice"});
}

}  // namespace
}  // namespace burnish::testing
