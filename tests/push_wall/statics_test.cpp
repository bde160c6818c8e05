// Largest static force of a standing robot, compared with lever arms and friction cones by hand.
#include "pressing/statics.hpp"

#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "push_wall/descriptions.hpp"
#include "push_wall/pushing.hpp"
#include "support/allocation_guard.hpp"

namespace burnish::push_wall {
namespace {

using pressing::Statics;
using pressing::StaticsSpec;

struct TalosAtTheWall {
  Task task = read_task(BURNISH_TASKS_DIR "/push_wall/talos.yaml",
                        {std::string("robot=") + BURNISH_ROBOTS_DIR "/talos"});
  Setting setting = make_setting(task);
  RigidBody body{setting.robot.model};
  StaticsSpec spec;
  double weight = setting.robot.model.total_mass() * setting.robot.model.gravity.norm();

  TalosAtTheWall() {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(setting.robot.model.nv);
    EXPECT_EQ(body.update(setting.q_start, rest), Status::Ok);
    spec = {.feet = setting.scene.supports(),
            .hands = task.hands,
            .normal_world = setting.wall_axes.col(2),
            .torque_limit = rest.array() + 1e6};
    spec.feet.resize(2);
    for (TouchSpec& foot : spec.feet) foot.surface.friction = 1.0;
  }
  double max_force() {
    Statics statics(setting.robot.model, spec);
    const double force = statics.max_force(body);
    limit = statics.name(statics.limit());
    return force;
  }
  std::string limit;
};

/// If only friction limits the force, F = mu W / 2 per hand.
TEST(Statics, FrictionOfTheFeet_LimitsTheForce) {
  TalosAtTheWall stand;
  for (TouchSpec& foot : stand.spec.feet) {
    foot.surface.friction = 0.3;
    foot.half_x = foot.half_y = 10.0;
  }
  EXPECT_NEAR(stand.max_force(), 0.3 * stand.weight / 2.0, 0.5);
  EXPECT_EQ(stand.limit.rfind("friction of ", 0), 0U) << stand.limit;
  stand.spec.hand_friction = 0.2;  // friction of the hands loads the feet: N = W + 2 mu_h F
  EXPECT_NEAR(stand.max_force(), 0.3 * stand.weight / 2.0 / (1.0 - 0.3 * 0.2), 0.5);
}

/// Moments about the heels balance: 2 F h = W (x_com - x_heel).
TEST(Statics, TippingOverTheHeels_LimitsTheForce) {
  TalosAtTheWall stand;
  const Model& model = stand.setting.robot.model;
  const Eigen::Isometry3d sole =
      frame_placement(model, stand.setting.q_start, stand.spec.feet[0].frame);
  const double heel = sole.translation().x() - stand.spec.feet[0].half_x;
  const double height =
      frame_placement(model, stand.setting.q_start, stand.task.hands[0]).translation().z() -
      sole.translation().z();
  EXPECT_NEAR(stand.max_force(), stand.weight * (stand.body.com().x() - heel) / (2.0 * height),
              0.1);
  EXPECT_EQ(stand.limit.rfind("pressure of ", 0), 0U) << stand.limit;
}

TEST(Statics, WeakElbow_LimitsTheForceAndIsNamed) {
  TalosAtTheWall stand;
  const double before = stand.max_force();
  const Model& model = stand.setting.robot.model;
  int elbow = 0;
  while (model.v_name(elbow) != "arm_left_4_joint") ++elbow;
  stand.spec.torque_limit[elbow] = 3.0;
  EXPECT_LT(stand.max_force(), 0.8 * before);
  EXPECT_EQ(stand.limit, "torque limits/arm_left_4_joint");
}

TEST(Statics, UnstableStance_GivesANegativeForce) {
  TalosAtTheWall stand;
  // The centre of mass is beyond the soles.
  for (TouchSpec& foot : stand.spec.feet) foot.half_x = 0.01;
  EXPECT_GT(stand.max_force(), 0.0) << "the wall supports the robot";
  stand.spec.hands.clear();
  EXPECT_LT(stand.max_force(), 0.0);
  for (TouchSpec& foot : stand.spec.feet) foot.half_x = 0.1;
  EXPECT_EQ(stand.max_force(), 0.0);
}

TEST(Statics, MaxForce_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  TalosAtTheWall stand;
  Statics statics(stand.setting.robot.model, stand.spec);
  const AllocationGuard guard;
  const double force = statics.max_force(stand.body);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(force, 0.0);
}

}  // namespace
}  // namespace burnish::push_wall
