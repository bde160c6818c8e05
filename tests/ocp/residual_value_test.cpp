// Tests of values of residuals that follow by hand, and of their limit cases.
#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "support/ocp_cases.hpp"

namespace burnish::test {
namespace {

/// A problem with one term, of a resting arm without contacts.
class ResidualValue : public ::testing::Test {
 protected:
  Problem with(const Residual& residual) {
    ProblemSpec spec{.model = model};
    spec.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
    spec.initial_state.head(model.nq) = q;
    spec.stages = {{.name = "go", .costs = {{.residual = residual}}}};
    spec.horizon = {{"go", 1}};
    return Problem(spec);
  }
  double value(const Residual& residual) {
    Problem problem = with(residual);
    return problem.residual(0, 0, problem.spec().initial_state, Eigen::VectorXd::Zero(model.nv))[0];
  }
  RowMatrix derivative(const Residual& residual) {
    Problem problem = with(residual);
    return problem.residual_derivative(0, 0, problem.spec().initial_state,
                                       Eigen::VectorXd::Zero(model.nv));
  }

  Model model = arm.robot.model();
  std::mt19937_64 generator{3};
  Eigen::VectorXd q = random_state(model, generator).q;
  Eigen::Vector3d tool = frame_placement(model, q, "tool").translation();
};

TEST_F(ResidualValue, TorqueRate_EqualsTheChangeOverAShortStep) {
  const double step = 1e-7;
  ProblemSpec spec{.model = model};
  spec.torque_model = TorqueModel{.cutoff = 40.0};
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + 2 * model.nv);
  spec.initial_state.head(model.nq) = q;
  spec.initial_state.tail(model.nv) = uniform(model.nv, 5.0, generator);
  spec.stages = {{.name = "go",
                  .costs = {{.residual = residual::JointTorqueRate{{"joint_3", "joint_1"}}}},
                  .step = step}};
  spec.horizon = {{"go", 1}};
  Problem problem(spec);
  const Eigen::VectorXd x = spec.initial_state, u = uniform(model.nv, 5.0, generator);
  Eigen::VectorXd next(x.size());
  problem.roll(0, 0, x.data(), u.data(), next.data());
  const Eigen::VectorXd rate = (next - x).tail(model.nv) / step, r = problem.residual(0, 0, x, u);
  EXPECT_NEAR(r[0], rate[2], 1e-4 * std::abs(rate[2]));
  EXPECT_NEAR(r[1], rate[0], 1e-4 * std::abs(rate[0]));
}

TEST_F(ResidualValue, TorqueRateOfTorqueStates_IsTheChangePerStep) {
  ProblemSpec spec{.model = model};
  spec.torque_model = TorqueModel::held();
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + 2 * model.nv);
  spec.initial_state.head(model.nq) = q;
  spec.initial_state.tail(model.nv) = uniform(model.nv, 5.0, generator);
  spec.stages = {{.name = "go",
                  .costs = {{.residual = residual::JointTorqueRate{{"joint_3", "joint_1"}}}},
                  .step = 0.02}};
  spec.horizon = {{"go", 1}};
  Problem problem(spec);
  const Eigen::VectorXd x = spec.initial_state, u = uniform(model.nv, 5.0, generator);
  const Eigen::VectorXd r = problem.residual(0, 0, x, u), before = x.tail(model.nv);
  EXPECT_NEAR(r[0], (u[2] - before[2]) / 0.02, 1e-10);
  EXPECT_NEAR(r[1], (u[0] - before[0]) / 0.02, 1e-10);
}

TEST_F(ResidualValue, ForceRate_IsTheChangeOfForcePerStep) {
  const OcpCase test{arm.robot, false, false, true};
  ProblemSpec spec = bare_problem(test, model);
  spec.stages = {{.name = "go",
                  .contacts = {"pad"},
                  .costs = {{.residual = residual::ContactForceRate{"pad", 2.0}}},
                  .step = 0.02}};
  spec.horizon = {{"go", 1}};
  Problem problem(spec);
  const OcpState at = random_ocp_state(problem, generator);
  const Eigen::VectorXd f = problem.forces(0, at.x, at.u);
  const Eigen::VectorXd wanted = ((f - at.x.segment(14, 6)) / 0.02).array() - 2.0;
  EXPECT_LT((problem.residual(0, 0, at.x, at.u) - wanted).norm(), 1e-9 * wanted.norm());
}

/// Problems with a friction cone and a pyramid of 3 to 6 sides, at random forces.
class FrictionPyramid : public ::testing::TestWithParam<int> {
 protected:
  static Constraint margin(const std::string& name, int sides) {
    return {.name = name,
            .residual = residual::FrictionCone{
                .contact = "pad", .friction = 0.6, .normal = 1, .sides = sides}};
  }
  Problem problem() {
    ProblemSpec spec = bare_problem(OcpCase{arm.robot, false}, model);
    spec.stages = {{.name = "go",
                    .contacts = {"pad"},
                    .costs = {{.residual = residual::Control{}}},
                    .constraints = {margin("cone", 0), margin("pyramid", GetParam())}}};
    spec.horizon = {{"go", 1}};
    return Problem(spec);
  }
  Model model = arm.robot.model();
  std::mt19937_64 generator{4};
};

TEST_P(FrictionPyramid, Pyramid_IsInsideTheConeAndTouchesItAtEdges) {
  Problem made = problem();
  const int n = GetParam();
  for (int draw = 0; draw < 50; ++draw) {
    const OcpState at = random_ocp_state(made, generator);
    const Eigen::VectorXd force = made.forces(0, at.x, at.u);
    const std::vector<double> rows = made.row_values(0, at.x.data(), at.u.data());
    const double normal = force[1], across = std::hypot(force[2], force[0]);
    const double angle = std::atan2(force[0], force[2]);  // from z to x, which follow y
    double min_margin = 1e9;
    for (int i = 0; i < n; ++i) {
      const double side = 2.0 * M_PI * i / n;
      EXPECT_NEAR(rows[2 + i], 0.6 * std::cos(M_PI / n) * normal - across * std::cos(angle - side),
                  1e-9);
      min_margin = std::min(min_margin, rows[2 + i]);
    }
    // The pyramid lies inside the cone: farthest at the middle of a side, not at all at an edge.
    const double from_middle = std::remainder(angle, 2.0 * M_PI / n);
    const double reach = 0.6 * normal * std::cos(M_PI / n) / std::cos(from_middle);
    EXPECT_EQ(min_margin >= 0.0, across <= reach) << across << " N of " << reach;
    EXPECT_LE(reach, 0.6 * std::abs(normal) * (1.0 + 1e-12));
    if (min_margin >= 0.0) {
      EXPECT_GE(rows[0], -1e-3) << "the cone is smoothed over 1e-3 N";
      EXPECT_GE(rows[1], 0.0) << "a pulling force must be outside the pyramid";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sides, FrictionPyramid, ::testing::Values(3, 4, 5, 6));

/// The rows of a sole's pressure and yaw friction, as a linear map of the wrench in tool axes.
class SoleWrench : public ::testing::Test {
 protected:
  static constexpr double x = 0.1, y = 0.06, mu = 0.4;

  void SetUp() override {
    constexpr int draws = 60;
    Eigen::MatrixXd wrenches(6, draws), rows(12, draws);
    const Model model = arm.robot.model();
    ProblemSpec spec = bare_problem(OcpCase{arm.robot, false}, model);
    spec.stages = {{.name = "go",
                    .contacts = {"pad"},
                    .costs = {{.residual = residual::Control{}}},
                    .constraints = {{.name = "wrench",
                                     .residual = residual::ContactForce{"pad", Reference::local()},
                                     .lower = Eigen::VectorXd::Constant(6, -1e9)},
                                    {.name = "sole",
                                     .residual = residual::CenterOfPressure{"pad", x, y, mu}}}}};
    spec.horizon = {{"go", 1}};
    Problem made(spec);
    std::mt19937_64 generator{5};
    for (int i = 0; i < draws; ++i) {
      const OcpState at = random_ocp_state(made, generator);
      const std::vector<double> values = made.row_values(0, at.x.data(), at.u.data());
      wrenches.col(i) = Eigen::Map<const Eigen::VectorXd>(values.data(), 6);
      rows.col(i) = Eigen::Map<const Eigen::VectorXd>(values.data() + 6, 12);
    }
    map = wrenches.transpose().colPivHouseholderQr().solve(rows.transpose()).transpose();
    ASSERT_LT((map * wrenches - rows).norm(), 1e-9 * rows.norm());
  }
  /// Returns the wrenches of each corner with 1 N along the normal and full friction along x and y.
  static Eigen::Matrix<double, 6, 16> corners() {
    Eigen::Matrix<double, 6, 16> edges;
    int i = 0;
    for (const double px : {x, -x})
      for (const double py : {y, -y})
        for (const double fx : {mu, -mu})
          for (const double fy : {mu, -mu}) {
            const Eigen::Vector3d p(px, py, 0.0), f(fx, fy, 1.0);
            edges.col(i++) << f, p.cross(f);
          }
    return edges;
  }
  /// Returns the distance of a wrench from the cone of all sums of corner wrenches.
  static double distance_from_cone(const Eigen::VectorXd& wrench) {
    const auto edges = corners();
    Eigen::VectorXd pressed = Eigen::VectorXd::Zero(16), left = wrench;
    for (int sweep = 0; sweep < 20000; ++sweep)
      for (int i = 0; i < 16; ++i) {
        const double step =
            std::max(-pressed[i], edges.col(i).dot(left) / edges.col(i).squaredNorm());
        pressed[i] += step;
        left -= step * edges.col(i);
      }
    return left.norm();
  }
  Eigen::MatrixXd map;  ///< 12 x 6
};

TEST_F(SoleWrench, CornerWrenches_LieOnTheEdges) {
  const auto edges = corners();
  for (int i = 0; i < edges.cols(); ++i) {
    const Eigen::VectorXd margin = map * edges.col(i);
    EXPECT_GE(margin.minCoeff(), -1e-12) << i;
    EXPECT_GE((margin.array().abs() < 1e-12).count(), 4) << "a corner lies on several edges";
  }
}

TEST_F(SoleWrench, Rows_AdmitExactlyTheSumsOfCornerWrenches) {
  std::mt19937_64 generator{6};
  int inside = 0, outside = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const Eigen::VectorXd a = uniform(6, 1.0, generator);
    Eigen::VectorXd wrench(6);
    wrench << 0.5 * mu * a[0], 0.5 * mu * a[1], 1.0, 0.9 * y * a[3], 0.9 * x * a[4], 0.06 * a[5];
    const double margin = (map * wrench).minCoeff();
    if (std::abs(margin) < 1e-3) continue;  // the sweeps are not accurate enough there
    const double left = distance_from_cone(wrench);
    if (margin > 0.0) {
      ++inside;
      EXPECT_LT(left, 1e-4) << wrench.transpose();
    } else {
      ++outside;
      EXPECT_GT(left, 2e-4) << wrench.transpose();
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 50);
}

TEST_F(ResidualValue, FrictionAsATarget_ChangesTheRowsOfAKnot) {
  for (const int sides : {0, 4}) {
    ProblemSpec spec = bare_problem(OcpCase{arm.robot, false}, model);
    spec.stages = {
        {.name = "go",
         .contacts = {"pad"},
         .costs = {{.residual = residual::Control{}}},
         .constraints = {
             {.name = "cone",
              .residual =
                  residual::FrictionCone{.contact = "pad", .friction = 0.5, .sides = sides}},
             {.name = "sole",
              .residual = residual::CenterOfPressure{.contact = "pad", .friction = 0.5}}}}};
    spec.horizon = {{"go", 1}};
    Problem given(spec);
    for (Constraint& constraint : spec.stages[0].constraints) {
      if (auto* cone = std::get_if<residual::FrictionCone>(&constraint.residual))
        cone->friction = 0.1;
      if (auto* sole = std::get_if<residual::CenterOfPressure>(&constraint.residual))
        sole->friction = 0.1;
    }
    Problem slippery(spec);
    const OcpState at = random_ocp_state(given, generator);
    const Eigen::VectorXd friction = Eigen::VectorXd::Constant(1, 0.1);
    for (const char* term : {"cone", "sole"})
      EXPECT_EQ(given.set_target(0, given.term_index(0, term), friction), Status::Ok);
    EXPECT_EQ(given.row_values(0, at.x.data(), at.u.data()),
              slippery.row_values(0, at.x.data(), at.u.data()));
  }
}

TEST_F(ResidualValue, SupportMargins_AreInwardDistancesFromTheEdges) {
  const auto at = [&](const Residual& residual) {
    Problem problem = with(residual);
    return problem.residual(0, 0, problem.spec().initial_state, Eigen::VectorXd::Zero(model.nv));
  };
  const Eigen::Vector2d c = at(residual::CenterOfMass{Eigen::Vector3d(0.0, 0.0, 0.0)}).head<2>();
  const auto corner = [&](double x, double y) { return Eigen::Vector2d(c.x() + x, c.y() + y); };
  const residual::SupportMargin around{
      {corner(-0.1, -0.2), corner(0.3, -0.2), corner(0.3, 0.4), corner(-0.1, 0.4)}};
  EXPECT_LT((at(around) - Eigen::Vector4d(0.2, 0.3, 0.4, 0.1)).norm(), 1e-12);
  const residual::SupportMargin beside{{corner(0.1, 0.0), corner(1.1, 0.0), corner(0.1, 1.0)}};
  EXPECT_LT((at(beside) - Eigen::Vector3d(0.0, 1.1 * M_SQRT1_2, -0.1)).norm(), 1e-12);
}

TEST_F(ResidualValue, SupportMargins_HaveALowerLimitOfZeroByDefault) {
  ProblemSpec spec{.model = model};
  spec.initial_state = Eigen::VectorXd::Zero(model.nq + model.nv);
  spec.stages = {{.name = "go", .costs = {{.residual = residual::Control{}}}}};
  spec.stages[0].constraints = {
      {"balance", residual::SupportMargin{{{0.0, 0.0}, {0.4, 0.0}, {0.4, 0.6}, {0.0, 0.6}}}}};
  spec.horizon = {{"go", 1}};
  const Problem problem(spec);
  const std::vector<std::string> names{"balance/edge_0", "balance/edge_1", "balance/edge_2",
                                       "balance/edge_3"};
  EXPECT_EQ(problem.row_names(0), names);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(problem.row_lower(0)[i], 0.0);
    EXPECT_TRUE(std::isinf(problem.row_upper(0)[i]));
    EXPECT_NEAR(problem.row_scale(0)[i], i % 2 == 0 ? 0.3 : 0.2, 1e-12) << "half of the width";
  }
}

TEST_F(ResidualValue, Distance_IsFromAPointALineOrAPlane) {
  using residual::FrameDistance;
  const Eigen::Vector3d away(0.3, -0.4, 1.2), point = tool - away;
  EXPECT_NEAR(value(FrameDistance{"tool", point}), 1.3, 1e-9);
  EXPECT_NEAR(value(FrameDistance{"tool", point, Directions::x() | Directions::y()}), 0.5, 1e-9);
  EXPECT_NEAR(value(FrameDistance{"tool", point, Directions::y()}), 0.4, 1e-9);
  const Eigen::Matrix3d R = tilt();
  const Eigen::Vector2d across(R.col(1).dot(away), R.col(2).dot(away));
  EXPECT_NEAR(
      value(FrameDistance{"tool", point, Directions::y() | Directions::z(), Reference::world(R)}),
      across.norm(), 1e-9);
}

TEST_F(ResidualValue, DistanceWithoutATarget_IsFromTheOriginOfTheReference) {
  const Eigen::Vector3d other = frame_placement(model, q, "link_3").translation();
  EXPECT_NEAR(value(residual::FrameDistance{"tool", {}, Directions::linear(), {"link_3"}}),
              (tool - other).norm(), 1e-9);
}

TEST_F(ResidualValue, ZeroDistance_HasAZeroDerivative) {
  const residual::FrameDistance zero{"tool", tool};
  EXPECT_NEAR(value(zero), 1e-6, 1e-9);
  EXPECT_LT(derivative(zero).cwiseAbs().maxCoeff(), 1e-6);
}

/// Lead and tilt incline the axis towards the first and the second tangent; spin has no effect.
TEST_F(ResidualValue, Inclination_IsLeadAndTiltFromTheNormal) {
  const Eigen::Vector3d center = tool - 0.4 * Eigen::Vector3d(0.3, -0.2, 1.0).normalized();
  const Reference on =
      Reference::on(Quadric::sphere(center, 0.4), center + Eigen::Vector3d(0, 0, 1),
                    Eigen::Vector3d(0.3, 1.0, 0.0));
  const Eigen::Matrix3d A = on.at(tool).rotation;
  EXPECT_LT((A.col(2) - (tool - center).normalized()).norm(), 1e-12);
  const Eigen::Matrix3d R = frame_placement(model, q, "tool").linear();
  const double lead = 0.4, tilt = -0.2;
  const Eigen::Vector3d axis =
      R.transpose() * A * Eigen::Vector3d(std::tan(lead), std::tan(tilt), 1.0);
  residual::FrameInclination inclination{"tool", on, 3.0 * axis};
  Problem problem = with(inclination);
  const auto values = [&](Problem& of, const Eigen::VectorXd& at) {
    Eigen::VectorXd x = of.spec().initial_state;
    x.head(model.nq) = at;
    return of.residual(0, 0, x, Eigen::VectorXd::Zero(model.nv));
  };
  EXPECT_LT((values(problem, q) - Eigen::Vector2d(lead, tilt)).norm(), 1e-12);
  inclination.target = Eigen::Vector2d(lead, tilt);
  EXPECT_NEAR(value(inclination), 0.0, 1e-12);
  // A rotation about the axis itself, here that of the last joint, changes neither angle.
  Eigen::VectorXd turned = q;
  turned[model.nq - 1] += 0.3;
  const Eigen::Matrix3d R2 = frame_placement(model, turned, "tool").linear();
  const Eigen::Vector3d own = Eigen::AngleAxisd(Eigen::Matrix3d(R.transpose() * R2)).axis();
  Problem spun = with(
      residual::FrameInclination{"tool", Reference::surface_with_normal({0.3, 0.1, 1.0}), own});
  EXPECT_LT((values(spun, turned) - values(spun, q)).norm(), 1e-9);
}

TEST_F(ResidualValue, Height_IsTheDistanceFromPlanesSpheresAndCylinders) {
  const Eigen::Vector3d up = Eigen::Vector3d(0.2, -0.4, 1.0).normalized(),
                        across = up.unitOrthogonal();
  for (const double height : {-0.1, 0.0, 0.05, 0.7}) {
    const auto above = [&](const Quadric& surface) {
      return value(residual::FrameHeight{"tool", Reference::on(surface, tool + 0.1 * up)});
    };
    EXPECT_NEAR(above(Quadric::plane(tool - height * up, 2.0 * up)), height, 1e-12);
    const Eigen::Vector3d middle = tool - (0.4 + height) * up;
    EXPECT_NEAR(above(Quadric::sphere(middle, 0.4)), height, 1e-12);
    EXPECT_NEAR(above(Quadric::cylinder(middle + 3.0 * across, across, 0.4)), height, 1e-12);
    const Eigen::Vector3d inside = tool + (0.9 - height) * up;
    EXPECT_NEAR(above(Quadric::sphere(inside, 0.9, true)), height, 1e-12);
  }
  // Along its axis, an ellipsoid has the exact height. Far aside the value only grows.
  const Quadric egg =
      Quadric::ellipsoid(tool - 0.5 * up, Eigen::Matrix3d::Identity(), {0.3, 0.3, 0.3});
  EXPECT_NEAR(value(residual::FrameHeight{"tool", Reference::on(egg, tool)}), 0.2, 1e-12);
  const Quadric needle = Quadric::ellipsoid(tool - Eigen::Vector3d(2.0, 2.0, 0.0),
                                            Eigen::Matrix3d::Identity(), {1.0, 0.01, 1.0});
  const double far = value(residual::FrameHeight{"tool", Reference::on(needle, tool)});
  EXPECT_TRUE(std::isfinite(far));
  EXPECT_GT(far, 0.5);
}

/// The rotation is relative to the surface's axes at the tool, which turn when the tool moves.
TEST_F(ResidualValue, RotationAgainstASurface_UsesItsAxesAtTheTool) {
  const Eigen::Vector3d center = tool - 0.4 * Eigen::Vector3d(0.3, -0.2, 1.0).normalized();
  const Reference on =
      Reference::on(Quadric::sphere(center, 0.4), center + Eigen::Vector3d(0, 0, 1));
  const Eigen::Matrix3d R = frame_placement(model, q, "tool").linear();
  const Eigen::Matrix3d relative = on.at(tool).rotation.transpose() * R;
  const Eigen::Vector4d same = Eigen::Quaterniond(relative).coeffs();
  Problem problem = with(residual::FrameRotation{"tool", same, on});
  const Eigen::VectorXd x = problem.spec().initial_state, none = Eigen::VectorXd::Zero(model.nv);
  EXPECT_LT(problem.residual(0, 0, x, none).norm(), 1e-7);
  Problem flat = with(residual::FrameRotation{"tool", same, on.at(tool)});
  EXPECT_LT(flat.residual(0, 0, x, none).norm(), 1e-7);
  // The curvature rotates the axes as the tool moves.
  EXPECT_GT(
      (problem.residual_derivative(0, 0, x, none) - flat.residual_derivative(0, 0, x, none)).norm(),
      0.1);
}

}  // namespace
}  // namespace burnish::test
