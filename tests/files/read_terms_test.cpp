// What keys of a cost in a problem file make of its residual.
#include <gtest/gtest.h>

#include "burnish/files/problem_file.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

/// A foot on three directions that is pressed on, and what its cone says besides.
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

TEST(ReadTerms, SidesOfAConeAreNamedByWhereTheyLook) {
  const ProblemFile file = with_cone(", friction: 0.7, sides: 4, lower: {side_90deg: 3, other: 2}");
  const Problem problem(file.spec);
  const std::vector<std::string> names{"cone/side_0deg", "cone/side_90deg", "cone/side_180deg",
                                       "cone/side_270deg"};
  EXPECT_EQ(problem.row_names(0), names);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(problem.row_lower(0)[i], i == 1 ? 3.0 : 2.0);
}

TEST(ReadTerms, ConesAreExactUnlessSidesAreSaid) {
  const std::vector<std::string> names{"cone/cone", "cone/normal"};
  EXPECT_EQ(Problem(with_cone("").spec).row_names(0), names);
  EXPECT_EQ(Problem(with_cone(", sides: 0").spec).row_names(0), names);
}

TEST(ReadTerms, SidesThatMakeNoPyramidAreRefusedWithTheirPlace) {
  for (const char* sides : {"1", "2", "33", "1000000000"})
    expect_words(refusal([&] { with_cone(std::string(", sides: ") + sides); }),
                 {"cone.sides: sides is ", sides, "wanted 3 to 32, or 0 for the cone itself"});
  expect_words(refusal([] { with_cone(", sides: -4"); }),
               {"cone.sides: it is -4; wanted at least 0"});
  expect_words(refusal([] { with_cone(", sides: 4.5"); }), {"cone.sides", "whole number"});
}

}  // namespace
}  // namespace burnish::testing
