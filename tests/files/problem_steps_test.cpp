// Tests of problems whose steps are too long for their motion, and of the default friction speed,
// which follows from the step.
#include <cmath>

#include "burnish/ocp/check.hpp"
#include "burnish/ocp/step_check.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/problem_files.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

struct SolveResult {
  DdpSummary summary;
  StepReport steps;
  std::vector<std::string> complaints;
  bool derivatives = true;  ///< whether the derivatives pass the check
};

class ProblemSteps : public ProblemFiles {
 protected:
  SolveResult solve(const std::string& text, bool check = false) const {
    const ProblemFile file = read(text);
    Problem problem(file.spec);
    SolveResult result;
    result.complaints = step_complaints(problem);
    if (check) result.derivatives = check_problem(problem).pass;
    DdpSolver solver(problem, file.solver);
    const TrajectoryGuess guess = make_guess(problem, file.guess);
    solver.set_guess(guess.xs, guess.us);
    result.summary = solver.solve();
    result.steps = check_steps(problem, solver.xs(), solver.us());
    return result;
  }
};

/// Returns a problem in which the arm reaches for a point and comes to rest at the end.
std::string reaching(double step, int knots, const std::string& integrator) {
  return arm +
         "start: {posture: ready}\n"
         "terms:\n"
         "  posture: {type: state, weights: {q: 1, v: 0.1}}\n"
         "  torque: {type: control, target: hold}\n"
         "  point: {type: frame_position, frame: tool, target: {here: [0.1, -0.25, 0.1]}}\n"
         "  upright: {type: frame_rotation, frame: tool, target: here}\n"
         "  rest: {type: joint_velocity}\n"
         "  joint_limits: {type: joint_position, penalty: {barrier: {limits: 0.95}}}\n"
         "stages:\n"
         "  move:\n"
         "    step: " +
         std::to_string(step) + "\n    integrator: " + integrator +
         "\n"
         "    costs: {posture: 0.1, torque: 1e-3, upright: 10, joint_limits: 1e3}\n"
         "horizon: [move: " +
         std::to_string(knots) +
         "]\n"
         "terminal: {point: 1e4, upright: 1e2, rest: 1e2}\n";
}

TEST_F(ProblemSteps, StepsOfOneSecond_AreTooCoarse) {
  const SolveResult coarse = solve(reaching(1.0, 150, "semi_implicit_euler"));
  EXPECT_EQ(coarse.summary.reason, StopReason::Converged);
  EXPECT_TRUE(coarse.steps.coarse);
  EXPECT_EQ(coarse.steps.status, Status::Ok);
  EXPECT_NEAR(coarse.steps.position.error, 0.76, 0.005);
  EXPECT_EQ(coarse.steps.position.unit, "rad");
  EXPECT_EQ(coarse.steps.position.knot, 149);
  expect_words(coarse.steps.warning(), {"1 s", "move, knot 149", "0.76 rad", "'joint_4'"});
}

TEST_F(ProblemSteps, SuggestedSteps_AreFineEnough) {
  for (const char* integrator : {"semi_implicit_euler", "runge_kutta_4"}) {
    const SolveResult coarse = solve(reaching(0.5, 3, integrator));
    ASSERT_TRUE(coarse.steps.coarse) << integrator;
    const double step = coarse.steps.sufficient_step;
    ASSERT_GT(step, 0.0);
    const int knots = static_cast<int>(std::ceil(1.5 / step));
    const SolveResult fine = solve(reaching(1.5 / knots, knots, integrator));
    EXPECT_EQ(fine.summary.reason, StopReason::Converged);
    EXPECT_FALSE(fine.steps.coarse) << fine.steps.warning();
  }
}

/// Returns a problem in which the tip goes up a board of 30 degrees within a band of forces;
/// `friction` is added to the contact.
std::string on_a_board(const std::string& friction, const std::string& integrator) {
  return arm +
         "start: {posture: ready}\n"
         "contacts:\n"
         "  pad: {tool: tool, reference: {surface: {normal: [-0.5, 0, 0.8660254]}},\n"
         "    directions: z, kd: 40" +
         friction +
         "}\n"
         "terms:\n"
         "  posture: {type: state}\n"
         "  torque: {type: control, target: {hold: {pad: 15}}}\n"
         "  along: {type: frame_position, frame: tool, axes: {normal: [-0.5, 0, 0.8660254]},\n"
         "    target: {line: {from: here, to: {here: [0.11547, 0, 0]}, start: 0.2, "
         "duration: 1.5}}, weights: [1, 1, 0]}\n"
         "  force: {type: contact_force, contact: pad,\n"
         "    target: {sine: {center: 15, amplitude: 3, rate: 6.28}}}\n"
         "stages:\n"
         "  press:\n"
         "    contacts: [pad]\n"
         "    step: 0.01\n"
         "    integrator: " +
         integrator +
         "\n"
         "    costs: {posture: 0.1, torque: 1e-4, along: 1e4, force: 1}\n"
         "    constraints:\n"
         "      band: {type: contact_force, contact: pad, lower: 13, upper: 17}\n"
         "horizon: [press: 200]\n"
         "terminal: {posture: 0.1, along: 1e3}\n"
         "solver: {max_iterations: 200}\n";
}

class FrictionOnABoard : public ProblemSteps, public ::testing::WithParamInterface<const char*> {};

TEST_P(FrictionOnABoard, DefaultSpeed_ConvergesLikeAFrictionlessContact) {
  const SolveResult smooth = solve(on_a_board("", GetParam()));
  const SolveResult rough = solve(on_a_board(", friction: {coefficient: 0.3}", GetParam()), true);
  ASSERT_EQ(smooth.summary.reason, StopReason::Converged);
  EXPECT_EQ(rough.summary.reason, StopReason::Converged);
  EXPECT_LE(rough.summary.iterations, smooth.summary.iterations + 2);
  EXPECT_NEAR(rough.summary.cost, smooth.summary.cost, 0.1 * smooth.summary.cost);
  EXPECT_FALSE(rough.steps.coarse) << rough.steps.warning();
  EXPECT_EQ(rough.complaints, std::vector<std::string>{});
  EXPECT_TRUE(rough.derivatives);
}

TEST_P(FrictionOnABoard, SpeedTooSmallForTheStep_IsReported) {
  const SolveResult steep =
      solve(on_a_board(", friction: {coefficient: 0.3, speed: 0.01}", GetParam()));
  ASSERT_EQ(steep.complaints.size(), 1U);
  expect_words(steep.complaints[0], {"stage 'press'", "contact 'pad'", "0.01 m/s", "at least"});
}

INSTANTIATE_TEST_SUITE_P(Integrators, FrictionOnABoard,
                         ::testing::Values("semi_implicit_euler", "runge_kutta_4"),
                         [](const auto& named) { return std::string(named.param); });

}  // namespace
}  // namespace burnish::testing
