// Laws of physics that contacts satisfy in every reference.
#include <gtest/gtest.h>

#include "base/decomposition.hpp"
#include "support/contact_motion.hpp"
#include "support/contact_states.hpp"
#include "support/touch.hpp"

namespace burnish::test {
namespace {

/// The touches whose robots are part of this build.
std::vector<Touch> of_this_build(const std::vector<Touch>& touches) {
  return available(touches, [](const Touch& touch) { return touch.robot; });
}

std::vector<Touch> law_touches() {
  const std::string legged = humanoid().name;
  return of_this_build({{"talos:fixed", "tool", "world"},
                        {"arm7", "tool", "world"},
                        {"arm7:floating", "tool", "world"},
                        {legged, "right_sole_link", "world"},
                        {legged, "right_sole_link", "left_sole_link"},
                        {"crane", "left_tip", "right_tip"},
                        {"crane:floating", "left_tip", "right_tip"}});
}

const std::vector<Acceleration> accelerations{Acceleration::TimeDerivative, Acceleration::Spatial,
                                              Acceleration::Classical};

class ContactPhysics : public ::testing::TestWithParam<Touch> {
 protected:
  Model model_ = robot(GetParam().robot);
  std::mt19937_64 generator_{17};

  std::vector<Reference> references() const {
    return all_references(model_, GetParam().tool, GetParam().base);
  }
  ContactSpec touch(const Reference& reference, const Directions& directions = Directions::all(),
                    Acceleration acceleration = Acceleration::TimeDerivative) const {
    return contact(GetParam().tool, GetParam().base, reference, directions, acceleration);
  }
};

TEST_P(ContactPhysics, StuckContact_HasOneMotionAndForceInEveryReference) {
  ContactDynamics first(model_, {touch(Reference::local())});
  for (int i = 0; i < 20; ++i) {
    RobotState state = regular_state(model_, first, generator_, 1e-2);
    state.v = at_rest(first, state.q, state.v);
    ASSERT_EQ(first.forward(state.q, state.v, state.tau), Status::Ok);
    const Vector6 wrench = first.wrench(0, Reference::world());
    const Eigen::VectorXd a = first.a();
    for (const Reference& reference : references())
      for (const Acceleration kind : accelerations) {
        ContactDynamics other(model_, {touch(reference, Directions::all(), kind)});
        ASSERT_EQ(other.forward(state.q, state.v, state.tau), Status::Ok);
        EXPECT_LT(relative_error(other.a(), a), 1e-9) << reference.name() << name_of(kind);
        EXPECT_LT(relative_error(other.wrench(0, Reference::world()), wrench), 1e-9)
            << reference.name() << name_of(kind);
      }
  }
}

TEST_P(ContactPhysics, Power_EqualsJointPowerPlusContactPower) {
  for (const Reference& reference : references()) {
    ContactDynamics dynamics(model_, {touch(reference, Directions::linear())});
    for (int i = 0; i < 5; ++i) {
      const RobotState state = regular_state(model_, dynamics, generator_, 1e-2);
      ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
      const Eigen::VectorXd a = dynamics.a();
      const double joints = state.tau.dot(state.v);
      const double contact = dynamics.lambda().dot(dynamics.contact_velocity());
      const auto energy = [&](double t) {
        const Eigen::VectorXd step = t * state.v + 0.5 * t * t * a;
        return energy_of(model_, integrate(model_, state.q, step), state.v + t * a);
      };
      const auto rate = [&](double h) { return (energy(h) - energy(-h)) / (2.0 * h); };
      const double h = 1e-4;
      const double power = (4.0 * rate(h) - rate(2.0 * h)) / 3.0;
      const double scale = std::abs(joints) + std::abs(contact) + 1.0;
      EXPECT_NEAR(power, joints + contact, 1e-6 * scale) << reference.name();
    }
  }
}

TEST_P(ContactPhysics, StuckContact_HasNoPower) {
  ContactDynamics first(model_, {touch(Reference::local())});
  for (const Reference& reference : references()) {
    ContactDynamics dynamics(model_, {touch(reference)});
    for (int i = 0; i < 5; ++i) {
      const RobotState state = regular_state(model_, first, generator_, 1e-2);
      const Eigen::VectorXd v = at_rest(dynamics, state.q, state.v);
      ASSERT_EQ(dynamics.forward(state.q, v, state.tau), Status::Ok);
      const double force = dynamics.lambda().norm();
      EXPECT_LT(std::abs(dynamics.lambda().dot(dynamics.contact_velocity())), 1e-10 * force);
    }
  }
}

TEST_P(ContactPhysics, ForcesAndAccelerations_SolveTheEquationsOfMotion) {
  for (const Reference& reference : references())
    for (const Acceleration kind : accelerations) {
      ContactSpec spec = touch(reference, Directions::linear(), kind);
      spec.with_gains(50.0, 8.0);
      ContactDynamics dynamics(model_, {spec});
      const RobotState state = regular_state(model_, dynamics, generator_, 1e-2);
      ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
      const Eigen::VectorXd a = dynamics.a(), lambda = dynamics.lambda();
      const Eigen::VectorXd rest = dynamics.mass_matrix() * a + dynamics.bias() - state.tau -
                                   dynamics.jacobian().transpose() * lambda;
      EXPECT_LT(rest.norm(), 1e-9 * (1.0 + state.tau.norm() + lambda.norm()));
      ASSERT_EQ(dynamics.acceleration(state.q, state.v, a), Status::Ok);
      EXPECT_LT(dynamics.alpha().norm(), 1e-9 * (1.0 + a.norm()));
      ASSERT_EQ(dynamics.inverse(state.q, state.v, a, lambda), Status::Ok);
      EXPECT_LT(relative_error(dynamics.tau(), state.tau, 1.0), 1e-9);
    }
}

std::string name_of_case(const ::testing::TestParamInfo<Touch>& info) {
  std::string name = info.param.robot + "_" + info.param.tool + "_on_" + info.param.base;
  for (char& c : name)
    if (c == ':') c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(all, ContactPhysics, ::testing::ValuesIn(law_touches()), name_of_case);

class ConstrainedMotion : public ContactPhysics {};

/// Largest departure of the contact velocity from its first value over 0.2 s.
double departure(ContactDynamics& dynamics, const Model& model, const RobotState& start,
                 int steps) {
  RobotState state = start;
  dynamics.forward(state.q, state.v, state.tau);
  const Eigen::VectorXd nu = dynamics.contact_velocity();
  double worst = 0.0;
  for (int i = 0; i < steps; ++i) {
    runge_kutta_step(dynamics, model, constant_torque(start.tau), 0.2 / steps, state);
    if (dynamics.forward(state.q, state.v, state.tau) != Status::Ok) return 1e300;
    worst = std::max(worst, (dynamics.contact_velocity() - nu).norm());
  }
  return worst;
}

TEST_P(ConstrainedMotion, SmallerSteps_KeepTheContactVelocityBetter) {
  for (const Reference& reference : references()) {
    ContactDynamics dynamics(model_, {touch(reference, Directions::parse("x,z,ry"))});
    RobotState state = regular_state(model_, dynamics, generator_, 1e-2);
    state.v *= 0.5;
    dynamics.forward(state.q, Eigen::VectorXd::Zero(model_.nv), state.tau);
    state.tau = dynamics.bias();  // so that the arm does not fall far
    const double coarse = departure(dynamics, model_, state, 50);
    const double fine = departure(dynamics, model_, state, 200);
    EXPECT_LT(fine, 1e-8) << reference.name();
    // Fourth order: 256 times less, unless both are rounding errors.
    EXPECT_LT(fine, std::max(coarse / 100.0, 1e-11)) << reference.name();
  }
}

INSTANTIATE_TEST_SUITE_P(all, ConstrainedMotion,
                         ::testing::ValuesIn(of_this_build({{"talos:right_arm", "tool", "world"},
                                                            {"arm7", "tool", "world"},
                                                            {"arm7", "tool", "link_1"},
                                                            {"crane", "left_tip", "right_tip"}})),
                         name_of_case);

/// Height that a tool loses on a plane in one second, sliding at 0.07 m/s and tilting at 0.2 rad/s.
double height_lost(Acceleration acceleration) {
  const Model model = robot("arm7");
  ContactDynamics plane(
      model, {contact("tool", "world", Reference::centered(), Directions::z(), acceleration)});
  ContactDynamics pose(model, {contact("tool", "world", Reference::centered(), Directions::all(),
                                       Acceleration::Classical)});
  Eigen::VectorXd wanted(6);
  wanted << 0.07, 0.0, 0.0, 0.0, 0.2, 0.0;
  RobotState state{arm7::ready(), {}, {}};
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  pose.acceleration(state.q, rest, rest);
  state.v = least_squares(pose.jacobian(), wanted);
  // Torques that control the whole motion except the height, which the contact constrains.
  const Torque keep = [&](const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
    pose.acceleration(q, v, rest);
    Eigen::VectorXd alpha = 50.0 * (wanted - pose.contact_velocity()) - pose.alpha();
    Eigen::MatrixXd J = pose.jacobian();
    alpha[2] = 0.0;
    J.row(2).setZero();
    const Eigen::VectorXd a = least_squares(J, alpha);
    return Eigen::VectorXd(pose.mass_matrix() * a + pose.bias());
  };
  plane.forward(state.q, state.v, rest);
  const double before = plane.force(0).tool_position.z();
  for (int i = 0; i < 500; ++i) runge_kutta_step(plane, model, keep, 0.002, state);
  plane.forward(state.q, state.v, rest);
  return before - plane.force(0).tool_position.z();
}

TEST(SlidingOnAPlane, SpatialAcceleration_LosesHeightAndOthersDoNot) {
  EXPECT_NEAR(height_lost(Acceleration::Spatial), 0.007, 0.0007);
  EXPECT_NEAR(height_lost(Acceleration::TimeDerivative), 0.0, 1e-9);
  EXPECT_NEAR(height_lost(Acceleration::Classical), 0.0, 1e-9);
}

#if BURNISH_HAS_ROBOTS  // the crane's two arms
/// The surface of a base at rest, as a surface in the world.
Reference in_world(const Eigen::Matrix3d& base, const Reference& reference) {
  if (reference.axes != Anchor::Base) return reference;
  return Reference::surface(base * reference.rotation);
}

TEST(TwoBodyContact, ImmovableBase_EqualsOneBody) {
  Model model = robot("crane");
  for (const std::string name : {"rail_joint", "slew_joint", "right_luff_joint",
                                 "right_extend_joint", "right_swing_joint", "right_wrist_joint"})
    model.armature[model.joints[static_cast<std::size_t>(model.joint_index(name))].v_index] = 1e14;
  std::mt19937_64 generator(23);
  for (const Reference& reference : all_references())
    for (const Acceleration kind : accelerations) {
      ContactDynamics two(
          model, {contact("left_tip", "right_tip", reference, Directions::parse("x,z"), kind)});
      RobotState state = regular_state(model, two, generator, 1e-2);
      for (int k = 0; k < model.nv; ++k)
        if (model.armature[k] > 1.0) state.v[k] = 0.0;
      ASSERT_EQ(two.forward(state.q, state.v, state.tau), Status::Ok);
      const Eigen::Matrix3d base = frame_placement(model, state.q, "right_tip").linear();
      ContactDynamics one(model, {contact("left_tip", "world", in_world(base, reference),
                                          Directions::parse("x,z"), kind)});
      ASSERT_EQ(one.forward(state.q, state.v, state.tau), Status::Ok);
      EXPECT_LT(relative_error(two.a(), one.a()), 1e-9) << reference.name();
      EXPECT_LT(relative_error(two.lambda(), one.lambda()), 1e-9) << reference.name();
    }
}

TEST(TwoBodyContact, LockedBase_EqualsOneBody) {
  RobotOverrides overrides;
  overrides.free = {"left_luff_joint", "left_extend_joint", "left_tilt_joint", "left_wrist_joint"};
  const Model model = load_robot(std::string(BURNISH_ROBOTS_DIR) + "/crane", overrides).model;
  std::mt19937_64 generator(29);
  for (const Reference& reference : all_references()) {
    ContactDynamics two(model,
                        {contact("left_tip", "right_tip", reference, Directions::parse("x,z"))});
    const RobotState state = regular_state(model, two, generator, 1e-2);
    const Eigen::Matrix3d base = frame_placement(model, state.q, "right_tip").linear();
    ContactDynamics one(
        model, {contact("left_tip", "world", in_world(base, reference), Directions::parse("x,z"))});
    ASSERT_EQ(two.forward(state.q, state.v, state.tau), Status::Ok);
    ASSERT_EQ(one.forward(state.q, state.v, state.tau), Status::Ok);
    EXPECT_LT(relative_error(two.a(), one.a()), 1e-11) << reference.name();
    EXPECT_LT(relative_error(two.lambda(), one.lambda()), 1e-11) << reference.name();
  }
}

TEST(TwoBodyContact, SwappedBodies_GiveTheOppositeForce) {
  const Model model = robot("crane");
  std::mt19937_64 generator(31);
  ContactDynamics left(model, {contact("left_tip", "right_tip")});
  ContactDynamics right(model, {contact("right_tip", "left_tip")});
  for (int i = 0; i < 10; ++i) {
    RobotState state = regular_state(model, left, generator, 1e-2);
    state.v = at_rest(left, state.q, state.v);
    ASSERT_EQ(left.forward(state.q, state.v, state.tau), Status::Ok);
    ASSERT_EQ(right.forward(state.q, state.v, state.tau), Status::Ok);
    EXPECT_LT(relative_error(right.a(), left.a()), 1e-9);
    const Vector6 push = left.wrench(0, Reference::world());
    const Vector6 back = right.wrench(0, Reference::world());
    EXPECT_LT((back + push).norm(), 1e-9 * push.norm());
  }
}
#endif

}  // namespace
}  // namespace burnish::test
