// Tests of the active constraints of a solution: a table by knots, and ranges of time.
#include <gtest/gtest.h>

#include "burnish/ocp/step_check.hpp"
#include "record/solution.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

class SolutionLimits : public ::testing::Test {
 protected:
  static Problem problem(const std::string& start = "") {
    const Scratch scratch;
    const auto file = scratch.write(
        "swing.yaml",
        "robot: pendulum\n" + start +
            "stages:\n"
            "  swing: {step: 0.25, costs: {torque: {type: control}},\n"
            "          constraints: {speed: {type: joint_velocity, lower: -1, upper: 1}}}\n"
            "  hold: {step: 0.5, costs: {torque: {type: control}}}\n"
            "horizon: [swing: 4, hold: 2]\n");
    return Problem(read_problem_file(file).spec);
  }

  static constexpr double none = std::numeric_limits<double>::infinity();
  Problem swing = problem();
};

TEST_F(SolutionLimits, Csv_HasALinePerRowAndKnot) {
  CostReport report;
  report.limits = {{.knot = 1,
                    .row = "speed/hinge",
                    .value = 1.0,
                    .lower = -none,
                    .upper = 1.0,
                    .multiplier = 0.5},
                   {.knot = 5, .row = "a, b", .value = std::nan(""), .lower = 0.0, .upper = 2.0}};
  EXPECT_EQ(limits_csv(swing, report),
            "knot [-],time [s],stage [-],row,value,lower,upper,multiplier\n"
            "1,0.25,0,speed/hinge,1,-inf,1,0.5\n"
            "5,1.5,1,\"a, b\",,0,2,0\n");
}

TEST_F(SolutionLimits, ActiveConstraints_AreRangesOfConsecutiveKnots) {
  CostReport report;
  const auto add = [&](int knot, const char* row, double multiplier) {
    report.limits.push_back({.knot = knot, .row = row, .multiplier = multiplier});
  };
  for (const int knot : {0, 1}) add(knot, "speed", -2.0);
  add(1, "range", 1.0);
  add(2, "speed", 0.0);  // violated, with multiplier 0
  add(2, "range", 1.0);
  for (const int knot : {3, 4, 5}) add(knot, "speed", 2.0);
  add(6, "broken", 0.0);
  const auto times = active_times(swing, report);
  ASSERT_EQ(times.size(), 2U);
  EXPECT_EQ(times.at("speed").dump(), "[[0.0,0.25],[0.75,1.5]]");
  EXPECT_EQ(times.at("range").dump(), "[[0.25,0.5]]");
}

TEST_F(SolutionLimits, InfeasibleStart_IsInTheSummaryAndItsSentence) {
  Problem fast = problem("start: {velocity: {pivot: 3}}\n");
  DdpSolver solver(fast);
  solver.solve();
  const auto summary =
      summary_json("swing.yaml", fast, solver, check_steps(fast, solver.xs(), solver.us()));
  EXPECT_EQ(summary["reason"], "infeasible");
  EXPECT_EQ(summary["converged"], false);
  EXPECT_EQ(summary["feasible"], false);
  EXPECT_EQ(summary["largest_gap"], 0.0);
  EXPECT_EQ(summary["violation"], 2.0);
  ASSERT_EQ(summary["start_violations"].size(), 1U);
  EXPECT_EQ(summary["start_violations"][0]["row"], "speed/pivot");
  EXPECT_EQ(summary["start_violations"][0]["value"], 3.0);
  EXPECT_EQ(summary["start_violations"][0]["upper"], 1.0);
  const std::string sentence = summary["sentence"];
  EXPECT_NE(sentence.find("the initial state violates limits: 'speed/pivot' is 3, allowed -1 to 1"),
            std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("not feasible: 'speed/pivot'"), std::string::npos) << sentence;
}

TEST_F(SolutionLimits, SummaryOfASolution_IsFeasible) {
  DdpSolver solver(swing);
  ASSERT_EQ(solver.solve().reason, StopReason::Converged);
  const auto summary =
      summary_json("swing.yaml", swing, solver, check_steps(swing, solver.xs(), solver.us()));
  EXPECT_EQ(summary["feasible"], true);
  EXPECT_EQ(summary["start_violations"].size(), 0U);
}

}  // namespace
}  // namespace burnish::testing
