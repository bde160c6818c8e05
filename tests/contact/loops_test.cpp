// Tests of kinematic loops: contacts, mobility, projections and dynamics.
#include "burnish/contact/loops.hpp"

#include <gtest/gtest.h>

#include "base/decomposition.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "support/loop_trees.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using Eigen::VectorXd;

VectorXd random_vector(int n, std::mt19937_64& generator) {
  VectorXd x(n);
  for (double& entry : x) entry = uniform(generator, -1.0, 1.0);
  return x;
}

/// A posture that closes the loops, near a random one.
VectorXd closed(const Model& model, std::mt19937_64& generator) {
  for (int tries = 0; tries < 100; ++tries) {
    const VectorXd away = 0.5 * random_vector(model.nv, generator);
    const VectorXd from = integrate(model, model.q_neutral, away);
    const LoopProjection on = project_onto_loops(model, from);
    if (on.status == Status::Ok) return on.q;
  }
  ADD_FAILURE() << "no posture closes the loops";
  return model.q_neutral;
}

Eigen::Isometry3d apart(const Model& model, const VectorXd& q, const std::string& loop) {
  return frame_placement(model, q, loop + "/first").inverse() *
         frame_placement(model, q, loop + "/second");
}

TEST(LoopContacts, Loop_TiesTheSecondFrameToTheFirst) {
  const Model model = build_model(four_bar());
  const std::vector<ContactSpec> contacts = loop_contacts(model, {25.0, 10.0}, true);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_EQ(contacts[0].name, "pin");
  EXPECT_EQ(contacts[0].tool, "pin/second");
  EXPECT_EQ(contacts[0].base, "pin/first");
  EXPECT_EQ(contacts[0].directions, Directions::linear());
  EXPECT_EQ(contacts[0].kp[0], 25.0);
  EXPECT_EQ(contacts[0].kd[2], 10.0);
  EXPECT_TRUE(is_loop(model, contacts[0]));
}

TEST(LoopContacts, PlanarLoop_LeavesOutRedundantDirections) {
  // The hinges are along y: only x and z of the pin move.
  EXPECT_EQ(loop_contacts(build_model(four_bar()))[0].directions.text(), "x,z");
  const Directions pin = Directions::parse("x,y,z,rx,rz");
  EXPECT_EQ(loop_contacts(build_model(four_bar(pin)))[0].directions.text(), "x,z");
  TreeSpec turned = four_bar();
  turned.loops[0].first.linear() =
      Eigen::AngleAxisd(0.9, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  EXPECT_EQ(loop_contacts(build_model(turned))[0].directions.count(), 2);
  // Ball joints of a tripod need all three directions.
  for (const ContactSpec& contact : loop_contacts(build_model(tripod())))
    EXPECT_EQ(contact.directions, Directions::linear());
}

TEST(LoopContacts, PosturesThatCloseTheLoops_HaveIndependentRows) {
  std::mt19937_64 generator(3);
  for (const TreeSpec& tree :
       {four_bar(), four_bar(Directions::parse("x,y,z,rx,rz")), tripod(true), tripod(false)}) {
    const Model model = build_model(tree);
    const ContactSet set(model, loop_contacts(model));
    for (int i = 0; i < 5; ++i)
      EXPECT_TRUE(diagnose(model, set, closed(model, generator)).redundant.empty()) << tree.name;
  }
}

TEST(LoopContacts, WithLoops_AddsEachLoopOnce) {
  const Model model = build_model(four_bar());
  ContactSpec own{.name = "press", .tool = "rocker"};
  const std::vector<ContactSpec> all = with_loops(model, {own});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "press");
  EXPECT_EQ(all[1].name, "pin");
  EXPECT_EQ(with_loops(model, all).size(), 2U);
  own.name = "pin";
  expect_words(refusal([&] { with_loops(model, {own}); }), {"contact 'pin'", "name as a loop"});
}

TEST(LoopFreedom, RedundantRows_AreCountedAndNamed) {
  const Model model = build_model(four_bar(Directions::parse("x,y,z,rx,rz")));
  std::mt19937_64 generator(4);
  const LoopFreedom freedom = loop_freedom(model, closed(model, generator));
  EXPECT_EQ(freedom.rows, 5);
  EXPECT_EQ(freedom.rank, 2);
  EXPECT_EQ(freedom.freedom, 1);
  EXPECT_EQ(freedom.text(), "pin: y, rx, rz redundant\n");
  const Model legs = build_model(tripod());
  const LoopFreedom of_legs = loop_freedom(legs, closed(legs, generator));
  EXPECT_EQ(of_legs.rank, 9);
  EXPECT_EQ(of_legs.freedom, 3);
  EXPECT_EQ(of_legs.text(), "");
}

TEST(LoopProjection, RandomPosture_ClosesTheLoops) {
  std::mt19937_64 generator(5);
  for (const TreeSpec& tree : {four_bar(), tripod()}) {
    const Model model = build_model(tree);
    for (int i = 0; i < 20; ++i) {
      const VectorXd q = closed(model, generator);
      for (const Loop& loop : model.loops)
        EXPECT_LT(apart(model, q, loop.name).translation().norm(), 2e-9) << tree.name;
      for (const LoopMiss& miss : loop_misses(model, q)) EXPECT_LT(miss.translation, 2e-9);
    }
  }
}

TEST(LoopProjection, WeldedLoop_ClosesRotationsToo) {
  TreeSpec tree = tripod();
  tree.loops.resize(1);
  tree.loops[0].directions = Directions::all();
  const Model model = build_model(tree);
  std::mt19937_64 generator(6);
  for (int i = 0; i < 10; ++i) {
    const VectorXd away = random_vector(model.nv, generator);
    const LoopProjection on = project_onto_loops(model, integrate(model, model.q_neutral, away));
    ASSERT_EQ(on.status, Status::Ok) << on.explanation();
    EXPECT_TRUE(apart(model, on.q, "ball_0").isApprox(Eigen::Isometry3d::Identity(), 1e-8));
  }
}

TEST(LoopProjection, ClosedPosture_IsUnchanged) {
  const Model model = build_model(four_bar());
  std::mt19937_64 generator(7);
  const VectorXd q = closed(model, generator);
  const LoopProjection again = project_onto_loops(model, q);
  EXPECT_EQ(again.iterations, 0);
  EXPECT_EQ(again.q, q);
}

TEST(LoopProjection, KeptAndHeavilyWeightedJoints_StayInPlace) {
  const Model model = build_model(four_bar());
  VectorXd q(3);
  q << 0.6, 0.5, 1.8;
  const LoopProjection kept = project_onto_loops(model, q, {.keep = {"drive"}});
  ASSERT_EQ(kept.status, Status::Ok);
  EXPECT_EQ(kept.q[model.joints[model.joint_index("drive")].q_index], 0.6);
  const LoopProjection plain = project_onto_loops(model, q);
  LoopProjectionOptions weighted;
  weighted.weights = VectorXd::Ones(3);
  weighted.weights[model.joint_index("pivot")] = 1e6;
  const LoopProjection stiff = project_onto_loops(model, q, weighted);
  ASSERT_EQ(stiff.status, Status::Ok);
  EXPECT_LT(std::abs(stiff.q[2] - q[2]), 1e-3 * std::abs(plain.q[2] - q[2]) + 1e-5);
  expect_words(refusal([&] { project_onto_loops(model, q, {.keep = {"drife"}}); }),
               {"'drife'", "'drive'"});
}

TEST(LoopProjection, RandomPosture_StaysWithinLimits) {
  TreeSpec tree = four_bar();
  tree.joints[2].lower = 1.7;  // pivot
  tree.joints[2].upper = 2.0;
  tree.joints[0].lower = 0.2;
  tree.joints[0].upper = 3.0;
  const Model model = build_model(tree);
  std::mt19937_64 generator(8);
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const LoopProjection on = project_onto_loops(model, random_configuration(model, generator));
    EXPECT_TRUE((on.q.array() >= model.q_lower.array() - 1e-12).all());
    EXPECT_TRUE((on.q.array() <= model.q_upper.array() + 1e-12).all());
    found += on.status == Status::Ok ? 1 : 0;
  }
  EXPECT_GT(found, 20);
}

TEST(LoopProjection, LoopOutOfReach_IsNamedWithItsGap) {
  TreeSpec tree = four_bar();
  tree.joints[2].placement.translation().x() = 1.0;  // rocker and coupler cannot meet: 0.35 m miss
  const Model model = build_model(tree);
  const LoopProjection on = project_onto_loops(model, VectorXd::Constant(3, 0.3));
  EXPECT_EQ(on.status, Status::NotConverged);
  ASSERT_EQ(on.misses.size(), 1U);
  EXPECT_NEAR(on.misses[0].translation, 0.35, 1e-3);
  expect_words(on.explanation(), {"loop 'pin'", "350", "mm remain"});
}

TEST(LoopProjection, DeadPoint_IsSolved) {
  // All bars are along x and their tips 0.15 m apart along x, where no joint moves them.
  const Model model = build_model(four_bar());
  const LoopProjection on = project_onto_loops(model, model.q_neutral);
  EXPECT_EQ(on.status, Status::Ok);
}

TEST(LoopVelocity, Projection_IsTheNearestAllowedVelocity) {
  std::mt19937_64 generator(9);
  for (const TreeSpec& tree : {four_bar(), tripod()}) {
    const Model model = build_model(tree);
    const VectorXd q = closed(model, generator), v = random_vector(model.nv, generator);
    ContactDynamics dynamics(model, loop_contacts(model));
    ASSERT_EQ(dynamics.forward(q, v, VectorXd::Zero(model.nv)), Status::Ok);
    const Eigen::MatrixXd J = dynamics.jacobian(), M = dynamics.mass_matrix();
    const VectorXd plain = project_velocity_onto_loops(model, q, v);
    EXPECT_LT((J * plain).cwiseAbs().maxCoeff(), 1e-10);
    // The removed velocity is a combination of the rows.
    const Eigen::MatrixXd free = null_space(J);
    EXPECT_LT((free.transpose() * (v - plain)).norm(), 1e-10);
    const VectorXd impulse = project_velocity_onto_loops(model, q, v, LoopMetric::Mass);
    EXPECT_LT((J * impulse).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((free.transpose() * M * (v - impulse)).norm(), 1e-9);
  }
}

TEST(LoopVelocity, KeptJoint_KeepsItsVelocity) {
  const Model model = build_model(four_bar());
  std::mt19937_64 generator(10);
  const VectorXd q = closed(model, generator);
  VectorXd v = VectorXd::Zero(3);
  v[model.joint_index("drive")] = 0.7;
  const VectorXd kept = project_velocity_onto_loops(model, q, v, LoopMetric::Plain, {"drive"});
  EXPECT_NEAR(kept[model.joint_index("drive")], 0.7, 1e-12);
  ContactDynamics dynamics(model, loop_contacts(model));
  ASSERT_EQ(dynamics.forward(q, v, VectorXd::Zero(3)), Status::Ok);
  EXPECT_LT((dynamics.jacobian() * kept).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(ClosedConfiguration, JointsOfThePosture_KeepTheirValues) {
  const Model model = build_model(four_bar());
  const VectorXd q = closed_configuration(model, {{"drive", {0.8}}});
  EXPECT_EQ(q[model.joint_index("drive")], 0.8);
  EXPECT_LT(apart(model, q, "pin").translation().norm(), 2e-9);
  // A posture with rounded values of all joints.
  Posture rounded;
  for (const Joint& joint : model.joints)
    rounded[joint.name] = {std::round(1e3 * q[joint.q_index]) * 1e-3};
  const VectorXd near = closed_configuration(model, rounded);
  EXPECT_LT((near - q).cwiseAbs().maxCoeff(), 3e-3);
  EXPECT_LT(apart(model, near, "pin").translation().norm(), 2e-9);
}

/// Solution a and lambda of M a - J^T lambda = tau - b, J a = -alpha_0 - kd nu - kp e.
VectorXd by_kkt(const Model& model, ContactDynamics& dynamics, const VectorXd& q, const VectorXd& v,
                const VectorXd& tau) {
  const int n = model.nv, m = dynamics.rows();
  dynamics.forward(q, v, tau);
  const Eigen::MatrixXd J = dynamics.jacobian(), M = dynamics.mass_matrix();
  const VectorXd b = dynamics.bias();
  dynamics.acceleration(q, v, VectorXd::Zero(n));
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + m, n + m);
  K.topLeftCorner(n, n) = M;
  K.topRightCorner(n, m) = -J.transpose();
  K.bottomLeftCorner(m, n) = J;
  VectorXd rhs(n + m);
  rhs << tau - b, -VectorXd(dynamics.alpha());
  return K.partialPivLu().solve(rhs);
}

TEST(LoopDynamics, MotionAndForces_SolveTheKktSystem) {
  std::mt19937_64 generator(11);
  for (const TreeSpec& tree : {four_bar(), tripod()}) {
    const Model model = build_model(tree);
    ContactDynamics dynamics(model, loop_contacts(model));
    for (int i = 0; i < 20; ++i) {
      const VectorXd q = closed(model, generator), tau = random_vector(model.nv, generator);
      const VectorXd v = project_velocity_onto_loops(model, q, random_vector(model.nv, generator));
      const VectorXd want = by_kkt(model, dynamics, q, v, tau);
      ASSERT_EQ(dynamics.forward(q, v, tau), Status::Ok);
      VectorXd got(want.size());
      got << VectorXd(dynamics.a()), VectorXd(dynamics.lambda());
      EXPECT_LT((got - want).norm() / want.norm(), 1e-9) << tree.name;
    }
  }
}

TEST(LoopDynamics, AllDirectionsWithCompliance_GiveTheSameMotion) {
  const Model model = build_model(four_bar(Directions::parse("x,y,z,rx,rz")));
  std::mt19937_64 generator(12);
  ContactDynamics exact(model, loop_contacts(model));
  ContactDynamics all(model, loop_contacts(model, {}, true),
                      {.mu = 1e-4, .max_proximal_iterations = 100});
  const VectorXd q = closed(model, generator), tau = random_vector(3, generator);
  const VectorXd v = project_velocity_onto_loops(model, q, random_vector(3, generator));
  ASSERT_EQ(exact.forward(q, v, tau), Status::Ok);
  ASSERT_EQ(all.forward(q, v, tau), Status::Ok);
  EXPECT_LT((exact.a() - all.a()).norm() / exact.a().norm(), 1e-7);
}

TEST(LoopDynamics, FallingCrank_KeepsTheLoopClosed) {
  // A crank that falls for 2 s, by semi-implicit Euler steps of 1 ms.
  const Model model = build_model(four_bar());
  const double step = 1e-3;
  ContactDynamics dynamics(model, loop_contacts(model, LoopGains::for_step(step)));
  VectorXd q = closed_configuration(model, {{"drive", {0.8}}}), v = VectorXd::Zero(3);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_LE(dynamics.forward(q, v, VectorXd::Zero(3)), Status::NotConverged);
    v += step * dynamics.a();
    q = integrate(model, q, step * v);
    worst = std::max(worst, apart(model, q, "pin").translation().norm());
  }
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(std::abs(q[model.joint_index("drive")] - 0.8), 0.3) << "nothing moved";
}

}  // namespace
}  // namespace burnish::testing
