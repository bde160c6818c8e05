// Tests of constraint curvatures: they equal the second derivatives of their rows, reduce the
// number of iterations, and leave the solution unchanged.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "burnish/solver/ddp.hpp"
#include "support/ocp_cases.hpp"

namespace burnish::test {
namespace {

constexpr int reach_knots = 40;
Eigen::VectorXd one(double x) { return Eigen::VectorXd::Constant(1, x); }

/// Robot of three prismatic joints: positions and forces are linear in the state and the controls.
Model gantry() {
  std::mt19937_64 generator(4);
  TreeSpec tree;
  tree.name = "gantry";
  tree.links.push_back({"root", testing::random_inertia(generator), {}});
  std::string parent = "root";
  for (int i = 0; i < 3; ++i) {
    const std::string link = i == 2 ? "tool" : "slide_" + std::to_string(i);
    tree.joints.push_back(
        testing::joint("to_" + link, JointType::Prismatic, parent, link, Eigen::Vector3d::Unit(i)));
    tree.joints.back().effort_limit = 200.0;
    tree.links.push_back({link, testing::random_inertia(generator), {}});
    parent = link;
  }
  return build_model(tree);
}

/// Problem with the smallest regular costs.
ProblemSpec gantry_problem(const std::vector<Constraint>& constraints) {
  ProblemSpec spec{.model = gantry()};
  spec.initial_state = Eigen::VectorXd::Zero(6);
  Stage go{.name = "go",
           .costs = {{.residual = residual::State{}, .weight = 0.3},
                     {.residual = residual::Control{}, .weight = 1e-4}},
           .constraints = constraints};
  go.step = 0.02;
  spec.stages = {go};
  spec.horizon = {{"go", reach_knots}};
  return spec;
}

/// Returns the largest deviation of the curvatures of a knot from finite differences of the row
/// derivatives.
double error_of_curvatures(Problem& problem, int knot) {
  std::mt19937_64 generator(9);
  OcpHorizon at(problem, generator);
  at.expand(problem);
  const auto k = static_cast<std::size_t>(knot);
  const StateLayout& layout = problem.layout();
  const RowMatrix curvatures = at.curvatures[k];
  const double h = 1e-5;
  double largest = 0.0;
  for (int c = 0; c < layout.nz(); ++c) {
    double& entry = c < layout.nu ? at.u[k * static_cast<std::size_t>(layout.nu) + c]
                                  : at.x[k * static_cast<std::size_t>(layout.nx()) + c - layout.nu];
    const double middle = entry;
    entry = middle + h;
    at.expand(problem);
    RowMatrix change = at.rows[k];
    entry = middle - h;
    at.expand(problem);
    change = (change - at.rows[k]) / (2.0 * h);
    entry = middle;
    for (const RowCurvature& curvature : problem.row_curvatures(knot)) {
      const auto b = curvatures.middleRows(curvature.first, curvature.count);
      const Eigen::VectorXd claimed = curvature.sign * (b.transpose() * b.col(c));
      largest = std::max(largest,
                         (claimed - change.row(curvature.row).transpose()).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

TEST(Curvatures, LinearPositions_CurvaturesEqualSecondDerivatives) {
  const Eigen::Matrix3d tilted =
      Reference::surface_with_normal(Eigen::Vector3d(0.2, -1.0, 0.5)).rotation;
  const Eigen::Vector3d centre(0.4, -0.7, 1.5);
  ProblemSpec spec = gantry_problem(
      {{.name = "ball", .residual = residual::FrameDistance{"tool", centre}, .upper = one(0.1)},
       {.name = "tube",
        .residual = residual::FrameDistance{"tool", centre, Directions::x() | Directions::z(),
                                            Reference::world(tilted)},
        .upper = one(0.1)},
       {.name = "grip", .residual = residual::FrictionCone{"hold", 0.4}}});
  ContactSpec hold{.name = "hold",
                   .tool = "tool",
                   .directions = Directions::linear(),
                   .target = frame_placement(spec.model, Eigen::VectorXd::Zero(3), "tool")};
  hold.with_gains(0.0, 5.0);
  spec.contacts = {hold};
  spec.stages[0].contacts = {"hold"};
  Problem problem(spec);
  ASSERT_EQ(problem.row_curvatures(0).size(), 3U);
  EXPECT_EQ(problem.max_curvatures(), 5);
  for (const int knot : {0, 1, reach_knots - 1})
    EXPECT_LE(error_of_curvatures(problem, knot), 1e-5) << knot;
}

TEST(Curvatures, LowerDistanceLimitAndPlane_HaveNoCurvature) {
  const Eigen::Vector3d centre(1.0, 1.0, 1.0);
  const Problem problem(gantry_problem(
      {{.name = "clear", .residual = residual::FrameDistance{"tool", centre}, .lower = one(0.1)},
       {.name = "plane",
        .residual = residual::FrameDistance{"tool", centre, Directions::x()},
        .upper = one(2.0)}}));
  EXPECT_EQ(problem.max_curvatures(), 0);
  EXPECT_TRUE(problem.row_curvatures(0).empty());
}

/// Same row as FrameDistance, but without curvature.
struct PlainDistance {
  Eigen::Vector3d centre;
  int rows = 1;
  std::string name = "distance";
  std::vector<std::string> frames = {"tool"};
  double length(const Eigen::Vector3d& p) const {
    return std::sqrt((p - centre).squaredNorm() + 1e-12);
  }
  void value(const NodeView& at, Eigen::Ref<Eigen::VectorXd> r) const {
    r[0] = length(at.placement(0).translation());
  }
  void jacobian(const NodeView& at, Eigen::Ref<RowMatrix> J) const {
    const Eigen::Vector3d p = at.placement(0).translation();
    J.middleCols(at.layout().column_q(), at.layout().nv) =
        (p - centre).transpose() / length(p) * at.jacobian(0, Reference::centered()).topRows(3);
  }
};

/// Problem with a goal 20 cm outside the sphere in which the tool must stay.
ProblemSpec reach_beyond_sphere(Model model, const Eigen::VectorXd& q, double radius,
                                bool with_curvatures,
                                double l1_weight = std::numeric_limits<double>::infinity()) {
  const Eigen::Vector3d start = frame_placement(model, q, "tool").translation();
  ProblemSpec spec = gantry_problem({});
  spec.model = model;
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
  spec.initial_state.head(model.nq) = q;
  Residual inside = residual::FrameDistance{"tool", start};
  if (!with_curvatures) inside = residual::custom(PlainDistance{start});
  const Eigen::Vector3d goal = start + Eigen::Vector3d(-0.1, 0.15, -0.1);
  spec.terminal = {{.residual = residual::FramePosition{"tool", goal}, .weight = 10.0}};
  spec.stages[0].costs.push_back(spec.terminal[0]);
  const Constraint stay{.name = "stay",
                        .residual = inside,
                        .upper = one(radius),
                        .scale = one(radius),
                        .l1_weight = l1_weight};
  spec.stages[0].constraints = spec.terminal_constraints = {stay};
  return spec;
}

class ConstrainedReach : public ::testing::TestWithParam<StepUpdate> {
 protected:
  DdpSolver solved(Problem& problem, double tolerance = 1e-9, int threads = 1) const {
    DdpOptions options{.update = GetParam(), .max_iterations = 400, .threads = threads};
    options.stop_tolerance = tolerance;
    options.limits.tolerance = std::max(10.0 * tolerance, 1e-13);
    DdpSolver solver(problem, options);
    const Eigen::VectorXd start =
        Eigen::Map<const Eigen::VectorXd>(problem.initial_state(), problem.state().nx);
    const Eigen::VectorXd hold = problem.quasi_static(0, start).control;
    solver.set_guess(start.transpose().replicate(reach_knots + 1, 1),
                     hold.transpose().replicate(reach_knots, 1));
    solver.solve();
    EXPECT_EQ(solver.summary().reason, StopReason::Converged) << solver.text();
    return solver;
  }
  Model arm7 = named_robot("arm7");
  Eigen::VectorXd q = (Eigen::VectorXd(7) << 0.1, 0.4, 0.0, -1.6, 0.0, 0.8, 0.0).finished();
};

TEST_P(ConstrainedReach, ToolInASmallSphere_ConvergesInFewIterations) {
  for (const double l1_weight : {std::numeric_limits<double>::infinity(), 0.2}) {
    Problem problem(reach_beyond_sphere(arm7, q, 0.02, true, l1_weight));
    DdpSolver solver = solved(problem);
    EXPECT_LE(solver.summary().iterations, 40) << l1_weight;
    EXPECT_GT(solver.summary().active_constraints, reach_knots / 2) << l1_weight;
    EXPECT_LE(solver.optimality_error(), 1e-4) << l1_weight;
  }
}

TEST_P(ConstrainedReach, Curvature_LeavesTheSolutionAndSavesIterations) {
  const Eigen::VectorXd middle = Eigen::VectorXd::Zero(3);
  Problem has_curvature(reach_beyond_sphere(gantry(), middle, 0.1, true));
  Problem without_curvature(reach_beyond_sphere(gantry(), middle, 0.1, false));
  EXPECT_EQ(without_curvature.max_curvatures(), 0);
  const DdpSolver curved = solved(has_curvature, 1e-15), plain = solved(without_curvature, 1e-15);
  const RowMatrix difference = curved.xs() - plain.xs();
  EXPECT_LE(difference.leftCols(3).cwiseAbs().maxCoeff(), 1e-8) << "positions [m]";
  EXPECT_LE(difference.rightCols(3).cwiseAbs().maxCoeff(), 1e-7) << "velocities [m/s]";
  EXPECT_LT(2 * curved.summary().iterations, plain.summary().iterations);
}

TEST_P(ConstrainedReach, AnyNumberOfThreads_GivesTheSameBits) {
  Problem problem(reach_beyond_sphere(arm7, q, 0.02, true));
  const DdpSolver single = solved(problem), parallel = solved(problem, 1e-9, 2);
  EXPECT_EQ(single.xs(), parallel.xs());
  EXPECT_EQ(single.us(), parallel.us());
  EXPECT_EQ(single.summary().iterations, parallel.summary().iterations);
}

INSTANTIATE_TEST_SUITE_P(Updates, ConstrainedReach,
                         ::testing::Values(StepUpdate::Rollout, StepUpdate::MultipleShooting),
                         [](const auto& update) {
                           return update.param == StepUpdate::Rollout ? "rollout" : "shooting";
                         });

}  // namespace
}  // namespace burnish::test
