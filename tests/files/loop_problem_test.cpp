// Tests of problems of robots with loops: every knot closes the loops, starts are consistent, and
// hinges without motors have no control.
#include <gtest/gtest.h>

#include "burnish/contact/loops.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/problem_files.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

ProblemFile example(const std::string& name) {
  return read_problem_file(fs::path(BURNISH_ROBOTS_DIR).parent_path() / "examples/problems" /
                           (name + ".yaml"));
}

class LoopExample : public ::testing::TestWithParam<std::string> {};

TEST_P(LoopExample, Solution_ClosesLoopsWithinATenthOfAMillimetre) {
  const ProblemFile file = example(GetParam());
  Problem problem(file.spec);
  DdpSolver solver(problem, file.solver);
  EXPECT_EQ(solver.solve().reason, StopReason::Converged);
  const RowMatrix xs = solver.xs();
  const Model& model = problem.model();
  double worst = 0.0, moved = 0.0;
  for (Eigen::Index k = 0; k < xs.rows(); ++k) {
    const Eigen::VectorXd q = xs.row(k).head(model.nq);
    for (const LoopMiss& miss : loop_misses(model, q))
      worst = std::max({worst, miss.translation, miss.rotation});
    moved = std::max(moved, (q - xs.row(0).head(model.nq).transpose()).cwiseAbs().maxCoeff());
  }
  RecordProperty("worst_m", std::to_string(worst));
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(moved, 0.2) << "the robot must move";
}

TEST_P(LoopExample, Start_IsClosedAndOnlyMotorsHaveControls) {
  const ProblemFile file = example(GetParam());
  const Problem problem(file.spec);
  const Model& model = problem.model();
  for (const LoopMiss& miss : loop_misses(model, file.spec.initial_state.head(model.nq)))
    EXPECT_LT(miss.translation, 1e-8);
  for (const std::string& name : problem.control_names()) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.joint_index(name))];
    EXPECT_GT(model.effort_limit[joint.v_index], 0.0) << name;
  }
  for (const Stage& stage : problem.spec().stages)
    for (const Loop& loop : model.loops)
      EXPECT_NE(std::find(stage.contacts.begin(), stage.contacts.end(), loop.name),
                stage.contacts.end());
}

INSTANTIATE_TEST_SUITE_P(robots, LoopExample,
                         ::testing::Values("four_bar", "parallel_ankle", "gripper"),
                         [](const auto& test) { return test.param; });

class LoopProblemFiles : public ProblemFiles {
 protected:
  static std::string bars(const std::string& start, const std::string& more = "") {
    return "robot: " BURNISH_ROBOTS_DIR "/four_bar\n" + start +
           "stages: {swing: {step: 0.02, costs: {effort: {type: control}}}}\n"
           "horizon: [swing: 3]\n" +
           more;
  }
};

TEST_F(LoopProblemFiles, StartOfOneJoint_IsCompletedToAConsistentStart) {
  const ProblemFile file = read(bars("start: {posture: {drive: 1.1}, velocity: {drive: 2}}\n"));
  const Model& model = file.spec.model;
  const Eigen::VectorXd q = file.spec.initial_state.head(model.nq);
  EXPECT_EQ(q[model.joints[model.joint_index("drive")].q_index], 1.1);
  EXPECT_LT(loop_misses(model, q)[0].translation, 1e-8);
  const Eigen::VectorXd v = file.spec.initial_state.segment(model.nq, model.nv);
  EXPECT_NEAR(v[model.joints[model.joint_index("drive")].v_index], 2.0, 1e-9);
  EXPECT_LT((project_velocity_onto_loops(model, q, v) - v).norm(), 1e-9);
  EXPECT_GT(v.cwiseAbs().minCoeff(), 1e-3) << "every bar must move";
}

TEST_F(LoopProblemFiles, StartWithAnOpenLoop_IsRefused) {
  expect_words(refusal([&] { read(bars("start: {q: [0.8, 0.1, 1.2]}\n")); }),
               {"initial_state", "loop 'pin'", "mm", "project_onto_loops"});
}

TEST_F(LoopProblemFiles, LoopGains_FollowFromTheStepUnlessStated) {
  const ProblemFile file = read(bars(""));
  ASSERT_EQ(file.spec.contacts.size(), 1U);
  EXPECT_EQ(file.spec.contacts[0].name, "pin");
  EXPECT_NEAR(file.spec.contacts[0].kd[0], 50.0, 1e-9);
  const ProblemFile own =
      read(bars("contacts: {pin: {tool: pin/second, base: pin/first, reference: surface, "
                "directions: [x, z], kp: 100, kd: 20, target: {}}}\n"));
  ASSERT_EQ(own.spec.contacts.size(), 1U);
  EXPECT_EQ(own.spec.contacts[0].kp[0], 100.0);
  EXPECT_EQ(own.spec.stages[0].contacts, std::vector<std::string>{"pin"});
}

}  // namespace
}  // namespace burnish::testing
