// What a robot stands on: MuJoCo's contacts under soles and balls.
#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

struct Stands {
  const char* robot;
  const char* tip;
  std::vector<const char*> feet;
  double half_x, half_y, radius;

  /// On the ground where the feet are, and a surface out of reach.
  SceneSpec scene(const Robot& loaded) const {
    SceneSpec scene;
    scene.tip.frame = tip;
    scene.surface.point.z() = -100.0;
    RigidBody body(loaded.model);
    (void)body.update(loaded.reference_configuration(), Eigen::VectorXd::Zero(loaded.model.nv));
    for (const char* foot : feet) {
      SupportSpec support{.frame = foot, .half_x = half_x, .half_y = half_y, .radius = radius};
      support.point = body.placement(body.frame(foot)).translation();
      if (!support.is_sole()) support.point.z() -= radius;
      scene.supports.push_back(support);
    }
    return scene;
  }
};

class Supports : public ::testing::TestWithParam<Stands> {};

/// Between two states dt apart: d(momentum)/dt about the world's origin is what supports and
/// gravity do there.
TEST_P(Supports, push_as_the_momentum_of_the_robot_changes) {
  const Robot robot = load_robot(GetParam().robot);
  const Model& model = robot.model;
  const SceneSpec scene = GetParam().scene(robot);
  const auto plant = make_mujoco_plant(model, scene, {.dt = 2e-5});
  RigidBody body(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(robot.reference_configuration(), zero), Status::Ok);
  // Limp, it slumps onto its feet.
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(plant->step(zero, Eigen::Vector3d::Zero()), Status::Ok);
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 before = body.momentum();
  const Eigen::Vector3d weight = body.mass() * model.gravity;
  Vector6 pushed = Vector6::Zero();
  pushed.head<3>() = weight;
  pushed.tail<3>() = body.com().cross(weight);
  std::vector<Eigen::Isometry3d> at;
  for (const SupportSpec& support : scene.supports)
    at.push_back(body.placement(body.frame(support.frame)));
  ASSERT_EQ(plant->step(zero, Eigen::Vector3d::Zero()), Status::Ok);
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vector6 wrench = plant->support_wrenches().col(static_cast<Eigen::Index>(i));
    EXPECT_GT(wrench[2], 0.0) << scene.supports[i].frame;
    const Eigen::Vector3d f_world = at[i].linear() * wrench.head<3>();
    pushed.head<3>() += f_world;
    pushed.tail<3>() += at[i].linear() * wrench.tail<3>() + at[i].translation().cross(f_world);
  }
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 rate = (body.momentum() - before) / plant->dt();
  EXPECT_LE((rate - pushed).norm(), 2e-3 * weight.norm()) << rate.transpose() << "\n"
                                                          << pushed.transpose();
}

/// A ball or sole that is pushed along the ground stays while that has friction, and slides off as
/// soon as it has not.
TEST_P(Supports, slide_while_the_ground_is_slippery) {
  const Robot robot = load_robot(GetParam().robot);
  const Model& model = robot.model;
  SceneSpec scene = GetParam().scene(robot);
  const std::string foot = scene.supports[0].frame;
  scene.slippery_ground = {{.start = 0.02, .duration = 0.01, .frame = foot, .friction = 0.01}};
  EXPECT_EQ(friction_under(scene, scene.supports[0], 0.0199), 0.7);
  EXPECT_EQ(friction_under(scene, scene.supports[0], 0.02), 0.01);
  EXPECT_EQ(friction_under(scene, scene.supports[1], 0.02), 0.7);
  EXPECT_EQ(friction_under(scene, scene.supports[0], 0.0301), 0.7);
  const auto plant = make_mujoco_plant(model, scene, {.dt = 5e-4});
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(robot.reference_configuration(), zero), Status::Ok);
  RigidBody body(model);
  // Limp, it slumps, and its feet are drawn apart.
  double steady = 0.0, slippery = 0.0;
  for (int i = 0; i < 60; ++i) {
    ASSERT_EQ(plant->step(zero, Eigen::Vector3d::Zero()), Status::Ok);
    ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
    const Eigen::Vector3d force_world =
        body.placement(body.frame(foot)).linear() * plant->support_wrenches().col(0).head<3>();
    const double used = force_world.head<2>().norm() / force_world.z();
    if (i > 10 && i < 39) steady = std::max(steady, used);
    if (i >= 41) slippery = std::max(slippery, used);
  }
  EXPECT_GT(steady, 0.05);
  EXPECT_LT(slippery, 0.011);
}

TEST(SupportsOfAScene, refuse_ground_that_nothing_stands_on) {
  const Robot robot = load_robot("quadruped");
  SceneSpec scene = Stands{"quadruped", "fl_hip_link", {"fl_foot"}, 0.0, 0.0, 0.018}.scene(robot);
  scene.slippery_ground = {{.frame = "fr_foot"}};
  testing::expect_words(testing::refusal([&] { (void)checked_scene(robot.model, scene); }),
                        {"slippery ground", "fr_foot", "fl_foot"});
}

/// Of feet without sensors nobody is told what they bear.
TEST_P(Supports, are_measured_where_there_are_sensors) {
  struct Limp final : Controller {
    explicit Limp(int nv) { command.tau = Eigen::VectorXd::Zero(nv); }
    int nv() const override { return static_cast<int>(command.tau.size()); }
    void reset() noexcept override {}
    const Command& tick(const Measurement& measurement) noexcept override {
      columns = measurement.support_wrenches.cols();
      return command;
    }
    Command command;
    Eigen::Index columns = -1;
  };
  const Robot robot = load_robot(GetParam().robot);
  const auto plant = make_mujoco_plant(robot.model, GetParam().scene(robot));
  for (const bool there : {true, false}) {
    Limp limp(robot.model.nv);
    ClosedLoop loop(*plant, limp, {}, {.max_duration = 0.01, .support_sensors = there});
    ASSERT_EQ(loop.reset(robot.reference_configuration(), limp.command.tau), Status::Ok);
    ASSERT_EQ(loop.run(0.005), Status::Ok);
    const auto feet = static_cast<Eigen::Index>(GetParam().feet.size());
    EXPECT_EQ(limp.columns, there ? feet : 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    robots, Supports,
    ::testing::Values(
        Stands{"talos", "tool", {"left_sole_link", "right_sole_link"}, 0.1, 0.06, 0.02},
        Stands{"quadruped",
               "fl_hip_link",
               {"fl_foot", "fr_foot", "rl_foot", "rr_foot"},
               0.0,
               0.0,
               0.018}),
    [](const auto& test) { return std::string(test.param.robot); });

}  // namespace
}  // namespace burnish::test
