// Problems with hard limits that an arm meets while it presses: those that have a solution end with
// it within few iterations, the others say which limits cannot hold together.
#include <gtest/gtest.h>

#include "burnish/solver/ddp.hpp"
#include "support/problem_files.hpp"

namespace burnish::testing {
namespace {

/// Iterations within which each of these solves must end.
constexpr int most_iterations = 50;

/// An arm's tip goes up a board and presses with a force that swings, within a band. The tool's
/// lean from the board's normal is at most `lean` [rad], but for the first `free` knots.
struct Board {
  std::string start, normal, goal;
  double lean = 0.0;
  int free = 0;

  std::string text(const std::string& update) const {
    const std::string surface = "reference: {surface: {normal: " + normal + "}}";
    const std::string stage =
        "    contacts: [pad]\n"
        "    step: 0.01\n"
        "    costs: {posture: 0.1, torque: 1e-4, along: 1e4, force: 1}\n"
        "    constraints:\n"
        "      speed: {type: joint_velocity, limits: 0.3}\n"
        "      effort: {type: joint_torque, limits: 0.8}\n"
        "      band: {type: contact_force, contact: pad, lower: 13, upper: 17}\n";
    const std::string bound = std::to_string(lean);
    return arm + "start: {" + start + "}\n" +
           "contacts:\n"
           "  pad: {tool: tool, " +
           surface +
           ", directions: z, kd: 40}\n"
           "terms:\n"
           "  posture: {type: state}\n"
           "  torque: {type: control, target: {hold: {pad: 15}}}\n"
           "  along: {type: frame_position, frame: tool, axes: {normal: " +
           normal + "}, target: {line: {from: here, to: {here: " + goal +
           "}, start: 0.2, duration: 1.5}}, weights: [1, 1, 0]}\n"
           "  force: {type: contact_force, contact: pad,"
           " target: {sine: {center: 15, amplitude: 3, rate: 6.28}}}\n"
           "stages:\n  slide:\n" +
           stage + "  press:\n" + stage +
           "      lean: {type: frame_inclination, frame: tool, axis: [0, 0, -1], " + surface +
           ", lower: -" + bound + ", upper: " + bound + "}\n" + "horizon: [" +
           (free > 0 ? "slide: " + std::to_string(free) + ", " : "") +
           "press: " + std::to_string(200 - free) +
           "]\n"
           "terminal: {posture: 0.1, along: 1e3}\n"
           "solver: {update: " +
           update + ", max_iterations: " + std::to_string(most_iterations) + "}\n";
  }
};

/// The start leans by 0.398 rad.
Board leaning(double lean, int free = 0) {
  return {"posture: ready", "[-0.3, 0, 1]", "[0.1044, 0, 0]", lean, free};
}
/// A board of 30 degrees, and the tool along its normal at the start. Without a bound the lean's
/// largest value is 0.1571 rad.
Board steep(double lean) {
  return {"q: [-0.0126, 0.0272, -0.1305, -2.3811, -0.2525, -1.5672, 0.3002]", "[-0.577, 0, 1]",
          "[0.076545, 0, 0]", lean};
}

class LimitedProblem : public ProblemFiles, public ::testing::WithParamInterface<std::string> {
 protected:
  /// `look` at the summary of a board's solve.
  template <class Look>
  void solve(const Board& board, const Look& look) const {
    const ProblemFile file = read(board.text(GetParam()));
    Problem problem(file.spec);
    DdpSolver solver(problem, file.solver);
    const TrajectoryGuess guess = make_guess(problem, file.guess);
    solver.set_guess(guess.xs, guess.us);
    solver.solve();
    SCOPED_TRACE(solver.text());
    look(problem, solver);
  }
  static std::string name(const Problem& problem, const RowPlace& place) {
    return problem.row_names(place.knot).at(static_cast<std::size_t>(place.row));
  }
};

TEST_P(LimitedProblem, BoundThatTheOptimumHardlyReaches_ConvergesToIt) {
  double cost = 0.0;
  for (const double lean : {0.3, 0.17, 0.16, 0.158, 0.1571})
    solve(steep(lean), [&](const Problem& /*problem*/, const DdpSolver& solver) {
      const DdpSummary& s = solver.summary();
      EXPECT_EQ(s.reason, StopReason::Converged) << lean;
      EXPECT_TRUE(s.feasible);
      EXPECT_LE(s.iterations, 10);
      if (cost == 0.0) cost = s.cost;
      EXPECT_NEAR(s.cost, cost, 1e-6 * cost) << lean;
    });
}

TEST_P(LimitedProblem, BoundFarBelowTheOptimum_Converges) {
  double cost = 0.0;
  for (const double lean : {0.14, 0.08, 0.05, 0.02})
    solve(steep(lean), [&](const Problem& /*problem*/, const DdpSolver& solver) {
      const DdpSummary& s = solver.summary();
      EXPECT_EQ(s.reason, StopReason::Converged) << lean;
      EXPECT_TRUE(s.feasible);
      EXPECT_LE(s.iterations, 15);
      EXPECT_GT(s.cost, cost) << "less room cannot be cheaper";
      cost = s.cost;
    });
}

TEST_P(LimitedProblem, StartOutside_EndsInfeasibleAndNamesWhatStopsIt) {
  for (const double lean : {0.15, 0.3})
    solve(leaning(lean), [&](const Problem& problem, const DdpSolver& solver) {
      const DdpSummary& s = solver.summary();
      EXPECT_EQ(s.reason, StopReason::Infeasible) << lean;
      EXPECT_FALSE(s.feasible);
      EXPECT_LT(s.iterations, most_iterations);
      ASSERT_EQ(s.start_outside.size(), 1U);
      EXPECT_EQ(name(problem, {0, s.start_outside[0].row}), "lean/tilt");
      EXPECT_NEAR(s.start_outside[0].value, 0.398, 5e-4);
      EXPECT_EQ(s.start_outside[0].upper, lean);
      ASSERT_FALSE(s.conflict.empty());
      EXPECT_EQ(name(problem, s.conflict[0]), "lean/tilt");
      std::string limits;
      for (const std::vector<RowPlace>& places : {s.conflict, s.stopping})
        for (const RowPlace& place : places) limits += name(problem, place) + " ";
      EXPECT_NE(limits.find("speed/joint_6"), std::string::npos) << limits;
      const std::string sentence = solver.text(), bound = lean == 0.3 ? "0.3" : "0.15";
      EXPECT_NE(sentence.find("the start is outside its limits: 'lean/tilt' is 0.398, allowed -" +
                              bound + " to " + bound),
                std::string::npos);
      EXPECT_NE(sentence.find("no trajectory near this one keeps all limits: 'lean/tilt' (knot 0"),
                std::string::npos);
    });
}

TEST_P(LimitedProblem, StartOutsideWhatItsStageLimits_Converges) {
  for (const double lean : {0.15, 0.3})
    solve(leaning(lean, 40), [&](const Problem& /*problem*/, const DdpSolver& solver) {
      EXPECT_EQ(solver.summary().reason, StopReason::Converged) << lean;
      EXPECT_TRUE(solver.summary().feasible);
      EXPECT_TRUE(solver.summary().start_outside.empty());
    });
}

INSTANTIATE_TEST_SUITE_P(Updates, LimitedProblem, ::testing::Values("rollout", "multiple_shooting"),
                         [](const auto& update) { return update.param; });

}  // namespace
}  // namespace burnish::testing
