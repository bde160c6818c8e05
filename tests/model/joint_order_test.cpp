// Tests of the order of joints and of conversions to the orders and conventions of other programs.
#include "burnish/model/joint_order.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "burnish/model/state.hpp"
#include "support/refusal.hpp"
#include "support/trees.hpp"

namespace burnish::testing {
namespace {

using Eigen::VectorXd;

VectorXd vector(std::initializer_list<double> values) {
  return Eigen::Map<const VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

/// Joints of all kinds on one base, not listed in the order of their names.
TreeSpec star(SiblingOrder order) {
  TreeSpec tree;
  tree.name = "star";
  tree.sibling_order = order;
  tree.links = {link("base")};
  const auto add = [&](const std::string& name, JointType type) {
    tree.links.push_back(link("of_" + name));
    tree.joints.push_back(joint(name, type, "base", "of_" + name));
  };
  add("turn", JointType::Revolute);
  add("ball", JointType::Ball);
  add("float", JointType::Floating);
  add("copy", JointType::Revolute);
  add("circle", JointType::Continuous);
  add("plane", JointType::Planar);
  add("arm", JointType::Prismatic);
  tree.joints[3].mimic = MimicSpec{"turn", -2.0, 0.1};
  return tree;
}

std::vector<std::string> names_of(const Model& model) {
  std::vector<std::string> names;
  for (const Joint& joint : model.joints) names.push_back(joint.name);
  return names;
}

TEST(SiblingOrder, EitherChoice_SortsByNameOrAsListed) {
  EXPECT_EQ(names_of(build_model(star(SiblingOrder::ByName))),
            (std::vector<std::string>{"arm", "ball", "circle", "copy", "float", "plane", "turn"}));
  EXPECT_EQ(names_of(build_model(star(SiblingOrder::AsListed))),
            (std::vector<std::string>{"turn", "ball", "float", "copy", "circle", "plane", "arm"}));
}

TEST(JointOrder, ListOfNames_MapsToEntries) {
  const Model model = build_model(star(SiblingOrder::ByName));
  const JointOrder order(model, {"turn", "copy", "arm", "circle", "plane", "ball", "float"});
  EXPECT_EQ(order.nq(), 1 + 1 + 1 + 1 + 3 + 4 + 7);
  EXPECT_EQ(order.nv(), 1 + 1 + 1 + 1 + 3 + 3 + 6);
  const VectorXd theirs =
      vector({0.3, -0.5, 0.7, 0.9, 1, 2, 0.4, 0, 0.6, 0, 0.8, 3, 4, 5, 0.8, 0, 0, 0.6});
  const VectorXd q = order.q_from(theirs);
  EXPECT_NO_THROW(check_configuration(model, q));
  const auto at = [&](const char* name) {
    const Joint& joint = model.joints[static_cast<std::size_t>(model.joint_index(name))];
    return VectorXd(q.segment(joint.q_index, joint.nq));
  };
  EXPECT_EQ(at("turn"), vector({0.3}));
  EXPECT_EQ(at("arm"), vector({0.7}));
  EXPECT_TRUE(at("circle").isApprox(vector({std::cos(0.9), std::sin(0.9)})));
  EXPECT_TRUE(at("plane").isApprox(vector({1, 2, std::cos(0.4), std::sin(0.4)})));
  EXPECT_TRUE(at("ball").isApprox(vector({0, 0.6, 0, 0.8})));
  EXPECT_TRUE(at("float").isApprox(vector({3, 4, 5, 0.8, 0, 0, 0.6})));
  EXPECT_TRUE(order.q_to(q).isApprox(theirs));
}

class JointConventions : public ::testing::TestWithParam<JointConvention> {};

TEST_P(JointConventions, Conversion_RoundTripsAndKeepsThePower) {
  const Model model = build_model(star(SiblingOrder::ByName));
  const JointOrder order(model, {"plane", "float", "ball", "turn", "circle", "arm"}, GetParam());
  std::mt19937_64 generator(4);
  for (int i = 0; i < 10; ++i) {
    const VectorXd q = random_configuration(model, generator);
    VectorXd v(model.nv), tau(model.nv);
    for (double& x : v) x = uniform(generator, -1.0, 1.0);
    for (double& x : tau) x = uniform(generator, -1.0, 1.0);
    EXPECT_TRUE(order.q_from(order.q_to(q)).isApprox(q, 1e-14));
    const VectorXd their_v = order.v_to(v, q), their_tau = order.tau_to(tau, q);
    EXPECT_TRUE(order.v_from(their_v, q).isApprox(v, 1e-14));
    EXPECT_TRUE(order.tau_from(their_tau, q).isApprox(tau, 1e-14));
    EXPECT_NEAR(their_v.dot(their_tau), v.dot(tau), 1e-13) << "power";
  }
}

INSTANTIATE_TEST_SUITE_P(All, JointConventions,
                         ::testing::Values(JointConvention::Angles, JointConvention::Same,
                                           JointConvention::Mujoco));

TEST(JointOrder, MujocoConvention_HasWFirstAndLinearVelocityInTheWorld) {
  const Model model = build_model(star(SiblingOrder::ByName));
  const JointOrder order(model, {"float", "arm", "ball", "circle", "plane", "turn"},
                         JointConvention::Mujoco);
  VectorXd theirs = VectorXd::Zero(order.nq());
  theirs.head<12>() << 1, 2, 3, std::sqrt(0.5), 0, 0, std::sqrt(0.5), 0, 0.8, 0.6, 0, 0;
  const VectorXd q = order.q_from(theirs);
  const auto index = [&](const char* name) {
    return model.joints[static_cast<std::size_t>(model.joint_index(name))];
  };
  EXPECT_NEAR(q[index("float").q_index + 6], std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(q[index("ball").q_index + 3], 0.8, 1e-15);
  VectorXd velocities = VectorXd::Zero(order.nv());
  velocities[0] = 1.0;  // along x of the world; the body is a quarter turn about z
  const VectorXd v = order.v_from(velocities, q);
  EXPECT_NEAR(v[index("float").v_index + 1], -1.0, 1e-15);
}

TEST(JointOrder, Followers_AreAddedToTheirLeaders) {
  const Model model = build_model(star(SiblingOrder::ByName));
  const JointOrder order(model, {"turn", "copy"});
  const VectorXd tau = order.tau_from(vector({1.0, 0.25}), model.q_neutral);
  const Joint& turn = model.joints[static_cast<std::size_t>(model.joint_index("turn"))];
  EXPECT_EQ(tau[turn.v_index], 1.0 - 2.0 * 0.25);
  EXPECT_EQ(tau.cwiseAbs().sum(), 0.5) << "joints that are left out have no torque";
  VectorXd v = VectorXd::Zero(model.nv);
  v[turn.v_index] = 0.5;
  EXPECT_EQ(order.v_to(v, model.q_neutral), vector({0.5, -1.0}));
}

TEST(JointOrder, LockedJoints_HaveTheirLockedValues) {
  ModelOptions options;
  options.locked = {"arm", "circle", "ball"};
  options.posture = {{"arm", {0.4}}, {"circle", {1.2}}, {"ball", {0.6, 0, 0, 0.8}}};
  const Model model = build_model(star(SiblingOrder::AsListed), options);
  const JointOrder order = JointOrder::mujoco(model);
  EXPECT_EQ(order.names(),
            (std::vector<std::string>{"turn", "ball", "float", "copy", "circle", "plane", "arm"}));
  const VectorXd theirs = order.q_to(model.q_neutral);
  EXPECT_TRUE(
      theirs.isApprox(vector({0, 0.8, 0.6, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0.1, 1.2, 0, 0, 0, 0.4})));
  EXPECT_TRUE(order.q_from(theirs).isApprox(model.q_neutral));
  VectorXd moved = theirs;
  moved[17] = 0.5;
  expect_words(refusal([&] { order.q_from(moved); }),
               {"'star'", "'arm'", "differs by 0.1", "locked"});
  EXPECT_NO_THROW(order.q_from(moved, 0.2));
  moved = theirs;
  moved[12] = 0.3;
  expect_words(refusal([&] { order.q_from(moved); }), {"'copy'", "differs by 0.2", "leader"});
}

TEST(JointOrder, InvalidNamesOrNumbers_AreRefused) {
  const Model model = build_model(star(SiblingOrder::ByName));
  const auto refused = [&](std::vector<std::string> names) {
    return refusal([&] { JointOrder(model, std::move(names)); });
  };
  expect_words(refused({"trun"}),
               {"robot 'star'", "'trun'", "does not exist", "did you mean 'turn'?"});
  expect_words(refused({"arm", ""}), {"joint number 2", "no name"});
  expect_words(refused({"arm", "arm"}), {"'arm' is twice"});
  const JointOrder part(model, {"arm", "turn"});
  expect_words(refusal([&] {
                 part.q_from(vector({0, 0}));
               }),
               {"leaves out", "'ball'", "'circle'", "'float'", "'plane'"});
  expect_words(refusal([&] { part.v_from(vector({0, 0}), model.q_neutral); }), {"leaves out"});
  expect_words(refusal([&] {
                 part.tau_from(vector({0, 0, 0}), model.q_neutral);
               }),
               {"torques have 3 entries", "wanted 2"});
  const double undefined = std::numeric_limits<double>::quiet_NaN();
  expect_words(refusal([&] {
                 part.tau_from(vector({0, undefined}), model.q_neutral);
               }),
               {"torques are not finite"});
  const JointOrder whole = JointOrder::mujoco(model);
  VectorXd theirs = whole.q_to(model.q_neutral);
  theirs[1] = 0.5;  // w of the ball
  expect_words(refusal([&] { whole.q_from(theirs); }), {"'ball'", "quaternion", "length"});
}

}  // namespace
}  // namespace burnish::testing
