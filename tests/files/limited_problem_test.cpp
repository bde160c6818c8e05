// Tests of problems with hard limits that an arm meets while it presses. Feasible problems converge
// within few iterations; infeasible problems name the limits in conflict.
#include <gtest/gtest.h>

#include "burnish/solver/ddp.hpp"
#include "support/problem_files.hpp"

namespace burnish::testing {
namespace {

/// Largest number of iterations of each of these solves.
constexpr int max_iterations = 50;

/// An arm's tip goes up a board and presses with a sinusoidal force within a band. The tool's
/// inclination from the board's normal is at most `incline` [rad], except at the first `free`
/// knots.
struct Board {
  std::string start, normal, goal;
  double incline = 0.0;
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
    const std::string bound = std::to_string(incline);
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
           "      incline: {type: frame_inclination, frame: tool, axis: [0, 0, -1], " + surface +
           ", lower: -" + bound + ", upper: " + bound + "}\n" + "horizon: [" +
           (free > 0 ? "slide: " + std::to_string(free) + ", " : "") +
           "press: " + std::to_string(200 - free) +
           "]\n"
           "terminal: {posture: 0.1, along: 1e3}\n"
           "solver: {update: " +
           update + ", max_iterations: " + std::to_string(max_iterations) + "}\n";
  }
};

/// Returns a board from which the tool is inclined by 0.398 rad at the start.
Board inclined(double incline, int free = 0) {
  return {"posture: ready", "[-0.3, 0, 1]", "[0.1044, 0, 0]", incline, free};
}
/// Returns a board of 30 degrees with the tool along its normal at the start. Without a bound, the
/// largest inclination is 0.1571 rad.
Board steep(double incline) {
  return {"q: [-0.0126, 0.0272, -0.1305, -2.3811, -0.2525, -1.5672, 0.3002]", "[-0.577, 0, 1]",
          "[0.076545, 0, 0]", incline};
}

class LimitedProblem : public ProblemFiles, public ::testing::WithParamInterface<std::string> {
 protected:
  /// Solves the problem of a board and calls `look` with the problem and the solver.
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

TEST_P(LimitedProblem, BoundNearTheOptimum_ConvergesToTheSameCost) {
  double cost = 0.0;
  for (const double incline : {0.3, 0.17, 0.16, 0.158, 0.1571})
    solve(steep(incline), [&](const Problem& /*problem*/, const DdpSolver& solver) {
      const DdpSummary& s = solver.summary();
      EXPECT_EQ(s.reason, StopReason::Converged) << incline;
      EXPECT_TRUE(s.feasible);
      EXPECT_LE(s.iterations, 10);
      if (cost == 0.0) cost = s.cost;
      EXPECT_NEAR(s.cost, cost, 1e-6 * cost) << incline;
    });
}

TEST_P(LimitedProblem, BoundFarBelowTheOptimum_Converges) {
  double cost = 0.0;
  for (const double incline : {0.14, 0.08, 0.05, 0.02})
    solve(steep(incline), [&](const Problem& /*problem*/, const DdpSolver& solver) {
      const DdpSummary& s = solver.summary();
      EXPECT_EQ(s.reason, StopReason::Converged) << incline;
      EXPECT_TRUE(s.feasible);
      EXPECT_LE(s.iterations, 15);
      EXPECT_GT(s.cost, cost) << "a tighter bound cannot reduce the cost";
      cost = s.cost;
    });
}

TEST_P(LimitedProblem, StartBeyondABound_IsInfeasibleAndNamesTheConflict) {
  for (const double incline : {0.15, 0.3})
    solve(inclined(incline), [&](const Problem& problem, const DdpSolver& solver) {
      const DdpSummary& s = solver.summary();
      EXPECT_EQ(s.reason, StopReason::Infeasible) << incline;
      EXPECT_FALSE(s.feasible);
      EXPECT_LT(s.iterations, max_iterations);
      ASSERT_EQ(s.start_violations.size(), 1U);
      EXPECT_EQ(name(problem, {0, s.start_violations[0].row}), "incline/tilt");
      EXPECT_NEAR(s.start_violations[0].value, 0.398, 5e-4);
      EXPECT_EQ(s.start_violations[0].upper, incline);
      ASSERT_FALSE(s.conflict.empty());
      EXPECT_EQ(name(problem, s.conflict[0]), "incline/tilt");
      std::string limits;
      for (const std::vector<RowPlace>& places : {s.conflict, s.stopping})
        for (const RowPlace& place : places) limits += name(problem, place) + " ";
      EXPECT_NE(limits.find("speed/joint_6"), std::string::npos) << limits;
      const std::string sentence = solver.text(), bound = incline == 0.3 ? "0.3" : "0.15";
      EXPECT_NE(
          sentence.find("the initial state violates limits: 'incline/tilt' is 0.398, allowed -" +
                        bound + " to " + bound),
          std::string::npos);
      EXPECT_NE(
          sentence.find("no trajectory near this one satisfies all limits: 'incline/tilt' (knot 0"),
          std::string::npos);
    });
}

TEST_P(LimitedProblem, StartBeyondABoundOfALaterStage_Converges) {
  for (const double incline : {0.15, 0.3})
    solve(inclined(incline, 40), [&](const Problem& /*problem*/, const DdpSolver& solver) {
      EXPECT_EQ(solver.summary().reason, StopReason::Converged) << incline;
      EXPECT_TRUE(solver.summary().feasible);
      EXPECT_TRUE(solver.summary().start_violations.empty());
    });
}

INSTANTIATE_TEST_SUITE_P(Updates, LimitedProblem, ::testing::Values("rollout", "multiple_shooting"),
                         [](const auto& update) { return update.param; });

}  // namespace
}  // namespace burnish::testing
