// Tests of the arithmetic on configurations: laws for every kind of joint, and refused states. A
// new kind of joint needs one line in models().
#include "burnish/model/state.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/refusal.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

constexpr double pi = std::numbers::pi;

struct NamedModel {
  std::string name;
  Model model;
};

Model one_joint(JointType type) {
  TreeSpec tree;
  tree.links = {link("base"), link("body")};
  tree.joints = {joint("joint", type, "base", "body", Eigen::Vector3d(1.0, 2.0, 2.0) / 3.0)};
  return build_model(tree);
}

const std::vector<NamedModel>& models() {
  static const std::vector<NamedModel> all = [] {
    std::mt19937_64 generator(21);
    ModelOptions options;
    options.base = Base::FreeFlyer;
    return std::vector<NamedModel>{
        {"Revolute", one_joint(JointType::Revolute)},
        {"Continuous", one_joint(JointType::Continuous)},
        {"Prismatic", one_joint(JointType::Prismatic)},
        {"Planar", one_joint(JointType::Planar)},
        {"Floating", one_joint(JointType::Floating)},
        {"Ball", one_joint(JointType::Ball)},
        {"Tree", build_model(random_tree(generator, 18), options)},
    };
  }();
  return all;
}

class StateLaws : public ::testing::TestWithParam<std::size_t> {
 protected:
  const Model& model() const { return models()[GetParam()].model; }
  Eigen::VectorXd random_q() { return random_configuration(model(), generator_); }
  /// Entries within +-size.
  Eigen::VectorXd random_v(double size) {
    Eigen::VectorXd v(model().nv);
    for (int i = 0; i < model().nv; ++i) v[i] = uniform(generator_, -size, size);
    return v;
  }
  std::mt19937_64 generator_{22};
};

TEST_P(StateLaws, Difference_UndoesIntegrate) {
  // Rotations stay below half a turn: 1.7 * sqrt(3) < pi.
  for (const double size : {1.7, 1.0, 1e-2, 1e-5, 1e-9, 0.0}) {
    for (int round = 0; round < 30; ++round) {
      const Eigen::VectorXd q = random_q(), v = random_v(size);
      const Eigen::VectorXd back = difference(model(), q, integrate(model(), q, v));
      EXPECT_LT((back - v).cwiseAbs().maxCoeff(), 1e-13 + 1e-12 * size) << "size " << size;
    }
  }
}

TEST_P(StateLaws, Integrate_UndoesDifference) {
  for (int round = 0; round < 100; ++round) {
    const Eigen::VectorXd q0 = random_q(), q1 = random_q();
    const Eigen::VectorXd there = integrate(model(), q0, difference(model(), q0, q1));
    // A quaternion and its opposite are one rotation, so the remaining difference is compared.
    EXPECT_LT(difference(model(), there, q1).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(StateLaws, TwoHalfSteps_EqualOneStep) {
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXd q = random_q(), v = random_v(1.5);
    const Eigen::VectorXd halves = integrate(model(), integrate(model(), q, 0.5 * v), 0.5 * v);
    EXPECT_LT(difference(model(), integrate(model(), q, v), halves).cwiseAbs().maxCoeff(), 1e-13);
  }
}

TEST_P(StateLaws, Integrate_MovesBodiesAlongTheirTwist) {
  // The body's placement moves by exp of its joint's twist, a matrix exponential by its series.
  for (int round = 0; round < 10; ++round) {
    const Eigen::VectorXd q = random_q(), v = random_v(0.8);
    const Joint& last = model().joints.back();
    Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Zero();
    const Eigen::VectorXd own = v.segment(last.v_index, last.nv);
    if (last.nv == 6) twist = own;
    if (last.kind == JointKind::Ball)
      twist.tail<3>() = own;
    else if (last.nv == 3)
      twist << own[0], own[1], 0.0, 0.0, 0.0, own[2];
    if (last.nv == 1) twist[last.kind == JointKind::Prismatic ? 2 : 5] = own[0];
    Eigen::Matrix4d generator = Eigen::Matrix4d::Zero(), term = Eigen::Matrix4d::Identity();
    generator << 0.0, -twist[5], twist[4], twist[0], twist[5], 0.0, -twist[3], twist[1], -twist[4],
        twist[3], 0.0, twist[2], 0.0, 0.0, 0.0, 0.0;
    Eigen::Matrix4d exponential = term;
    for (int k = 1; k < 30; ++k) exponential += (term = term * generator / k);
    Eigen::VectorXd only_last = Eigen::VectorXd::Zero(model().nv);
    only_last.segment(last.v_index, last.nv) = own;
    const Eigen::Matrix4d before = body_placements(model(), q).back().matrix();
    const Eigen::Matrix4d after =
        body_placements(model(), integrate(model(), q, only_last)).back().matrix();
    EXPECT_LT((before * exponential - after).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST_P(StateLaws, TangentMap_IsTheDerivativeOfIntegrate) {
  const double step = 1e-5;
  for (int round = 0; round < 10; ++round) {
    const Eigen::VectorXd q = random_q();
    const Eigen::MatrixXd map = tangent_map(model(), q);
    ASSERT_EQ(map.rows(), model().nq);
    ASSERT_EQ(map.cols(), model().nv);
    for (int k = 0; k < model().nv; ++k) {
      const Eigen::VectorXd v = step * Eigen::VectorXd::Unit(model().nv, k);
      const Eigen::VectorXd slope =
          (integrate(model(), q, v) - integrate(model(), q, -v)) / (2.0 * step);
      EXPECT_LT((slope - map.col(k)).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

TEST_P(StateLaws, ManySteps_KeepUnitLength) {
  Eigen::VectorXd q = random_q();
  for (int i = 0; i < 2000; ++i) q = integrate(model(), q, random_v(0.5));
  EXPECT_LT((normalized(model(), q) - q).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NO_THROW(check_configuration(model(), q));
}

TEST_P(StateLaws, Normalized_UndoesScaling) {
  const Eigen::VectorXd q = random_q();
  Eigen::VectorXd scaled = q;
  for (const Joint& spec : model().joints) {
    if (spec.kind == JointKind::Continuous) scaled.segment<2>(spec.q_index) *= 3.0;
    if (spec.kind == JointKind::Planar) scaled.segment<2>(spec.q_index + 2) *= 0.2;
    if (spec.kind == JointKind::FreeFlyer) scaled.segment<4>(spec.q_index + 3) *= 7.0;
    if (spec.kind == JointKind::Ball) scaled.segment<4>(spec.q_index) *= 5.0;
  }
  EXPECT_LT((normalized(model(), scaled) - q).cwiseAbs().maxCoeff(), 1e-14);
}

TEST_P(StateLaws, RandomConfiguration_IsValidAndRepeatable) {
  std::mt19937_64 one(5), two(5);
  const Eigen::VectorXd q = random_configuration(model(), one);
  EXPECT_EQ(q, random_configuration(model(), two));
  EXPECT_NE(q, random_configuration(model(), two));
  EXPECT_NO_THROW(check_configuration(model(), q));
}

TEST(RandomConfiguration, UnreachableLimits_AreIgnored) {
  TreeSpec tree = branching_tree();
  for (JointSpec& joint : tree.joints) {
    joint.lower = -1e16;
    joint.upper = 1e16;
  }
  const Model model = build_model(tree);
  std::mt19937_64 generator(5);
  for (int i = 0; i < 20; ++i)
    EXPECT_LE(random_configuration(model, generator).cwiseAbs().maxCoeff(), 3.15);
}

TEST_P(StateLaws, InvalidArgument_IsNamedWithItsEntry) {
  const Eigen::VectorXd q = random_q(), v = random_v(1.0);
  EXPECT_NO_THROW(check_tangent(model(), v));
  const Eigen::VectorXd long_q = Eigen::VectorXd::Zero(model().nq + 1);
  const Eigen::VectorXd long_v = Eigen::VectorXd::Zero(model().nv + 1);
  expect_words(refusal([&] { check_configuration(model(), long_q, "q_start"); }),
               {"'q_start'", std::to_string(model().nq + 1), std::to_string(model().nq)});
  expect_words(refusal([&] { check_tangent(model(), long_v, "tau"); }), {"'tau'"});
  expect_words(refusal([&] { integrate(model(), long_q, v); }), {"'q'"});
  expect_words(refusal([&] { integrate(model(), q, long_v); }), {"'dq'"});
  expect_words(refusal([&] { difference(model(), long_q, q); }), {"'q0'"});
  expect_words(refusal([&] { difference(model(), q, long_q); }), {"'q1'"});
  EXPECT_THROW(tangent_map(model(), long_q), Error);
  EXPECT_THROW(normalized(model(), long_q), Error);
  Eigen::VectorXd bad = q;
  bad[model().nq - 1] = std::numeric_limits<double>::quiet_NaN();
  expect_words(refusal([&] { check_configuration(model(), bad); }),
               {"'q'", "entry " + std::to_string(model().nq - 1), "nan"});
  Eigen::VectorXd bad_v = v;
  bad_v[0] = std::numeric_limits<double>::infinity();
  expect_words(refusal([&] { check_tangent(model(), bad_v); }), {"'v'", "entry 0", "inf"});
}

INSTANTIATE_TEST_SUITE_P(State, StateLaws, ::testing::Range(std::size_t{0}, models().size()),
                         [](const auto& test) { return models()[test.param].name; });

TEST(State, Difference_TakesTheShortestPath) {
  const Model model = one_joint(JointType::Continuous);
  const Eigen::Vector2d from(std::cos(3.0), std::sin(3.0)), to(std::cos(-3.0), std::sin(-3.0));
  EXPECT_NEAR(difference(model, from, to)[0], 2.0 * pi - 6.0, 1e-14);
  const Model floating = one_joint(JointType::Floating);
  Eigen::VectorXd q = floating.q_neutral, opposite = q;
  opposite.tail<4>() *= -1.0;
  EXPECT_LT(difference(floating, q, opposite).norm(), 1e-15);
  const Model ball = one_joint(JointType::Ball);
  EXPECT_LT(difference(ball, ball.q_neutral, -ball.q_neutral).norm(), 1e-15);
}

TEST(State, RotationNearHalfATurn_StaysAccurate) {
  const Model model = one_joint(JointType::Floating);
  for (const double short_of : {0.0, 1e-12, 1e-8, 1e-4}) {
    Eigen::VectorXd v = Eigen::VectorXd::Zero(6);
    v << 1.0, -2.0, 3.0, 0.0, (pi - short_of) * 0.6, (pi - short_of) * 0.8;
    const Eigen::VectorXd q = integrate(model, model.q_neutral, v);
    const Eigen::VectorXd back = difference(model, model.q_neutral, q);
    const Eigen::VectorXd there = integrate(model, model.q_neutral, back);
    EXPECT_LT((difference(model, q, there)).norm(), 1e-13);
  }
}

TEST(State, RotationNotOfUnitLength_IsRefused) {
  const Model floating = one_joint(JointType::Floating);
  Eigen::VectorXd q = floating.q_neutral;
  q[6] = 1.0 + 2e-6;
  expect_words(refusal([&] { check_configuration(floating, q); }),
               {"'q'", "quaternion", "'joint'", "entry 3"});
  q[6] = 1.0 + 0.5e-6;
  EXPECT_NO_THROW(check_configuration(floating, q));
  q.tail<4>().setZero();
  expect_words(refusal([&] { normalized(floating, q); }), {"'joint'"});
  const Model ball = one_joint(JointType::Ball);
  q = ball.q_neutral;
  q[0] = 0.1;
  expect_words(refusal([&] { check_configuration(ball, q); }), {"quaternion", "entry 0"});
  const Model planar = one_joint(JointType::Planar);
  q = planar.q_neutral;
  q[3] = 0.1;
  expect_words(refusal([&] { check_configuration(planar, q); }), {"(cos, sin)", "entry 2"});
}

TEST(RandomConfiguration, FiniteLimits_AreKept) {
  TreeSpec tree;
  tree.links = {link("base"), link("a"), link("b"), link("c")};
  tree.joints = {joint("a", JointType::Revolute, "base", "a"),
                 joint("b", JointType::Prismatic, "a", "b"),
                 joint("c", JointType::Prismatic, "b", "c")};
  tree.joints[0].lower = 1.0;
  tree.joints[0].upper = 1.5;
  tree.joints[1].lower = 10.0;
  tree.joints[2].upper = -10.0;
  const Model model = build_model(tree);
  std::mt19937_64 generator(6);
  for (int i = 0; i < 200; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    EXPECT_GE(q[0], 1.0);
    EXPECT_LE(q[0], 1.5);
    EXPECT_GE(q[1], 10.0);
    EXPECT_LE(q[1], 12.0);
    EXPECT_GE(q[2], -12.0);
    EXPECT_LE(q[2], -10.0);
  }
}

TEST(ImplausibleState, ValuesFarBeyondLimits_AreNamed) {
  TreeSpec tree = two_links();
  tree.joints[0].lower = -2.0;
  tree.joints[0].upper = 2.0;
  tree.joints[0].velocity_limit = 3.0;
  tree.joints[0].effort_limit = 50.0;
  const Model model = build_model(tree);
  const auto about = [&](const Eigen::Vector2d& q, const Eigen::Vector2d& v,
                         const Eigen::Vector2d& tau) { return odd_state(model, q, v, tau); };
  const Eigen::Vector2d none = Eigen::Vector2d::Zero();
  EXPECT_EQ(about({7.0, 9e3}, {29.0, 9e3}, {499.0, 1e8}), std::vector<std::string>{});
  std::vector<std::string> found = about({90.0, 2e4}, none, none);
  ASSERT_EQ(found.size(), 2U);
  expect_words(found[0], {"'shoulder' is at 90 rad", "limits are -2 and 2", "degrees"});
  expect_words(found[1], {"'elbow' is at 20000 rad", "at most 10000"});
  found = about(none, {-31.0, 1e5}, {-501.0, 0.0});
  ASSERT_EQ(found.size(), 3U);
  expect_words(found[0], {"velocity of 'shoulder' is -31", "limit is 3"});
  expect_words(found[1], {"velocity of 'elbow' is 100000"});
  expect_words(found[2], {"torque of 'shoulder' is -501", "limit is 50"});
}

TEST(BeyondLimits, Configuration_NamesTheFarthestJoint) {
  TreeSpec tree = two_links();
  for (JointSpec& joint : tree.joints) {
    joint.lower = -2.0;
    joint.upper = 1.0;
  }
  const Model model = build_model(tree);
  EXPECT_EQ(beyond_limits(model, Eigen::Vector2d(-2.00005, 1.0)), "") << "rounding";
  EXPECT_EQ(beyond_limits(model, Eigen::Vector2d(1.1, -2.3)),
            "joint 'elbow' is at -2.3 rad; its limits are -2 and 1 rad");
  EXPECT_EQ(beyond_limits(model, Eigen::Vector2d(1.1, -2.3), 0.5), "");
}

TEST(ImplausibleState, ValueBeyondTheResolution_IsRefused) {
  const Model model = build_model(two_links());
  expect_words(
      refusal([&] { check_configuration(model, Eigen::Vector2d(0.0, 1e20)); }),
      {"'q'", "'elbow' is 1e+20", "floating-point numbers differ by 16384", "at most 1e+09"});
  expect_words(refusal([&] { check_tangent(model, Eigen::Vector2d(-2e9, 0.0)); }),
               {"'v'", "'shoulder' is -2e+09"});
  EXPECT_NO_THROW(check_configuration(model, Eigen::Vector2d(1e9, 0.0)));
}

}  // namespace
}  // namespace burnish::testing
