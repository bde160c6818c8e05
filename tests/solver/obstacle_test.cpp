// Obstacles as constraints on positions of a frame: an arm that reaches behind an obstacle stays on
// the allowed side and touches it.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/ocp/problem.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

class Obstacle : public ::testing::Test {
 protected:
  /// Positions of the tool at each knot of a reach to the goal within a limit.
  std::vector<Eigen::Vector3d> path(const Constraint& limit) {
    ProblemSpec spec{.model = model};
    spec.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
    spec.initial_state.head(model.nq) = q;
    const CostTerm reach{
        .name = "reach", .residual = residual::FramePosition{"tool", goal}, .weight = 100.0};
    Stage go{.name = "go",
             .costs = {{.residual = residual::State{}, .weight = 0.3},
                       {.residual = residual::Control{}, .weight = 1e-4},
                       reach},
             .constraints = {limit}};
    go.step = 0.02;
    spec.stages = {go};
    spec.horizon = {{"go", 40}};
    spec.terminal = {reach, {.residual = residual::State{}, .weight = 0.3}};
    spec.terminal_constraints = {limit};
    Problem problem(spec);
    DdpSolver solver(problem, {.update = StepUpdate::MultipleShooting, .max_iterations = 200});
    const Eigen::VectorXd hold = problem.quasi_static(0, spec.initial_state).control;
    solver.set_guess(spec.initial_state.transpose().replicate(41, 1),
                     hold.transpose().replicate(40, 1));
    EXPECT_EQ(solver.solve().reason, StopReason::Converged) << solver.text();
    std::vector<Eigen::Vector3d> result;
    for (int k = 0; k <= 40; ++k)
      result.emplace_back(
          frame_placement(model, solver.xs().row(k).head(model.nq).transpose(), "tool")
              .translation());
    return result;
  }
  /// The smallest margin along the path must be zero.
  static void expect_touched(const std::vector<Eigen::Vector3d>& path,
                             const std::function<double(const Eigen::Vector3d&)>& margin) {
    double min_margin = infinite;
    for (const Eigen::Vector3d& p : path) min_margin = std::min(min_margin, margin(p));
    EXPECT_GE(min_margin, -1e-8);
    EXPECT_LE(min_margin, 1e-6) << "the path must touch the obstacle";
  }

  Model model = named_robot("arm7");
  Eigen::VectorXd q = (Eigen::VectorXd(7) << 0.1, 0.4, 0.0, -1.6, 0.0, 0.8, 0.0).finished();
  Eigen::Vector3d start = frame_placement(model, q, "tool").translation();
  Eigen::Vector3d goal = start + Eigen::Vector3d(-0.1, 0.3, 0.1);
  Eigen::VectorXd one(double x) const { return Eigen::VectorXd::Constant(1, x); }
};

TEST_F(Obstacle, HalfSpaceByPositionInTiltedAxes_IsTouchedNotCrossed) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.2, -1.0, -0.3).normalized();
  const Eigen::Vector3d point = 0.5 * (start + goal);
  const Eigen::Matrix3d axes = Reference::surface_with_normal(normal).rotation;
  expect_touched(path({.name = "wall",
                       .residual = residual::FramePosition{"tool", point, Reference::world(axes)},
                       .lower = Eigen::Vector3d(-infinite, -infinite, 0.0),
                       .scale = one(0.1)}),
                 [&](const Eigen::Vector3d& p) { return normal.dot(p - point); });
}

TEST_F(Obstacle, SphereByDistanceFromAPoint_IsTouchedNotCrossed) {
  const Eigen::Vector3d centre = 0.5 * (start + goal) + Eigen::Vector3d(0.02, 0.0, 0.03);
  expect_touched(path({.name = "ball",
                       .residual = residual::FrameDistance{"tool", centre},
                       .lower = one(0.08)}),
                 [&](const Eigen::Vector3d& p) { return (p - centre).norm() - 0.08; });
}

TEST_F(Obstacle, CylinderByDistanceFromALine_IsTouchedNotCrossed) {
  const Eigen::Vector3d foot(0.5 * (start + goal).x() + 0.02, 0.5 * (start + goal).y(), 0.0);
  expect_touched(
      path({.name = "pillar",
            .residual = residual::FrameDistance{"tool", foot, Directions::x() | Directions::y()},
            .lower = one(0.06)}),
      [&](const Eigen::Vector3d& p) { return (p - foot).head<2>().norm() - 0.06; });
}

TEST_F(Obstacle, TubeByDistanceFromALine_IsTouchedNotLeft) {
  const Eigen::Vector3d along = (goal - start + Eigen::Vector3d(0.1, 0.0, 0.1)).normalized();
  const residual::FrameDistance across{
      "tool", start, Directions::x() | Directions::y(),
      Reference::world(Reference::surface_with_normal(along).rotation)};
  expect_touched(path({.name = "tube", .residual = across, .upper = one(0.05)}),
                 [&](const Eigen::Vector3d& p) { return 0.05 - along.cross(p - start).norm(); });
}

}  // namespace
}  // namespace burnish::test
