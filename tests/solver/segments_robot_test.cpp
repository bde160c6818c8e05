// Tests of the segmented recursion on robots: values, gains and directions equal a single sweep up
// to rounding.
#include <gtest/gtest.h>

#include "burnish/solver/ddp.hpp"
#include "polishing/reference_problem.hpp"
#include "support/pressing_arm.hpp"
#include "support/standing_problem.hpp"

namespace burnish::test {
namespace {

template <class A, class B>
double difference(const A& a, const B& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Expects the same single iteration from a guess near the solution, with and without segments.
void expect_same_iteration(const ProblemSpec& spec, int knots, int segments, double rounding) {
  Problem problem(spec);
  const int nx = problem.state().nx;
  const Eigen::Map<const Eigen::VectorXd> x0(problem.initial_state(), nx);
  const RowMatrix xs = x0.transpose().replicate(knots + 1, 1);
  const RowMatrix us = 0.9 * problem.quasi_static(0, x0).control.transpose().replicate(knots, 1);
  const auto iterate = [&](int count) {
    DdpSolver solver(
        problem, {.update = StepUpdate::MultipleShooting, .max_iterations = 1, .segments = count});
    solver.set_guess(xs, us);
    solver.solve();
    return solver;
  };
  const DdpSolver single = iterate(1);
  const DdpSolver segmented = iterate(segments);
  EXPECT_EQ(single.summary().regularization, 0.0);
  EXPECT_LT(difference(segmented.xs(), single.xs()), rounding);
  EXPECT_LT(difference(segmented.us(), single.us()), rounding);
  EXPECT_NE(RowMatrix(segmented.us()), RowMatrix(single.us())) << "the horizon must be split";
  for (int k = 0; k < knots; ++k) {
    EXPECT_LT(difference(segmented.gain(k), single.gain(k)), rounding) << k;
    EXPECT_LT(difference(segmented.value_hessian(k), single.value_hessian(k)), rounding) << k;
    EXPECT_LT(difference(segmented.value_gradient(k), single.value_gradient(k)), rounding) << k;
  }
}

TEST(SegmentedRobotProblem, PressingArm_EqualsASingleSweep) {
  const PressingArm arm = pressing_arm();
  for (const int knots : {100, 500})
    for (const int segments : {3, 9})
      expect_same_iteration(polishing::reference_problem(arm.model, "tool", arm.posture, knots),
                            knots, segments, 1e-8);
}

TEST(SegmentedRobotProblem, FilteredTorques_EqualASingleSweep) {
  const PressingArm arm = pressing_arm();
  ProblemSpec spec = polishing::reference_problem(arm.model, "tool", arm.posture, 100);
  spec.torque_model = TorqueModel{.cutoff = 100.0};
  const Eigen::Index nx = spec.initial_state.size();
  spec.initial_state.conservativeResize(nx + arm.model.nv);
  spec.initial_state.tail(arm.model.nv).setZero();
  expect_same_iteration(spec, 100, 5, 1e-8);
}

TEST(SegmentedRobotProblem, HumanoidOnTwoFeet_EqualsASingleSweep) {
#if BURNISH_HAS_ROBOTS
  const Robot robot = load_robot("talos");
  const Model& model = robot.model;
  const Eigen::VectorXd q0 = robot.posture("half_sitting");
#else
  const Model model = humanoid().model();
  const Eigen::VectorXd q0 = biped::half_sitting(model);
#endif
  const ProblemSpec spec = standing_problem(model, {"left_sole_link", "right_sole_link"}, q0, 60);
  expect_same_iteration(spec, 60, 4, 1e-7);
}

}  // namespace
}  // namespace burnish::test
