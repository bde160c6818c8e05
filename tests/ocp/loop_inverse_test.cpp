// Tests of inverse dynamics of closed chains: forward dynamics returns the motion.
#include "burnish/ocp/loop_inverse.hpp"

#include <gtest/gtest.h>

#include "burnish/contact/loops.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::testing {
namespace {

TEST(LoopInverse, Torques_ReproduceTheMotionInForwardDynamics) {
  if (!has_robot_files) GTEST_SKIP() << "needs robots in files";
  const Model model = named_robot("four_bar");
  ContactDynamics dynamics(model, loop_contacts(model, {}, true));
  const int drive = model.joints[static_cast<std::size_t>(model.joint_index("drive"))].v_index;
  LoopMotion motion{closed_configuration(model, {{"drive", {1.0}}}),
                    Eigen::VectorXd::Zero(model.nv), Eigen::VectorXd::Zero(model.nv),
                    Eigen::VectorXd::Zero(dynamics.rows())};
  motion.v[drive] = 2.0;
  motion.a[drive] = -3.0;
  const LoopInverse found = loop_inverse(model, dynamics, motion);
  ASSERT_EQ(found.status, Status::Ok);
  EXPECT_NEAR(found.v[drive], 2.0, 1e-9);
  EXPECT_NEAR(found.a[drive], -3.0, 1e-9);
  EXPECT_LT(found.unbalanced, 1e-9);
  ASSERT_LE(dynamics.forward(motion.q, found.v, found.tau), Status::NotConverged);
  EXPECT_LT((dynamics.a() - found.a).lpNorm<Eigen::Infinity>(), 1e-6);
  EXPECT_GT(found.a.lpNorm<Eigen::Infinity>(), 1.0);
}

TEST(LoopInverse, ActuationOfAnUnknownJoint_IsRefused) {
  if (!has_robot_files) GTEST_SKIP() << "needs robots in files";
  const Model model = named_robot("four_bar");
  ContactDynamics dynamics(model, loop_contacts(model, {}, true));
  const LoopMotion motion{closed_configuration(model, {}), Eigen::VectorXd::Zero(model.nv),
                          Eigen::VectorXd::Zero(model.nv), Eigen::VectorXd::Zero(dynamics.rows())};
  expect_words(refusal([&] { loop_inverse(model, dynamics, motion, {.joints = {"driv"}}); }),
               {"'driv'", "'drive'"});
}

}  // namespace
}  // namespace burnish::testing
