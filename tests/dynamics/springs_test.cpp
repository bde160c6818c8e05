// Tests of springs in joints, and of springs and dampers of tendons.
#include "dynamics/springs.tpp"

#include <numbers>

#include "burnish/derivatives/rigid_body.hpp"
#include "support/kernel_law.hpp"

namespace burnish::test {
namespace {

struct SpringKernel {
  template <class S>
  std::vector<S> values(const S* q, const S* v, const S* /*a*/) const {
    std::vector<S> tau(n, S(0.0));
    add_spring_torque(springs, q, v, tau.data());
    return tau;
  }
  template <class S>
  Blocks<S> derivatives(const S* q, const S* /*v*/, const S* /*a*/) const {
    std::vector<S> slopes(springs.places.size());
    spring_slopes(springs, q, slopes.data());
    Blocks<S> out{std::vector<S>(n * n, S(0.0)), std::vector<S>(n * n, S(0.0))};
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      const Springs::Place& at = springs.places[i];
      const std::size_t place = static_cast<std::size_t>(at.row) * n + at.column;
      out.dq[place] = slopes[i];
      out.dv[place] = S(at.by_v);
    }
    return out;
  }
  Springs springs;
  std::size_t n;
};

SpringKernel kernel_of(const Model& model) {
  return {Springs(model), static_cast<std::size_t>(model.nv)};
}

Model model_with_springs() { return compiled(tree_of_every_joint(), Base::FreeFlyer); }

TEST(Springs, Derivatives_EqualAutodiffAndDifferences) {
  expect_kernel_law(model_with_springs(), kernel_of(model_with_springs()));
  expect_lanes_alike(model_with_springs(), kernel_of(model_with_springs()));
}

TEST(Springs, Torque_IsTheNegativeGradientOfTheEnergy) {
  const Model model = model_with_springs();
  const SpringKernel kernel = kernel_of(model);
  std::mt19937_64 generator(3);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(model.nv);
  for (int i = 0; i < 10; ++i) {
    const KernelState s = random_kernel_state(model, generator);
    const auto energy = [&](double h, int k) {
      const Eigen::VectorXd q = integrate(model, s.q, h * Eigen::VectorXd::Unit(model.nv, k));
      return spring_energy(kernel.springs, q.data());
    };
    EXPECT_GT(energy(0.0, 0), 0.0);
    const auto tau = kernel.values<double>(s.q.data(), rest.data(), nullptr);
    for (int k = 0; k < model.nv; ++k)
      EXPECT_NEAR(tau[static_cast<std::size_t>(k)], -(energy(1e-6, k) - energy(-1e-6, k)) / 2e-6,
                  1e-7);
  }
}

TEST(Springs, PassiveTorqueOfARigidBody_ContainsSprings) {
  Model model = model_with_springs();
  model.damping.setConstant(0.3);
  const SpringKernel kernel = kernel_of(model);
  RigidBody body(model);
  std::mt19937_64 generator(4);
  const KernelState s = random_kernel_state(model, generator);
  ASSERT_EQ(body.update(s.q, s.v), Status::Ok);
  body.update_derivatives();
  const auto blocks = kernel.derivatives<double>(s.q.data(), s.v.data(), nullptr);
  const Eigen::VectorXd tau =
      as_vector(kernel.values<double>(s.q.data(), s.v.data(), nullptr)) - 0.3 * s.v;
  EXPECT_LE(relative_error(body.passive_torque(), tau), 1e-14);
  EXPECT_LE(relative_error(body.passive_torque_dq(), as_matrix(blocks.dq, model.nv)), 1e-15);
  const Eigen::MatrixXd dv =
      as_matrix(blocks.dv, model.nv) - 0.3 * Eigen::MatrixXd::Identity(model.nv, model.nv);
  body.update_derivatives();  // a second call changes nothing
  EXPECT_LE(relative_error(body.passive_torque_dv(), dv), 1e-15);
  EXPECT_EQ(body.spring_energy(), spring_energy(kernel.springs, s.q.data()));
}

TEST(Springs, DescriptionWithoutSprings_HasNone) {
  const Model model = compiled(tree_with_followers(), Base::Fixed);
  EXPECT_TRUE(Springs(model).empty());
}

/// Two hinges; the second one is continuous.
TreeSpec hinges() {
  TreeSpec tree = testing::two_links();
  tree.joints[1].type = JointType::Continuous;
  return tree;
}
Eigen::VectorXd torque(const TreeSpec& tree, const Posture& posture,
                       const ModelOptions& options = {}) {
  const Model model = build_model(tree, options);
  const Eigen::VectorXd q = configuration(model, posture);
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv), v = tau;
  add_spring_torque(Springs(model), q.data(), v.data(), tau.data());
  return tau;
}

TEST(Springs, JointAwayFromRest_IsPulledBackByTheShortestRotation) {
  TreeSpec tree = hinges();
  tree.joints[0].stiffness = 2.0, tree.joints[0].rest = 0.5;
  tree.joints[1].stiffness = 3.0, tree.joints[1].rest = 3.0;
  Eigen::VectorXd tau = torque(tree, {{"shoulder", {7.0}}, {"elbow", {-3.0}}});
  EXPECT_NEAR(tau[0], -2.0 * 6.5, 1e-12);
  EXPECT_NEAR(tau[1], -3.0 * (2.0 * std::numbers::pi - 6.0), 1e-12);
  tree.joints[1].type = JointType::Ball;
  tree.joints[1].rest = 0.0;
  tau = torque(tree, {{"elbow", {0.0, std::sin(0.3), 0.0, std::cos(0.3)}}});
  EXPECT_LT((tau.tail<3>() - Eigen::Vector3d(0.0, -1.8, 0.0)).norm(), 1e-12);
}

/// Virtual work maps the spring torque of a follower to its leader.
TEST(Springs, SpringOfAFollower_ActsOnItsLeader) {
  TreeSpec tree = testing::two_links();
  tree.joints[0].stiffness = 2.0, tree.joints[0].rest = 0.5;
  tree.joints[1].stiffness = 3.0, tree.joints[1].rest = -0.4;
  tree.joints[1].mimic = MimicSpec{"shoulder", -1.5, 0.2};
  for (const double q : {-1.0, 0.0, 0.7}) {
    const double leader_torque = -2.0 * (q - 0.5), follower_torque = -3.0 * (-1.5 * q + 0.2 + 0.4);
    EXPECT_NEAR(torque(tree, {{"shoulder", {q}}})[0], leader_torque - 1.5 * follower_torque, 1e-12);
  }
  tree.joints[1].mimic->multiplier = 0.0;
  EXPECT_NEAR(torque(tree, {{"shoulder", {0.9}}})[0], -2.0 * 0.4, 1e-12);
}

TEST(Springs, SpringsOfContinuousFollowers_AddUp) {
  TreeSpec tree = hinges();
  tree.joints[0].type = JointType::Continuous;
  tree.joints[0].stiffness = 2.0, tree.joints[0].rest = 0.5;
  tree.joints[1].stiffness = 3.0, tree.joints[1].rest = -0.3;
  tree.joints[1].mimic = MimicSpec{"shoulder", -1.0, 0.2};
  EXPECT_NEAR(torque(tree, {{"shoulder", {1.5}}})[0], -5.0, 1e-12);
}

TEST(TendonSpring, StretchedTendon_PullsFreeJointsAndLeaders) {
  TreeSpec tree = testing::two_links();
  tree.links.push_back(testing::link("far"));
  tree.joints.push_back(testing::joint("slide", JointType::Prismatic, "tip", "far"));
  tree.tendons.push_back(
      {"t", {{"shoulder", 2.0}, {"elbow", -1.0}, {"slide", 0.5}}, false, 0.1, 10.0, 4.0});
  const Posture at{{"shoulder", {0.3}}, {"elbow", {-0.6}}, {"slide", {0.2}}};
  const double force = -10.0 * (2.0 * 0.3 + 0.6 + 0.1 - 0.1);
  Eigen::VectorXd tau = torque(tree, at);
  EXPECT_LT((tau - force * Eigen::Vector3d(2.0, -1.0, 0.5)).norm(), 1e-12);
  ModelOptions options;
  options.locked = {"elbow"};
  options.posture = at;
  tau = torque(tree, at, options);
  EXPECT_LT((tau - force * Eigen::Vector2d(2.0, 0.5)).norm(), 1e-12);
  tree.joints[1].mimic = MimicSpec{"shoulder", -2.0, 0.0};
  tau = torque(tree, {{"shoulder", {0.3}}, {"slide", {0.2}}});
  EXPECT_LT((tau - force * Eigen::Vector2d(4.0, 0.5)).norm(), 1e-12);
}

}  // namespace
}  // namespace burnish::test
