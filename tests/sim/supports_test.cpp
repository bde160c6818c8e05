// Tests of ground supports in MuJoCo: contacts under planar and point feet.
#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "support/constant_torque.hpp"
#include "support/plant_touch.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

struct StandingRobot {
  const char* robot;
  const char* tip;
  std::vector<const char*> feet;
  double half_x, half_y, radius;

  /// Scene with a tip whose surface is out of reach, and with ground under the feet.
  SceneSpec scene(const Robot& loaded) const {
    SceneSpec scene = out_of_reach(tip);
    RigidBody body(loaded.model);
    (void)body.update(loaded.reference_configuration(), Eigen::VectorXd::Zero(loaded.model.nv));
    for (const char* foot : feet) {
      TouchSpec support{.frame = foot,
                        .half_x = half_x,
                        .half_y = half_y,
                        .radius = radius,
                        .surface = {.friction = 0.7, .stiffness = 2e6, .damping = 1e5},
                        .is_support = true};
      support.surface.point = body.placement(body.frame(foot)).translation();
      if (!support.is_rectangle()) support.surface.point.z() -= radius;
      scene.touches.push_back(support);
    }
    return scene;
  }
};

class Supports : public ::testing::TestWithParam<StandingRobot> {};

/// Over a step dt, d(momentum)/dt about the world's origin must equal the effect of supports and
/// gravity.
TEST_P(Supports, Wrenches_MatchTheChangeOfMomentum) {
  const Robot robot = load_robot(GetParam().robot);
  const Model& model = robot.model;
  const SceneSpec scene = GetParam().scene(robot);
  const auto plant = make_mujoco_plant(model, scene, {.dt = 2e-5});
  RigidBody body(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(robot.reference_configuration(), zero), Status::Ok);
  // Without torque, the robot slumps onto its feet.
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(plant->step(zero), Status::Ok);
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 before = body.momentum();
  const Eigen::Vector3d weight = body.mass() * model.gravity;
  Vector6 expected = Vector6::Zero();
  expected.head<3>() = weight;
  expected.tail<3>() = body.com().cross(weight);
  std::vector<Eigen::Isometry3d> at;
  for (const TouchSpec& touch : scene.touches)
    at.push_back(body.placement(body.frame(touch.frame)));
  ASSERT_EQ(plant->step(zero), Status::Ok);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vector6 wrench = plant->wrenches().col(static_cast<Eigen::Index>(i));
    EXPECT_EQ(wrench[2] > 0.0, scene.touches[i].is_support) << scene.touches[i].frame;
    const Eigen::Vector3d f_world = at[i].linear() * wrench.head<3>();
    expected.head<3>() += f_world;
    expected.tail<3>() += at[i].linear() * wrench.tail<3>() + at[i].translation().cross(f_world);
  }
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 rate = (body.momentum() - before) / plant->dt();
  EXPECT_LE((rate - expected).norm(), 2e-3 * weight.norm()) << rate.transpose() << "\n"
                                                            << expected.transpose();
}

/// A foot that is pushed along the ground sticks while the ground has friction, and slides on
/// slippery ground.
TEST_P(Supports, SlipperyGround_LimitsTheFrictionForce) {
  const Robot robot = load_robot(GetParam().robot);
  const Model& model = robot.model;
  SceneSpec scene = GetParam().scene(robot);
  const TouchSpec first = scene.touches.at(1), second = scene.touches.at(2);
  const std::string foot = first.frame;
  scene.slippery_ground = {{.start = 0.02, .duration = 0.01, .frame = foot, .friction = 0.01}};
  EXPECT_EQ(friction_under(scene, first, 0.0199), 0.7);
  EXPECT_EQ(friction_under(scene, first, 0.02), 0.01);
  EXPECT_EQ(friction_under(scene, second, 0.02), 0.7);
  EXPECT_EQ(friction_under(scene, first, 0.0301), 0.7);
  const auto plant = make_mujoco_plant(model, scene, {.dt = 5e-4});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(robot.reference_configuration(), zero), Status::Ok);
  // Without torque, the robot slumps and its feet drift apart.
  double steady = 0.0, slippery = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Eigen::VectorXd q_before = plant->q();
    ASSERT_EQ(plant->step(zero), Status::Ok);
    const Eigen::Vector3d force = force_world(*plant, q_before, 1);
    const double friction_ratio = force.head<2>().norm() / force.z();
    if (i > 10 && i < 39) steady = std::max(steady, friction_ratio);
    if (i >= 41) slippery = std::max(slippery, friction_ratio);
  }
  EXPECT_GT(steady, 0.05);
  EXPECT_LT(slippery, 0.011);
}

TEST(SlipperyGround, FrameWithoutSupport_IsRefused) {
  const Robot robot = load_robot("quadruped");
  SceneSpec scene =
      StandingRobot{"quadruped", "fl_hip_link", {"fl_foot"}, 0.0, 0.0, 0.018}.scene(robot);
  scene.slippery_ground = {{.frame = "fr_foot"}};
  testing::expect_words(testing::refusal([&] { (void)checked_scene(robot.model, scene); }),
                        {"slippery ground", "fr_foot", "fl_foot"});
}

/// Measurements contain the wrenches of feet only if the feet have sensors.
TEST_P(Supports, FootSensors_MeasureTheWrenchesOfFeet) {
  const Robot robot = load_robot(GetParam().robot);
  const auto& feet = GetParam().feet;
  const auto count = static_cast<Eigen::Index>(feet.size());
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(robot.model.nv);
  for (const bool has_sensors : {true, false}) {
    SceneSpec scene = GetParam().scene(robot);
    if (!has_sensors)
      for (TouchSpec& touch : scene.touches)
        if (touch.is_support) touch.sensor = WrenchSensor::None;
    const auto plant = make_mujoco_plant(robot.model, scene);
    for (const bool all : {true, false}) {
      ConstantTorque limp = no_torque(robot.model);
      if (!all) limp = ConstantTorque(zero, touches_at({feet.begin(), feet.end()}));
      ClosedLoop loop(*plant, limp, {}, {.max_duration = 0.02});
      ASSERT_EQ(loop.reset(robot.reference_configuration(), zero), Status::Ok);
      ASSERT_EQ(loop.run(0.02), Status::Ok);
      const Wrenches& measured = loop.measurement().wrenches;
      ASSERT_EQ(measured.cols(), all ? 1 + count : count);
      if (has_sensors) {
        // The light point feet of the limp quadruped rebound from the ground.
        const bool has_soles = GetParam().half_x > 0.0;
        EXPECT_TRUE(!has_soles || measured.rightCols(count).norm() > 1.0);
        EXPECT_TRUE(measured.rightCols(count).allFinite());
      } else {
        EXPECT_TRUE(measured.rightCols(count).array().isNaN().all());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    robots, Supports,
    ::testing::Values(
        StandingRobot{"talos", "tool", {"left_sole_link", "right_sole_link"}, 0.1, 0.06, 0.02},
        StandingRobot{"quadruped",
                      "fl_hip_link",
                      {"fl_foot", "fr_foot", "rl_foot", "rr_foot"},
                      0.0,
                      0.0,
                      0.018}),
    [](const auto& test) { return std::string(test.param.robot); });

}  // namespace
}  // namespace burnish::test
