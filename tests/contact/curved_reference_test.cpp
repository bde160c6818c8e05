// Contacts whose axes follow a curved surface: the axes, their motion, and the constraint.
#include <gtest/gtest.h>

#include "support/contact_states.hpp"
#include "support/refusal.hpp"
#include "support/touch.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using testing::refusal;

TEST(Quadric, EveryShape_HasItsNormals) {
  const Vector3d center(0.1, -0.2, 0.3), axis = Vector3d(1.0, 2.0, -0.5).normalized();
  const Vector3d side = axis.unitOrthogonal();
  const Quadric ball = Quadric::sphere(center, 0.5), bowl = Quadric::sphere(center, 0.5, true);
  const Quadric pipe = Quadric::cylinder(center, 3.0 * axis, 0.2);
  for (const double r : {0.4, 0.5, 0.7}) {
    EXPECT_LT((ball.normal(center + r * side) - side).norm(), 1e-15);
    EXPECT_LT((bowl.normal(center + r * side) + side).norm(), 1e-15);
    EXPECT_LT((pipe.normal(center + r * side - 2.0 * axis) - side).norm(), 1e-15);
  }
  EXPECT_NEAR(ball.value(center + 0.5 * side), 0.0, 1e-15);
  EXPECT_NEAR(pipe.value(center + 0.2 * side + 7.0 * axis), 0.0, 1e-12);
  EXPECT_GT(ball.value(center + 0.6 * side), 0.0);
  EXPECT_LT(bowl.value(center + 0.6 * side), 0.0);
  // The normal of a cone is inclined by the half angle.
  const Quadric cone = Quadric::cone(center, axis, 0.4);
  const Vector3d on = center + std::cos(0.4) * axis + std::sin(0.4) * side;
  EXPECT_NEAR(cone.value(on), 0.0, 1e-15);
  EXPECT_LT((cone.normal(on) - (std::cos(0.4) * side - std::sin(0.4) * axis)).norm(), 1e-14);
  const Quadric egg = Quadric::ellipsoid(center, tilt(), {0.3, 0.2, 0.1});
  for (int k = 0; k < 3; ++k) {
    const Vector3d tip = center + Vector3d(0.3, 0.2, 0.1)[k] * tilt().col(k);
    EXPECT_NEAR(egg.value(tip), 0.0, 1e-15);
    EXPECT_LT((egg.normal(tip) - tilt().col(k)).norm(), 1e-14);
  }
  // The normal of an osculating quadric turns like the normal of the sphere.
  const Quadric near = Quadric::osculating(center + 0.5 * tilt().col(2), tilt(), -2.0, 0.0, -2.0);
  const Vector3d step = 1e-3 * tilt().col(0), at = center + 0.5 * tilt().col(2);
  EXPECT_LT((near.normal(at + step) - ball.normal(at + step)).norm(), 1e-5);
  EXPECT_LT((near.normal(at) - tilt().col(2)).norm(), 1e-15);
}

TEST(Quadric, InvalidShapeOrUse_IsRefused) {
  const Vector3d zero = Vector3d::Zero(), x = Vector3d::UnitX();
  const auto refused = [](const auto& make, const char* words) {
    const std::string sentence = refusal([&] { (void)make(); });
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  refused([&] { return Quadric::sphere(zero, -1.0); }, "the sphere's radius is -1 m");
  refused([&] { return Quadric::cylinder(zero, zero, 1.0); }, "the cylinder's axis");
  refused([&] { return Quadric::cone(zero, x, 2.0); }, "half angle is 2 rad");
  refused([&] { return Quadric::plane(zero, zero); }, "the plane's normal");
  refused([&] { return Quadric::sphere(zero, 1.0).normal(zero); }, "no normal at [0, 0, 0]");
  refused([&] { return Reference::on(Quadric::sphere(zero, 1.0), zero); }, "no normal");
  Quadric nothing;
  nothing.b.setZero();
  refused([&] { nothing.check("pad"); }, "pad: the surface's function is constant");
  Reference reference = Reference::on(Quadric::sphere(zero, 1.0), x);
  reference.axes = Anchor::World;
  const Model model = robot("arm7");
  refused([&] { return ContactDynamics(model, {contact("tool", "world", reference)}); },
          "wanted a reference at the tool with axes of the base");
  ContactDynamics dynamics(model, {contact("tool")});
  dynamics.acceleration(Eigen::VectorXd::Zero(7), Eigen::VectorXd::Zero(7),
                        Eigen::VectorXd::Zero(7));
  reference.axes = Anchor::Tool;
  refused([&] { return dynamics.wrench(0, reference); }, "fixed to the tool itself");
  refused([&] { return reference.at(Vector3d(1.0, 0.0, 0.0)); }, "fixed to the tool itself");
  reference.axes = Anchor::Base;
  refused([&] { return reference.at(Vector3d(-1.0, 0.0, 0.0)); },
          "is opposite to the normal of the reference");
  refused([&] { return reference.at(zero); }, "no normal at [0, 0, 0]");
  // A force stores the axes of its tool and base, and of no other frame.
  reference.axes = "link_3";
  refused([&] { return dynamics.force(0).in(reference); },
          "wanted a reference at tool, base or world");
}

struct CurvedCase {
  std::string robot, tool, base;
};
void PrintTo(const CurvedCase& test, std::ostream* out) { *out << test.robot << "_" << test.base; }

class CurvedReference : public ::testing::TestWithParam<CurvedCase> {
 protected:
  static std::vector<Quadric> surfaces() {
    const Vector3d center(0.2, -0.3, -2.0);
    return {Quadric::plane(center, {0.1, 0.2, 1.0}),
            Quadric::sphere(center, 0.4),
            Quadric::sphere({0.1, 0.2, 3.0}, 2.0, true),
            Quadric::cylinder(center, {0.3, 1.0, 0.1}, 0.3),
            Quadric::cone(center, {0.2, 1.0, 0.4}, 0.3),
            Quadric::ellipsoid(center, tilt(), {0.5, 0.9, 0.6}),
            Quadric::osculating(center, tilt(), 0.3, -0.1, -0.4)};
  }
  static Reference on(const Quadric& surface) { return Reference::on(surface, {0.3, 0.1, 0.2}); }
  ContactSpec spec(const Reference& reference, Directions directions = Directions::all()) const {
    return contact(GetParam().tool, GetParam().base, reference, directions);
  }
  Model model = robot(GetParam().robot);
  std::mt19937_64 generator{31};
};

TEST_P(CurvedReference, ThirdAxis_IsTheNormalAtTheTool) {
  for (const Quadric& surface : surfaces()) {
    ContactDynamics curved(model, {spec(on(surface))}),
        centered(model, {spec(Reference::centered())});
    const RobotState state = random_state(model, generator);
    curved.acceleration(state.q, state.v, state.v);
    centered.acceleration(state.q, state.v, state.v);
    const ContactForce here = centered.force(0);
    const Vector3d n =
        here.base_rotation *
        surface.normal(here.base_rotation.transpose() * (here.tool_position - here.base_position));
    const Eigen::Matrix3d A = curved.force(0).axes();
    EXPECT_LT((A.col(2) - n).norm(), 1e-12);
    EXPECT_TRUE(A.isUnitary(1e-12));
    Eigen::MatrixXd turned(6, model.nv);
    turned << A.transpose() * centered.jacobian().topRows(3),
        A.transpose() * centered.jacobian().bottomRows(3);
    EXPECT_LT(relative_error(curved.jacobian(), turned), 1e-12);
  }
}

TEST_P(CurvedReference, PlaneQuadric_EqualsAFlatSurface) {
  const Quadric plane = surfaces()[0];
  ContactSpec curved = spec(on(plane)), flat = spec(Reference::surface_with_normal(plane.b));
  for (ContactSpec* each : {&curved, &flat}) each->with_gains(50.0, 9.0);
  ContactDynamics a(model, {curved}, {.mu = 0.05}), b(model, {flat}, {.mu = 0.05});
  const RobotState state = random_state(model, generator);
  ASSERT_EQ(a.forward(state.q, state.v, state.tau), Status::Ok);
  ASSERT_EQ(b.forward(state.q, state.v, state.tau), Status::Ok);
  EXPECT_LT(relative_error(a.a(), b.a()), 1e-9);
  EXPECT_LT(relative_error(a.lambda(), b.lambda()), 1e-9);
  ASSERT_EQ(a.forward_derivatives(), Status::Ok);
  ASSERT_EQ(b.forward_derivatives(), Status::Ok);
  EXPECT_LT(relative_error(a.dlambda_dq(), b.dlambda_dq()), 1e-9);
  EXPECT_LT(relative_error(a.da_dv(), b.da_dv()), 1e-9);
}

TEST_P(CurvedReference, SetSurface_EqualsANewContact) {
  const Reference first = on(surfaces()[1]);
  ContactDynamics given(model, {spec(first)}, {.mu = 0.05});
  for (const Quadric& surface : surfaces()) {
    Reference same = first;  // keeps the initial axes
    same.quadric = surface;
    ContactDynamics made(model, {spec(same)}, {.mu = 0.05});
    ASSERT_EQ(given.set_surface(0, surface), Status::Ok);
    const RobotState state = random_state(model, generator);
    ASSERT_EQ(given.forward(state.q, state.v, state.tau), Status::Ok);
    ASSERT_EQ(made.forward(state.q, state.v, state.tau), Status::Ok);
    EXPECT_EQ(given.lambda(), made.lambda());
    ASSERT_EQ(given.forward_derivatives(), Status::Ok);
    ASSERT_EQ(made.forward_derivatives(), Status::Ok);
    EXPECT_EQ(given.dlambda_dq(), made.dlambda_dq());
    EXPECT_EQ(given.force(0).axes(), made.force(0).axes());
  }
  Quadric bad = surfaces()[1];
  bad.b[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(given.set_surface(0, bad), Status::NotFinite);
  EXPECT_THROW(given.set_surface(1, surfaces()[1]), Error);
  ContactDynamics flat(model, {spec(Reference::centered())});
  EXPECT_NE(refusal([&] { flat.set_surface(0, surfaces()[1]); }).find("has no curved surface"),
            std::string::npos);
}

/// Along q'' = a, alpha is the rate of the contact velocity in the moving axes.
TEST_P(CurvedReference, Acceleration_IsTheRateOfTheConstrainedVelocity) {
  for (const Quadric& surface : surfaces()) {
    ContactDynamics dynamics(model, {spec(on(surface))});
    const RobotState state = random_state(model, generator);
    const Eigen::VectorXd a = uniform(model.nv, 2.0, generator);
    dynamics.acceleration(state.q, state.v, a);
    const Eigen::VectorXd alpha = dynamics.alpha();
    const auto velocity_after = [&](double t) {
      const Eigen::VectorXd step = t * state.v + 0.5 * t * t * a, v = state.v + t * a;
      dynamics.acceleration(integrate(model, state.q, step), v, a);
      return Eigen::VectorXd(dynamics.jacobian() * v);
    };
    const auto rate = [&](double h) {
      return Eigen::VectorXd((velocity_after(h) - velocity_after(-h)) / (2.0 * h));
    };
    const Eigen::VectorXd wanted = (4.0 * rate(5e-4) - rate(1e-3)) / 3.0;
    EXPECT_LT((alpha - wanted).norm(), 1e-7 * (1.0 + wanted.norm()));
  }
}

/// The constraint alone keeps a sliding tool on a sphere, over 0.3 s of fourth-order steps of 1 ms.
TEST_P(CurvedReference, ToolThatSlidesOnASphere_StaysOnTheSphere) {
  const RobotState state = random_state(model, generator);
  ContactDynamics probe(model, {spec(Reference::centered())});
  probe.acceleration(state.q, state.v, state.v);
  const ContactForce start = probe.force(0);
  const Vector3d tool =
      start.base_rotation.transpose() * (start.tool_position - start.base_position);
  const Vector3d center = tool - 0.3 * Vector3d(0.2, -0.3, 1.0).normalized();
  const Reference reference = Reference::on(Quadric::sphere(center, 0.3), tool);
  ContactDynamics dynamics(model, {spec(reference, Directions::z())});
  dynamics.acceleration(state.q, state.v, state.v);
  Eigen::VectorXd q = state.q, v = 0.3 * at_rest(dynamics, state.q, state.v);
  const Eigen::VectorXd tau = 0.1 * state.tau;
  const auto rate = [&](const Eigen::VectorXd& at, const Eigen::VectorXd& velocity) {
    EXPECT_EQ(dynamics.forward(at, velocity, tau - 2.0 * velocity), Status::Ok);
    return Eigen::VectorXd(dynamics.a());
  };
  const double h = 1e-3;
  double moved = 0.0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::VectorXd a1 = rate(q, v);
    const Eigen::VectorXd v2 = v + 0.5 * h * a1,
                          a2 = rate(integrate(model, q, Eigen::VectorXd(0.5 * h * v)), v2);
    const Eigen::VectorXd v3 = v + 0.5 * h * a2,
                          a3 = rate(integrate(model, q, Eigen::VectorXd(0.5 * h * v2)), v3);
    const Eigen::VectorXd v4 = v + h * a3,
                          a4 = rate(integrate(model, q, Eigen::VectorXd(h * v3)), v4);
    q = integrate(model, q, Eigen::VectorXd(h / 6.0 * (v + 2.0 * v2 + 2.0 * v3 + v4)));
    v += h / 6.0 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
    probe.acceleration(q, v, v);
    const ContactForce at = probe.force(0);
    const Vector3d x = at.base_rotation.transpose() * (at.tool_position - at.base_position);
    moved = std::max(moved, (x - tool).norm());
    ASSERT_NEAR((x - center).norm(), 0.3, 1e-6) << "after " << (i + 1) * h << " s";
  }
  EXPECT_GT(moved, 0.01);
}

TEST_P(CurvedReference, PointWithoutANormal_GivesAStatus) {
  ContactDynamics probe(model, {spec(Reference::centered())});
  const RobotState state = random_state(model, generator);
  probe.acceleration(state.q, state.v, state.v);
  const ContactForce at = probe.force(0);
  const Vector3d x = at.base_rotation.transpose() * (at.tool_position - at.base_position);
  // The tool at the centre of the sphere, then at a normal opposite to the initial axes.
  Reference there = Reference::on(Quadric::sphere(x, 0.3), x + Vector3d::UnitX());
  ContactDynamics center(model, {spec(there, Directions::z())});
  EXPECT_NE(center.forward(state.q, state.v, state.tau), Status::Ok);
  const Reference over =
      Reference::on(Quadric::sphere(x - 0.3 * Vector3d::UnitX(), 0.3), x - Vector3d::UnitX());
  ContactDynamics opposite(model, {spec(over, Directions::linear())});
  const Status status = opposite.forward(state.q, state.v, state.tau);
  if (status == Status::Ok) {
    EXPECT_TRUE(opposite.a().allFinite() && opposite.lambda().allFinite());
    EXPECT_LT(opposite.lambda().norm(), 1e9);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, CurvedReference,
                         ::testing::Values(CurvedCase{"arm7", "tool", "world"},
                                           CurvedCase{"arm7", "tool", "link_1"},
                                           CurvedCase{"every_joint", "tip", "world"}));

}  // namespace
}  // namespace burnish::test
