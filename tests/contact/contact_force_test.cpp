// Tests of the text of contact forces and of their conversion between references.
#include <gtest/gtest.h>

#include "support/contact_states.hpp"
#include "support/refusal.hpp"
#include "support/touch.hpp"

namespace burnish::test {
namespace {

ContactForce push(const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
                  const Reference& reference = Reference::centered()) {
  ContactForce result;
  result.contact = "pad";
  result.on = "tool";
  result.by = "world";
  result.reference = reference;
  result.value << force, moment;
  result.tool_rotation = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  result.base_rotation = Eigen::Matrix3d::Identity();
  result.tool_position = Eigen::Vector3d(0.6, 0.0, 0.2);
  return result;
}

TEST(ContactForceText, SingleAxis_NamesAxisBodiesAndPoint) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero(), up(0.0, 0.0, 30.0);
  EXPECT_EQ(push(up, none).text(),
            "30.0 N along +z of the world, on tool, by the world, at the tool's origin");
  EXPECT_EQ(push(-up, none).text(),
            "30.0 N along -z of the world, on tool, by the world, at the tool's origin");
  EXPECT_EQ(push(up, none, Reference::local()).text(),
            "30.0 N along +z of the tool's axes, on tool, by the world, at the tool's origin");
  EXPECT_EQ(push(up, none, Reference::surface(tilt())).text(),
            "30.0 N along +z of the surface, on tool, by the world, at the tool's origin");
  ContactForce by_board = push(up, none);
  by_board.by = "board";
  EXPECT_EQ(by_board.text(),
            "30.0 N along +z of the world, on tool, by board, at the tool's origin");
}

TEST(ContactForceText, SeveralComponents_AreListedWithTheMoment) {
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  EXPECT_EQ(push({1.0, -2.5, 30.0}, none).text(),
            "(1.00, -2.50, 30.0) N of the world, on tool, by the world, at the tool's origin");
  EXPECT_EQ(push({0.0, 0.0, 30.0}, {0.0, -1.25, 0.0}).text(),
            "30.0 N along +z and 1.25 Nm about -y of the world, on tool, by the world, at the "
            "tool's origin");
  EXPECT_EQ(push(none, none).text(),
            "(0.00, 0.00, 0.00) N of the world, on tool, by the world, at the tool's origin");
}

TEST(ContactForceText, WorldReference_HasTheMomentAboutTheWorldOrigin) {
  // 30 N upward, 0.6 m along x from the origin, where it has a moment of -18 Nm about y.
  const ContactForce force = push({0.0, 0.0, 30.0}, Eigen::Vector3d::Zero());
  EXPECT_EQ(force.in(Reference::world()).text(),
            "30.0 N along +z and 18.0 Nm about -y of the world, on tool, by the world, about the "
            "world's origin");
}

TEST(ContactForceConversion, LocalReference_UsesTheAxesOfTheTool) {
  // The tool's x axis points down and its z axis along the world's x.
  const ContactForce force = push({0.0, 0.0, 30.0}, {1.0, 0.0, 0.0});
  Vector6 expected;
  expected << -30.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  EXPECT_LT((force.in(Reference::local()).value - expected).norm(), 1e-12);
  for (const Reference& reference : all_references())
    EXPECT_LT((force.in(reference).in(Reference::centered()).value - force.value).norm(), 1e-12);
}

TEST(ContactForceConversion, FrameThatIsNotStored_IsRefused) {
  const ContactForce force = push({0.0, 0.0, 30.0}, Eigen::Vector3d::Zero());
  testing::expect_words(testing::refusal([&] {
                          (void)force.in({Anchor::Tool, "torso"});
                        }),
                        {"'pad'", "axes of torso at the tool", "ContactDynamics::force"});
}

class ContactWrench : public ::testing::TestWithParam<Touch> {
 protected:
  std::vector<Reference> references() const {
    return all_references(model_, GetParam().tool, GetParam().base);
  }
  /// References that follow surfaces of the base, of the world and of a third body.
  std::vector<Reference> curved_references() const {
    const std::string third = far_frame(model_, {GetParam().tool, GetParam().base});
    std::vector<Reference> result{{Anchor::Tool, Anchor::Base, tilt()},
                                  {Anchor::Base, Anchor::World, tilt()},
                                  {Anchor::Tool, third, tilt()}};
    result[0].quadric = Quadric::sphere({0.1, 0.2, -4.0}, 2.0);
    result[1].quadric = Quadric::cylinder({0.1, 4.0, -3.0}, {1.0, 0.3, 0.2}, 0.5);
    result[2].quadric = Quadric::osculating({0.3, 0.0, 0.2}, tilt(), 0.2, 0.1, -0.15);
    return result;
  }
  Model model_ = robot(GetParam().robot);
  std::mt19937_64 generator_{41};
};

TEST_P(ContactWrench, EveryReference_EqualsTheConvertedForce) {
  for (const Reference& own : references()) {
    ContactDynamics dynamics(
        model_, {contact(GetParam().tool, GetParam().base, own, Directions::parse("x,z,ry"))});
    const RobotState state = regular_state(model_, dynamics, generator_);
    ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
    const ContactForce force = dynamics.force(0);
    EXPECT_EQ(force.on, GetParam().tool);
    EXPECT_EQ(force.by, GetParam().base);
    const Eigen::VectorXd lambda = dynamics.lambda();
    Vector6 expected;
    expected << lambda[0], 0.0, lambda[1], 0.0, lambda[2], 0.0;
    EXPECT_LT((force.value - expected).norm(), 1e-13 * expected.norm());
    std::vector<Reference> others = references();
    for (const Reference& curved : curved_references()) others.push_back(curved);
    for (const Reference& other : others) {
      const ContactForce there = dynamics.force(0, other);
      const bool convertible =
          other.axes.kind != Anchor::Frame && other.origin.kind != Anchor::Frame;
      const Vector6 converted = convertible ? force.in(other).value : there.value;
      EXPECT_LT((dynamics.wrench(0, other) - converted).norm(), 1e-11 * converted.norm());
      EXPECT_LT((there.in(Reference::world()).value - force.in(Reference::world()).value).norm(),
                1e-11 * force.in(Reference::world()).value.norm())
          << own.name() << " in " << other.name();
    }
  }
}

TEST_P(ContactWrench, SetRotation_EqualsAContactBuiltWithIt) {
  for (const Reference& own : references()) {
    Reference plain = own;
    plain.rotation.setIdentity();
    const auto dynamics_of = [&](const Reference& reference) {
      return ContactDynamics(model_, {contact(GetParam().tool, GetParam().base, reference,
                                              Directions::parse("x,z,ry"))});
    };
    ContactDynamics stated = dynamics_of(own), turned = dynamics_of(plain);
    EXPECT_EQ(turned.set_reference_rotation(0, 1.1 * own.rotation), Status::NotNormalized);
    EXPECT_EQ(turned.set_reference_rotation(0, own.rotation), Status::Ok);
    EXPECT_EQ(turned.forward_derivatives(), Status::NotEvaluated);
    const RobotState state = regular_state(model_, stated, generator_);
    for (ContactDynamics* dynamics : {&stated, &turned}) {
      ASSERT_EQ(dynamics->forward(state.q, state.v, state.tau), Status::Ok);
      ASSERT_EQ(dynamics->forward_derivatives(), Status::Ok);
    }
    EXPECT_LT(relative_error(turned.lambda(), stated.lambda()), 1e-12) << own.name();
    EXPECT_LT(relative_error(turned.dlambda_dq(), stated.dlambda_dq()), 1e-12) << own.name();
    EXPECT_EQ(turned.force(0).reference.rotation, own.rotation);
    EXPECT_LT((turned.force(0).value - stated.force(0).value).norm(), 1e-9);
  }
  ContactDynamics dynamics(model_, {contact(GetParam().tool, GetParam().base)});
  testing::expect_words(testing::refusal([&] { (void)dynamics.set_reference_rotation(1, tilt()); }),
                        {"set_reference_rotation", "contact 1 does not exist", "the set has 1"});
}

/// Derivatives of the wrench in a reference by differences of fourth order.
WrenchDerivatives differences(const Model& model, ContactDynamics& dynamics, const RobotState& s,
                              const Reference& reference) {
  const int n = model.nv;
  WrenchDerivatives result{RowMatrix(6, n), RowMatrix(6, n), RowMatrix(6, n)};
  const auto slope = [&](const auto& state_at) -> Vector6 {
    const auto wrench = [&](double t) {
      const RobotState at = state_at(t);
      dynamics.forward(at.q, at.v, at.tau);
      return dynamics.wrench(0, reference);
    };
    const double h = 2e-4;
    const Vector6 narrow = (wrench(h) - wrench(-h)) / (2.0 * h);
    const Vector6 wide = (wrench(2.0 * h) - wrench(-2.0 * h)) / (4.0 * h);
    return (4.0 * narrow - wide) / 3.0;
  };
  for (int k = 0; k < n; ++k) {
    const Eigen::VectorXd e = Eigen::VectorXd::Unit(n, k);
    result.dq.col(k) = slope([&](double t) {
      return RobotState{integrate(model, s.q, t * e), s.v, s.tau};
    });
    result.dv.col(k) = slope([&](double t) { return RobotState{s.q, s.v + t * e, s.tau}; });
    result.dtau.col(k) = slope([&](double t) {
                           return RobotState{s.q, s.v, s.tau + 1e3 * t * e};
                         }) /
                         1e3;
  }
  return result;
}

TEST_P(ContactWrench, DerivativesInEveryReference_EqualDifferences) {
  std::vector<Reference> owns = references(), asked = references();
  owns.push_back(Reference::on(Quadric::sphere({0.1, 0.2, -3.0}, 2.0), {0.3, 0.0, 0.2}));
  for (const Reference& curved : curved_references()) asked.push_back(curved);
  for (const Reference& own : owns) {
    ContactSpec spec = contact(GetParam().tool, GetParam().base, own, Directions::parse("x,z,ry"));
    spec.with_gains(60.0, 9.0);
    ContactDynamics dynamics(model_, {spec}), other(model_, {spec});
    const RobotState state = regular_state(model_, dynamics, generator_, 1e-2);
    ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
    ASSERT_EQ(dynamics.forward_derivatives(), Status::Ok);
    for (const Reference& target : asked) {
      WrenchDerivatives got;
      dynamics.wrench_derivatives(0, target, got);
      const WrenchDerivatives want = differences(model_, other, state, target);
      EXPECT_LT(relative_error(got.dq, want.dq), 1e-6) << own.name() << " in " << target.name();
      EXPECT_LT(relative_error(got.dv, want.dv), 1e-6) << own.name() << " in " << target.name();
      EXPECT_LT(relative_error(got.dtau, want.dtau), 1e-6) << own.name() << " in " << target.name();
    }
  }
}

TEST_P(ContactWrench, InactiveContact_IsZero) {
  ContactDynamics dynamics(model_, {contact(GetParam().tool, GetParam().base)});
  dynamics.set_active(0, false);
  const RobotState state = random_state(model_, generator_);
  ASSERT_EQ(dynamics.forward(state.q, state.v, state.tau), Status::Ok);
  dynamics.forward_derivatives();
  WrenchDerivatives got;
  dynamics.wrench_derivatives(0, Reference::world(), got);
  EXPECT_EQ(dynamics.wrench(0, Reference::world()), Vector6::Zero());
  EXPECT_EQ(got.dq, RowMatrix::Zero(6, model_.nv));
  EXPECT_EQ(got.dtau, RowMatrix::Zero(6, model_.nv));
}

std::vector<Touch> wrench_touches() {
  const std::string legged = humanoid().name;
  const std::vector<Touch> all = {{"arm7", "tool", "world"},
                                  {legged, "right_sole_link", "world"},
                                  {legged, "tool", "left_sole_link"},
                                  {"crane", "left_tip", "right_tip"},
                                  {"crane:floating", "left_tip", "right_tip"}};
  return available(all, [](const Touch& touch) { return touch.robot; });
}

INSTANTIATE_TEST_SUITE_P(all, ContactWrench, ::testing::ValuesIn(wrench_touches()),
                         [](const auto& test) {
                           std::string name =
                               test.param.robot + "_" + test.param.tool + "_on_" + test.param.base;
                           for (char& c : name)
                             if (c == ':') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace burnish::test
