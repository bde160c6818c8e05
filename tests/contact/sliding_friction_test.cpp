// Friction of sliding tools: forces against the full equations of motion, and refusals. Tests in
// tests/laws check the derivatives.
#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "support/contact_states.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using testing::refusal;

struct SlidingCase {
  std::string robot, tool, base;
};
void PrintTo(const SlidingCase& test, std::ostream* out) { *out << test.robot << "_" << test.base; }

/// Jacobian (3 x nv, world axes) and velocity of the tool's point c against the base.
struct PointMotion {
  Eigen::MatrixXd J;
  Vector3d v;
};

class SlidingTool : public ::testing::TestWithParam<SlidingCase> {
 protected:
  ContactSpec spec(std::optional<SlidingFriction> friction,
                   Directions directions = Directions::z()) {
    ContactSpec result =
        contact(GetParam().tool, GetParam().base, Reference::surface(tilt()), directions);
    result.friction = friction;
    result.with_gains(0.0, 8.0);
    return result;
  }
  /// Motion of the point at `radius` from the tool's origin against the third axis of the surface.
  PointMotion point_motion(const RobotState& state, double radius, Vector3d& n) {
    ContactDynamics probe(model, {contact(GetParam().tool, GetParam().base)}, {.mu = 1.0});
    probe.acceleration(state.q, state.v, state.v);
    n = probe.force(0).base_rotation * tilt().col(2);
    const Eigen::MatrixXd J = probe.jacobian();  // at the tool's origin, world axes
    const Vector3d arm = -radius * n;
    PointMotion result;
    result.J = J.topRows(3);
    for (int k = 0; k < model.nv; ++k) result.J.col(k) += Vector3d(J.col(k).tail<3>()).cross(arm);
    result.v = result.J * state.v;
    return result;
  }

  Model model = robot(GetParam().robot);
  std::mt19937_64 generator{91};
};

TEST_P(SlidingTool, FrictionForces_SolveTheEquationsOfMotion) {
  const SlidingFriction friction{0.35, 0.05, 0.04};
  const std::vector<Directions> sets{Directions::z(), Directions::pad_z()};
  for (const Directions& directions : sets) {
    ContactDynamics dynamics(model, {spec(friction, directions)});
    const RobotState state = regular_state(model, dynamics, generator);
    ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
    const Eigen::VectorXd a = dynamics.a(), lambda = dynamics.lambda();
    const Eigen::MatrixXd M = dynamics.mass_matrix(), J = dynamics.jacobian();
    Vector3d n;
    const PointMotion at = point_motion(state, friction.radius, n);
    const Vector3d across = at.v - n * n.dot(at.v);
    const double fade_speed = friction.fade_speed();
    const Vector3d s = across / std::sqrt(across.squaredNorm() + fade_speed * fade_speed);
    const Vector3d friction_force = -friction.coefficient * lambda[0] * s;
    EXPECT_LE(friction_force.dot(across) * (lambda[0] > 0.0 ? 1.0 : -1.0), 0.0);
    // M a + b = tau + J^T lambda + J_c^T f, and the constraint.
    const Eigen::VectorXd left = M * a + Eigen::VectorXd(dynamics.bias());
    const Eigen::VectorXd right =
        state.tau + J.transpose() * lambda + at.J.transpose() * friction_force;
    EXPECT_LT(relative_error(left, right), 1e-9);
    ASSERT_EQ(dynamics.acceleration(state.q, state.v, a), Status::Ok);
    EXPECT_LT(dynamics.alpha().norm(), 1e-9 * (1.0 + (J * a).norm()));
    // Inverse dynamics: the same torques.
    ASSERT_EQ(dynamics.inverse(state.q, state.v, a, lambda), Status::Ok);
    EXPECT_LT(relative_error(dynamics.tau(), state.tau), 1e-9);
    // The wrench contains the normal force and the friction force with its lever arm.
    const Vector6 wrench = dynamics.wrench(0, Reference::centered());
    Vector3d normal_force = lambda[0] * n;
    EXPECT_LT((wrench.head<3>() - normal_force - friction_force).norm(),
              1e-10 * (1.0 + wrench.norm()));
    if (directions == Directions::z()) {
      const Vector3d moment = -friction.radius * n.cross(friction_force);
      EXPECT_LT((wrench.tail<3>() - moment).norm(), 1e-10 * (1.0 + wrench.norm()));
    }
  }
}

TEST_P(SlidingTool, ZeroCoefficient_EqualsNoFriction) {
  ContactDynamics smooth(model, {spec({})}), frictional(model, {spec(SlidingFriction{0.0, 0.01})});
  const RobotState state = regular_state(model, smooth, generator);
  ASSERT_EQ(smooth.forward(state.q, state.v, state.tau), Status::Ok);
  ASSERT_EQ(frictional.forward(state.q, state.v, state.tau), Status::Ok);
  EXPECT_LT(relative_error(frictional.a(), smooth.a()), 1e-12);
  EXPECT_LT(relative_error(frictional.lambda(), smooth.lambda()), 1e-12);
  ASSERT_EQ(smooth.forward_derivatives(), Status::Ok);
  ASSERT_EQ(frictional.forward_derivatives(), Status::Ok);
  EXPECT_LT(relative_error(frictional.da_dq(), smooth.da_dq()), 1e-12);
  EXPECT_LT(relative_error(frictional.dlambda_dv(), smooth.dlambda_dv()), 1e-11);
}

TEST_P(SlidingTool, SetCoefficient_EqualsANewContact) {
  ContactDynamics given(model, {spec(SlidingFriction{0.1, 0.02})});
  ContactDynamics made(model, {spec(SlidingFriction{0.5, 0.02})});
  ASSERT_EQ(given.set_friction(0, 0.5), Status::Ok);
  const RobotState state = regular_state(model, made, generator);
  ASSERT_EQ(given.forward(state.q, state.v, state.tau), Status::Ok);
  ASSERT_EQ(made.forward(state.q, state.v, state.tau), Status::Ok);
  EXPECT_EQ(given.lambda(), made.lambda());
  EXPECT_EQ(given.set_friction(0, -0.1), Status::NotFinite);
  EXPECT_EQ(given.set_friction(0, std::numeric_limits<double>::quiet_NaN()), Status::NotFinite);
  ASSERT_EQ(given.forward(state.q, state.v, state.tau), Status::Ok);
  EXPECT_EQ(given.lambda(), made.lambda());
  ContactDynamics smooth(model, {spec({})});
  EXPECT_NE(refusal([&] { smooth.set_friction(0, 0.1); }).find("has no friction"),
            std::string::npos);
}

/// Two contacts with friction at once, one of them switched off, and redundant contacts.
TEST_P(SlidingTool, SeveralContacts_SlideWithFriction) {
  ContactSpec first = spec(SlidingFriction{0.3, 0.1}),
              second = spec(SlidingFriction{0.2, 0.1, 0.1});
  second.name = "second";
  second.reference = Reference::centered();
  second.directions = Directions::y();
  ContactDynamics both(model, {first, second}), one(model, {second});
  const RobotState state = regular_state(model, both, generator);
  ASSERT_EQ(both.forward(state.q, state.v, state.tau), Status::Ok);
  const Eigen::VectorXd a = both.a(), lambda = both.lambda();
  ASSERT_EQ(both.inverse(state.q, state.v, a, lambda), Status::Ok);
  EXPECT_LT(relative_error(both.tau(), state.tau), 1e-9);
  both.set_active(0, false);
  ASSERT_EQ(both.forward(state.q, state.v, state.tau), Status::Ok);
  ASSERT_EQ(one.forward(state.q, state.v, state.tau), Status::Ok);
  EXPECT_EQ(both.lambda(), one.lambda());
  EXPECT_EQ(both.a(), one.a());
  // One contact declared twice; the proximal iterations remove the compliance.
  ContactSpec twin = first;
  twin.name = "twin";
  ContactDynamics redundant(model, {first, twin}, {.mu = 1e-2, .max_proximal_iterations = 500});
  ContactDynamics single(model, {first});
  ASSERT_EQ(redundant.forward(state.q, state.v, state.tau), Status::Ok);
  ASSERT_EQ(single.forward(state.q, state.v, state.tau), Status::Ok);
  EXPECT_LT(relative_error(redundant.a(), single.a()), 1e-6);
  EXPECT_NEAR(redundant.lambda().sum(), single.lambda()[0],
              1e-6 * (1.0 + std::abs(single.lambda()[0])));
}

TEST_P(SlidingTool, ExcessiveFriction_JamsWithAStatus) {
  ContactDynamics dynamics(model, {spec(SlidingFriction{30.0, 1e-3})});
  ContactDynamicsBatch batch(model, {spec(SlidingFriction{30.0, 1e-3})}, 1);
  bool jammed = false;
  for (int i = 0; i < 50 && !jammed; ++i) {
    const RobotState state = random_state(model, generator);
    if (dynamics.forward(state.q, state.v, state.tau) != Status::SingularContacts) continue;
    if (dynamics.explanation().find("jams") == std::string::npos) continue;
    jammed = true;
    EXPECT_TRUE(dynamics.a().isZero(0.0) && dynamics.lambda().isZero(0.0));
    EXPECT_EQ(batch.forward(state.q, state.v, state.tau), Status::SingularContacts);
    EXPECT_NE(batch.explanation(0).find("jams"), std::string::npos);
  }
  EXPECT_TRUE(jammed);
}

TEST_P(SlidingTool, ContactWithoutOneNormal_IsRefused) {
  const auto refused = [&](const ContactSpec& given, const char* words) {
    const std::string sentence = refusal([&] { ContactDynamics(model, {given}); });
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  const SlidingFriction usual;
  refused(spec(usual, Directions::all()), "are x,y,z; wanted exactly one of x, y and z");
  refused(spec(usual, Directions::angular()), "none of its directions is a translation");
  refused(spec(SlidingFriction{-1.0}), "friction: coefficient");
  refused(spec(SlidingFriction{0.3, 0.0}), "friction: speed");
  refused(spec(SlidingFriction{0.3, 0.01, -0.1}), "friction: radius");
}

INSTANTIATE_TEST_SUITE_P(Robots, SlidingTool,
                         ::testing::Values(SlidingCase{"arm7", "tool", "world"},
                                           SlidingCase{"arm7", "tool", "link_1"},
                                           SlidingCase{"every_joint", "tip", "world"}));

}  // namespace
}  // namespace burnish::test
