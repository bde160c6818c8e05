// Tests of a surface that the robot itself carries: its contact forces, refused scenes, and traces
// relative to it.
#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "support/plant_touch.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
using testing::expect_words;
using testing::refusal;

namespace {

/// Scene with the tip 0.2 mm inside the plate.
SceneSpec plate_under_tip(const Robot& robot, double friction) {
  TouchSpec tip = round_tip();
  tip.surface.frame = "plate";
  tip.surface.friction = friction;
  return {.touches = {with_surface_at(robot.model, robot.reference_configuration(), {0.0, 0.0, 1.0},
                                      tip, -2e-4)}};
}

/// Velocities with which the tip slides on the plate.
Eigen::VectorXd sliding(const Model& model) {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(model.nv);
  for (const auto& [joint, rate] : {std::pair("arm_right_1_joint", 0.2),
                                    {"arm_right_3_joint", -0.1},
                                    {"arm_left_2_joint", 0.1}})
    v[model.joints[static_cast<std::size_t>(model.joint_index(joint))].v_index] = rate;
  return v;
}

TEST(CarriedSurface, ContactForces_AreInternalAndKeepTheMomentum) {
  const Robot robot = load_robot("talos:with_plate");
  const Model& model = robot.model;
  const auto plant = make_mujoco_plant(model, plate_under_tip(robot, 0.4), {.dt = 1e-5});
  RigidBody body(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(plant->reset(robot.reference_configuration(), sliding(model)), Status::Ok);
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 before = body.momentum();
  const Eigen::Vector3d weight = body.mass() * model.gravity;
  const Eigen::Vector3d com = body.com();
  const Eigen::Vector3d n = body.placement(body.frame("plate")).linear().col(2);
  const Eigen::VectorXd q_before = plant->q();
  ASSERT_EQ(plant->step(zero), Status::Ok);
  const Eigen::Vector3d force = force_world(*plant, q_before);
  EXPECT_GT(force.dot(n), 10.0);
  EXPECT_GT((force - n.dot(force) * n).norm(), 1.0);  // the contact has friction
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  Vector6 expected;
  expected << weight, com.cross(weight);
  const Vector6 rate = (body.momentum() - before) / plant->dt();
  // The remainder is the integration error. Without the reaction on the plate it would be hundreds
  // of times larger.
  EXPECT_LE((rate - expected).norm(), 0.02 * force.norm()) << (rate - expected).transpose();
}

/// An arm that is too heavy to move carries the plate, so the plate equals a surface fixed in the
/// world.
TEST(CarriedSurface, FixedFrame_GivesTheForcesOfASurfaceInTheWorld) {
  Robot robot = load_robot("talos:two_arms");
  for (const Joint& joint : robot.model.joints)
    if (joint.name.rfind("arm_right", 0) != 0) robot.model.armature[joint.v_index] = 1e9;
  const Eigen::VectorXd q = robot.reference_configuration();
  SceneSpec carried = plate_under_tip(robot, 0.3);
  carried.tool().surface.motion = {.amplitude = 1e-4, .frequency = 5.0};
  SceneSpec fixed = carried;
  const SurfaceSpec& plate = carried.tool().surface;
  fixed.tool().surface = in_world(plate, surface_placement(robot.model, q, plate));
  const auto one = make_mujoco_plant(robot.model, carried);
  const auto other = make_mujoco_plant(robot.model, fixed);
  Eigen::VectorXd v = sliding(robot.model);
  v[robot.model.joints[static_cast<std::size_t>(robot.model.joint_index("arm_left_2_joint"))]
        .v_index] = 0.0;
  ASSERT_EQ(one->reset(q, v), Status::Ok);
  ASSERT_EQ(other->reset(q, v), Status::Ok);
  RigidBody body(robot.model);
  double largest = 0.0;
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(body.update(one->q(), one->v()), Status::Ok);
    const Eigen::VectorXd tau = body.gravity_torque();
    const Eigen::VectorXd q_one = one->q(), q_other = other->q();
    ASSERT_EQ(one->step(tau), Status::Ok);
    ASSERT_EQ(other->step(tau), Status::Ok);
    const Eigen::Vector3d force = force_world(*one, q_one);
    ASSERT_LE((force - force_world(*other, q_other)).norm(), 1e-4) << i;
    largest = std::max(largest, force.norm());
  }
  EXPECT_GT(largest, 5.0);
  EXPECT_LE((one->q() - other->q()).norm(), 1e-7);
}

TEST(CarriedSurface, UnsupportedPlantOrFrame_IsRefused) {
  const Robot robot = load_robot("talos:two_arms");
  SceneSpec scene = plate_under_tip(robot, 0.0);
  expect_words(refusal([&] { make_ideal_plant(robot.model, scene); }),
               {"the ideal plant", "carries", "plate", "MuJoCo"});
  expect_words(
      refusal([&] { make_mujoco_plant(robot.model, scene, {.contact = MujocoContact::Engine}); }),
      {"MuJoCo's own contact", "plate", "exact"});
  scene.tool().surface.frame = "plait";
  expect_words(refusal([&] { checked_scene(robot.model, scene); }), {"plait", "plate"});
  scene.tool().surface.frame = "wrist_right_ft_link";
  expect_words(refusal([&] { checked_scene(robot.model, scene); }), {"one body", "tool"});
}

/// Controller without torque whose target is a point of the plate.
class Aim final : public Controller {
 public:
  explicit Aim(const Model& model) : body_(model), plate_(body_.frame("plate")) {
    command_.tau = Eigen::VectorXd::Zero(model.nv);
  }
  int nv() const override { return static_cast<int>(command_.tau.size()); }
  void reset() noexcept override {}
  const Command& tick(const Measurement& m) noexcept override {
    (void)body_.update(m.q, m.v);
    command_.tools[0].p_target_world = body_.placement(plate_) * Eigen::Vector3d(0.01, 0.02, 0.03);
    return command_;
  }

 private:
  RigidBody body_;
  int plate_;
  Command command_;
};

TEST(CarriedSurface, SeenFromTheSurface_TraceIsInItsFrame) {
  const Robot robot = load_robot("talos:two_arms");
  const auto plant = make_mujoco_plant(robot.model, plate_under_tip(robot, 0.0));
  Aim controller(robot.model);
  ClosedLoop loop(*plant, controller, {}, {.control_period = plant->dt(), .max_duration = 0.3});
  ASSERT_EQ(loop.reset(robot.reference_configuration(), sliding(robot.model)), Status::Ok);
  ASSERT_EQ(loop.run(0.3), Status::Ok);  // without torque, the robot falls
  Trace room;
  const Trace& seen = seen_from_surface(loop.trace(), room);
  RigidBody body(robot.model);
  const int last = seen.rows() - 1;
  for (const int row : {0, last}) {
    const auto at = [&](const char* column_name) {
      const int column = seen.index(column_name);
      return Eigen::Vector3d(seen.at(row, column), seen.at(row, column + 1),
                             seen.at(row, column + 2));
    };
    Eigen::VectorXd q(robot.model.nq);
    for (int k = 0; k < robot.model.nq; ++k)
      q[k] = seen.at(row, seen.index("q_" + robot.model.q_name(k)));
    ASSERT_EQ(body.update(q, Eigen::VectorXd::Zero(robot.model.nv)), Status::Ok);
    const Eigen::Isometry3d plate = body.placement(body.frame("plate"));
    const Eigen::Vector3d tool = body.placement(body.frame("tool")).translation();
    EXPECT_LE((at("tool_x_world") - plate.inverse() * tool).norm(), 1e-9);
    EXPECT_LE((at("target_x_world") - Eigen::Vector3d(0.01, 0.02, 0.03)).norm(), 1e-9);
    EXPECT_LE((at("surface_normal_x_world") - Eigen::Vector3d::UnitZ()).norm(), 1e-9);
    EXPECT_LE((at("surface_x_world") - plate.translation()).norm(), 1e-12);
  }
  // Checks that the plate moved.
  EXPECT_GT(std::abs(seen.at(last, seen.index("surface_z_world")) -
                     seen.at(0, seen.index("surface_z_world"))),
            0.01);
}

}  // namespace
}  // namespace burnish::test
