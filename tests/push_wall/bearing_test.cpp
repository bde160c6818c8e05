// What a robot on its feet can bear at rest, against what levers and cones say by hand.
#include "pressing/bearing.hpp"

#include <gtest/gtest.h>

#include "burnish/dynamics/placement.hpp"
#include "push_wall/descriptions.hpp"
#include "push_wall/pushing.hpp"
#include "support/allocation_guard.hpp"

namespace burnish::push_wall {
namespace {

using pressing::Bearing;
using pressing::BearingSpec;

struct Stand {
  Task task = read_task(BURNISH_TASKS_DIR "/push_wall/talos.yaml",
                        {std::string("robot=") + BURNISH_ROBOTS_DIR "/talos"});
  Setting setting = make_setting(task);
  RigidBody body{setting.robot.model};
  BearingSpec spec;
  double weight = setting.robot.model.total_mass() * setting.robot.model.gravity.norm();

  Stand() {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(setting.robot.model.nv);
    EXPECT_EQ(body.update(setting.q_start, rest), Status::Ok);
    spec = {.feet = setting.scene.supports,
            .hands = task.hands,
            .normal_world = setting.wall_axes.col(2),
            .torque_limit = rest.array() + 1e6};
    spec.feet.resize(2);
    for (SupportSpec& foot : spec.feet) foot.friction = 1.0;
  }
  double most() {
    Bearing bearing(setting.robot.model, spec);
    const double force = bearing.most(body);
    limit = bearing.name(bearing.limit());
    return force;
  }
  std::string limit;
};

/// F = mu W / 2 where nothing else matters.
TEST(Bearing, is_what_the_friction_of_the_feet_holds) {
  Stand stand;
  for (SupportSpec& foot : stand.spec.feet) {
    foot.friction = 0.3;
    foot.half_x = foot.half_y = 10.0;
  }
  EXPECT_NEAR(stand.most(), 0.3 * stand.weight / 2.0, 0.5);
  EXPECT_EQ(stand.limit.rfind("friction of ", 0), 0U) << stand.limit;
  stand.spec.hand_friction = 0.2;  // hands that push up load the feet: N = W + 2 mu_h F
  EXPECT_NEAR(stand.most(), 0.3 * stand.weight / 2.0 / (1.0 - 0.3 * 0.2), 0.5);
}

/// About the heels: 2 F h = W (x_com - x_heel).
TEST(Bearing, is_what_tips_the_robot_over_its_heels) {
  Stand stand;
  const Model& model = stand.setting.robot.model;
  const Eigen::Isometry3d sole =
      frame_placement(model, stand.setting.q_start, stand.spec.feet[0].frame);
  const double heel = sole.translation().x() - stand.spec.feet[0].half_x;
  const double height =
      frame_placement(model, stand.setting.q_start, stand.task.hands[0]).translation().z() -
      sole.translation().z();
  EXPECT_NEAR(stand.most(), stand.weight * (stand.body.com().x() - heel) / (2.0 * height), 0.1);
  EXPECT_EQ(stand.limit.rfind("pressure of ", 0), 0U) << stand.limit;
}

TEST(Bearing, names_the_joint_whose_torque_ends_it) {
  Stand stand;
  const double before = stand.most();
  const Model& model = stand.setting.robot.model;
  int elbow = 0;
  while (model.v_name(elbow) != "arm_left_4_joint") ++elbow;
  stand.spec.torque_limit[elbow] = 3.0;
  EXPECT_LT(stand.most(), 0.8 * before);
  EXPECT_EQ(stand.limit, "torque limits/arm_left_4_joint");
}

TEST(Bearing, is_negative_where_it_cannot_even_stand) {
  Stand stand;
  for (SupportSpec& foot : stand.spec.feet) foot.half_x = 0.01;  // the centre of mass is beyond
  EXPECT_GT(stand.most(), 0.0) << "it can lean on the wall";
  stand.spec.hands.clear();
  EXPECT_LT(stand.most(), 0.0);
  for (SupportSpec& foot : stand.spec.feet) foot.half_x = 0.1;
  EXPECT_EQ(stand.most(), 0.0);
}

TEST(Bearing, allocates_nothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  Stand stand;
  Bearing bearing(stand.setting.robot.model, stand.spec);
  const AllocationGuard guard;
  const double force = bearing.most(stand.body);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(force, 0.0);
}

}  // namespace
}  // namespace burnish::push_wall
