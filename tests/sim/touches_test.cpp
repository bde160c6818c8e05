// Tests of several touches at once in MuJoCo: two tools on two surfaces, their wrenches, sensors
// and traces.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "support/arm7.hpp"
#include "support/constant_torque.hpp"
#include "support/plant_touch.hpp"
#include "support/refusal.hpp"

namespace burnish::test {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using testing::expect_words;
using testing::refusal;

/// Two arms with a tip in each hand. The right tip presses on a plane, the left one on a sphere.
class TwoTools : public ::testing::TestWithParam<MujocoContact> {
 protected:
  TwoTools() : model(plant_model(robot.model, {})) {
    TouchSpec right = round_tip("tool"), left = round_tip("left_tool");
    right.surface.friction = 0.4;
    left.surface.friction = 0.2;
    left.surface.shape = {.kind = SurfaceShape::Kind::Sphere, .radius = 0.3};
    left.sensor = WrenchSensor::Wrench;
    const Vector3d right_normal(0.1, -0.2, 1.0), left_normal(-0.3, 0.4, 1.0);
    scene.touches = {with_surface_at(model, q, right_normal, right, -2e-4),
                     with_surface_at(model, q, left_normal, left, -1e-4)};
    EXPECT_EQ(body.update(q, VectorXd::Zero(model.nv)), Status::Ok);
    // Torques that balance the weight and the forces of the two surfaces.
    tau = body.gravity_torque();
    for (std::size_t i = 0; i < scene.touches.size(); ++i)
      tau += torque_of_force(body, scene.touches[i].frame, -pressed[i] * normals()[i]);
  }

  std::unique_ptr<Plant> plant_of(const SceneSpec& of, double dt = 5e-4) const {
    return make_mujoco_plant(model, of, {.contact = GetParam(), .dt = dt});
  }
  std::vector<Vector3d> normals() const {
    return {scene.touches[0].surface.normal, scene.touches[1].surface.normal};
  }
  /// Velocity with which both tips slide on their surfaces.
  VectorXd sliding() const {
    VectorXd v = VectorXd::Zero(model.nv);
    for (const auto& [joint, rate] :
         {std::pair("arm_right_1_joint", 0.02), {"arm_left_1_joint", -0.02}})
      v[model.joints[static_cast<std::size_t>(model.joint_index(joint))].v_index] = rate;
    return v;
  }
  /// Motors without torque limits.
  static Disturbances strong_motors() {
    Disturbances result;
    result.torque_limits = false;
    return result;
  }
  /// Loop whose controller ticks in every plant step.
  static ClosedLoop loop_of(Plant& plant, Controller& controller) {
    return {
        plant, controller, strong_motors(), {.control_period = plant.dt(), .max_duration = 0.1}};
  }

  Robot robot = load_robot("talos:two_arms");
  VectorXd q = robot.reference_configuration();
  Model model;
  SceneSpec scene;
  RigidBody body{model};
  VectorXd tau;
  std::vector<double> pressed{20.0, 10.0};  ///< Stiffness times depth of the two tips [N]
};

/// The acceleration of the robot must equal the effect of torques and of both wrenches.
TEST_P(TwoTools, Wrenches_ExplainTheMotionAndFollowTheirOwnSurfaces) {
  const auto plant = plant_of(scene, 1e-5);
  const VectorXd v = sliding();
  ASSERT_EQ(plant->reset(q, v), Status::Ok);
  ASSERT_EQ(plant->step(tau), Status::Ok);
  ASSERT_EQ(plant->wrenches().cols(), 2);
  VectorXd total = tau;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const TouchSpec& touch = scene.touches[static_cast<std::size_t>(i)];
    const int frame = body.frame(touch.frame);
    const Eigen::Matrix3d R = body.placement(frame).linear();
    const Vector3d force = force_world(*plant, q, i);
    Vector6 wrench_world;
    wrench_world << force, R * plant->wrenches().col(i).tail<3>();
    FrameDerivatives motion;
    body.frame_derivatives(frame, Reference::centered(), motion);
    total += motion.jacobian.transpose() * wrench_world;
    const Vector3d n = normal_at(touch.surface, body.placement(frame).translation());
    const double normal_force = force.dot(n), friction = (force - normal_force * n).norm();
    EXPECT_GT(normal_force, 2.0) << touch.frame;
    EXPECT_LE(friction, touch.surface.friction * normal_force * (1.0 + 1e-3)) << touch.frame;
    if (GetParam() == MujocoContact::Exact) {
      EXPECT_GE(friction, touch.surface.friction * normal_force * (1.0 - 1e-3)) << touch.frame;
    }
    // The force acts at the contact point, one radius below the frame's origin.
    const Vector3d moment = -touch.radius * n.cross(force);
    EXPECT_LE((wrench_world.tail<3>() - moment).norm(), 0.01 * touch.radius * force.norm());
  }
  ContactDynamics dynamics(model);
  ASSERT_EQ(dynamics.forward(q, v, total), Status::Ok);
  const VectorXd a = (plant->v() - v) / plant->dt();
  EXPECT_LE((a - dynamics.a()).norm(), 1e-4 * (1.0 + dynamics.a().norm()))
      << a.transpose() << "\n"
      << dynamics.a().transpose();
}

TEST_P(TwoTools, ToolAwayFromItsSurface_HasNoWrench) {
  for (const std::size_t away : {0U, 1U}) {
    SceneSpec apart = scene;
    SurfaceSpec& surface = apart.touches[away].surface;
    surface.point -= 0.01 * surface.normal;
    const auto plant = plant_of(apart);
    ASSERT_EQ(plant->reset(q, VectorXd::Zero(model.nv)), Status::Ok);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(plant->step(tau), Status::Ok);
    EXPECT_FALSE(is_touching(*plant, static_cast<Eigen::Index>(away)));
    EXPECT_TRUE(is_touching(*plant, static_cast<Eigen::Index>(1 - away)));
  }
}

TEST_P(TwoTools, RestoredSnapshot_GivesTheSameBits) {
  const auto plant = plant_of(scene);
  ASSERT_EQ(plant->reset(q, sliding()), Status::Ok);
  const auto drive = [&] {
    for (int i = 0; i < 10; ++i) ASSERT_EQ(plant->step(tau), Status::Ok);
  };
  drive();
  PlantSnapshot snapshot;
  plant->save(snapshot);
  const Wrenches wrenches = plant->wrenches();
  drive();
  const Wrenches wrenches_then = plant->wrenches();
  const VectorXd q_then = plant->q();
  ASSERT_EQ(plant->restore(snapshot), Status::Ok);
  EXPECT_EQ(plant->wrenches(), wrenches);
  drive();
  EXPECT_EQ(plant->wrenches(), wrenches_then);
  EXPECT_EQ(plant->q(), q_then);
}

TEST_P(TwoTools, Trace_NamesColumnsOfTheSecondToolAfterItsFrame) {
  const auto plant = plant_of(scene);
  ConstantTorque controller(tau);
  ClosedLoop loop = loop_of(*plant, controller);
  ASSERT_EQ(loop.reset(q, sliding()), Status::Ok);
  const std::vector<Eigen::Isometry3d> start{body.placement(body.frame("tool")),
                                             body.placement(body.frame("left_tool"))};
  constexpr int rows = 10;
  for (int row = 0; row < rows; ++row) {
    ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
    const Wrenches measured = plant->wrenches();
    const VectorXd q_before = plant->q();
    ASSERT_EQ(loop.step(), Status::Ok);
    const Trace& trace = loop.trace();
    const auto vector = [&](const std::string& name) {
      const int column = trace.index(name);
      return Vector3d(trace.at(row, column), trace.at(row, column + 1), trace.at(row, column + 2));
    };
    for (Eigen::Index i = 0; i < 2; ++i) {
      const TouchSpec& touch = scene.touches[static_cast<std::size_t>(i)];
      const std::string own = i == 0 ? "tool" : "tool_left_tool";
      const std::string prefix = i == 0 ? "" : "tool_left_tool_";
      const Eigen::Isometry3d at = body.placement(body.frame(touch.frame));
      EXPECT_LE((vector(own + "_x_world") - at.translation()).norm(), 1e-9);
      EXPECT_LE((vector(own + "_force_x_world") - force_world(*plant, q_before, i)).norm(), 1e-9);
      EXPECT_LE(
          (vector(prefix + "measured_force_x_world") - at.linear() * measured.col(i).head<3>())
              .norm(),
          1e-9);
      EXPECT_LE(
          (vector(prefix + "surface_normal_x_world") - normal_at(touch.surface, at.translation()))
              .norm(),
          1e-9);
      EXPECT_EQ(trace.at(row, trace.index(prefix + "in_contact")),
                is_touching(*plant, i) ? 1.0 : 0.0);
      const Eigen::AngleAxisd turned(
          Eigen::Matrix3d(start[static_cast<std::size_t>(i)].linear().transpose() * at.linear()));
      EXPECT_LE((vector(own + "_rx_start") - turned.angle() * turned.axis()).norm(), 1e-7);
    }
    EXPECT_TRUE(is_touching(*plant, 0) && is_touching(*plant, 1));
  }
  for (const char* name : {"estimated_force_x_world", "estimated_friction"}) {
    EXPECT_TRUE(loop.trace().has(name));
    EXPECT_FALSE(loop.trace().has("tool_left_tool_" + std::string(name)));
  }
}

TEST_P(TwoTools, Controller_ReceivesTheWrenchesThatItReadsInItsOrder) {
  const auto plant = plant_of(scene);
  const auto measured = [&](const ConstantTorque::Touches& touches, Wrenches& truth) {
    ConstantTorque controller(tau, touches);
    ClosedLoop loop = loop_of(*plant, controller);
    EXPECT_EQ(loop.reset(q, VectorXd::Zero(model.nv)), Status::Ok);
    EXPECT_EQ(loop.run(5e-3), Status::Ok);
    truth = plant->wrenches();
    EXPECT_EQ(loop.step(), Status::Ok);
    return loop.measurement().wrenches;
  };
  Wrenches truth;
  const auto expect_column = [&](const Wrenches& got, Eigen::Index column, Eigen::Index touch) {
    EXPECT_GT(truth.col(touch).norm(), 1.0);
    EXPECT_LE((got.col(column) - truth.col(touch)).head<3>().norm(), 1e-9) << column;
    // The right tip has a sensor of forces, the left one a sensor of wrenches.
    if (touch == 0) {
      EXPECT_TRUE(got.col(column).tail<3>().array().isNaN().all());
    } else {
      EXPECT_LE((got.col(column) - truth.col(touch)).tail<3>().norm(), 1e-9);
    }
  };
  const Wrenches all = measured(std::nullopt, truth);
  ASSERT_EQ(all.cols(), 2);
  expect_column(all, 0, 0);
  expect_column(all, 1, 1);
  const Wrenches reversed = measured(touches_at({"left_tool", "tool"}), truth);
  ASSERT_EQ(reversed.cols(), 2);
  expect_column(reversed, 0, 1);
  expect_column(reversed, 1, 0);
  const Wrenches left = measured(touches_at({"left_tool"}), truth);
  ASSERT_EQ(left.cols(), 1);
  expect_column(left, 0, 1);
  EXPECT_EQ(measured(touches_at({}), truth).cols(), 0);
}

TEST_P(TwoTools, TouchWithoutSensorOrReader_IsNotMeasured) {
  const auto forces = [&](const SceneSpec& of, const ConstantTorque::Touches& touches) {
    const auto plant = plant_of(of);
    ConstantTorque controller(tau, touches);
    ClosedLoop loop = loop_of(*plant, controller);
    EXPECT_EQ(loop.reset(q, VectorXd::Zero(model.nv)), Status::Ok);
    EXPECT_EQ(loop.run(2e-3), Status::Ok);
    const Trace& trace = loop.trace();
    const int last = trace.rows() - 1;
    EXPECT_GT(std::abs(trace.at(last, trace.index("tool_left_tool_force_z_world"))), 1.0);
    return Eigen::Vector2d(trace.at(last, trace.index("measured_force_z_world")),
                           trace.at(last, trace.index("tool_left_tool_measured_force_z_world")));
  };
  SceneSpec blind = scene;
  blind.touches[1].sensor = WrenchSensor::None;
  const Eigen::Vector2d without_sensor = forces(blind, std::nullopt);
  EXPECT_GT(std::abs(without_sensor[0]), 1.0);
  EXPECT_TRUE(std::isnan(without_sensor[1]));
  const Eigen::Vector2d without_reader = forces(scene, touches_at({"tool"}));
  EXPECT_GT(std::abs(without_reader[0]), 1.0);
  EXPECT_TRUE(std::isnan(without_reader[1]));
}

TEST_P(TwoTools, ControllerWithAnUnknownTouch_IsRefusedWithTheNearestName) {
  const auto plant = plant_of(scene);
  ConstantTorque controller(tau, touches_at({"tool", "left_tol"}));
  expect_words(refusal([&] { ClosedLoop(*plant, controller); }),
               {"the controller reads", "'left_tol'", "not a touch of the plant's scene",
                "did you mean 'left_tool'"});
}

TEST_P(TwoTools, ControllerThatNeedsAMissingSensor_IsRefused) {
  const auto refused = [&](WrenchSensor sensor, WrenchSensor wanted) {
    SceneSpec with = scene;
    with.touches[1].sensor = sensor;
    const auto plant = plant_of(with);
    ConstantTorque controller(tau, std::vector<TouchSensor>{{"tool"}, {"left_tool", wanted}});
    return refusal([&] { ClosedLoop(*plant, controller); });
  };
  using enum WrenchSensor;
  expect_words(refused(None, Force), {"the force at 'left_tool'", "TouchSpec.sensor force"});
  expect_words(refused(None, Wrench), {"the moment at 'left_tool'", "wrench"});
  expect_words(refused(Force, Wrench), {"the moment at 'left_tool'", "MpcSpec.touches"});
  for (const WrenchSensor wanted : {Automatic, None, Force}) EXPECT_EQ(refused(Force, wanted), "");
  EXPECT_EQ(refused(None, Automatic), "");
  EXPECT_EQ(refused(Wrench, Wrench), "");
}

TEST_P(TwoTools, SensorNoise_DependsOnTheSensor) {
  const auto noise_of = [&](void (*switch_on)(Disturbances&)) {
    const auto plant = plant_of(scene);
    Disturbances disturbances = strong_motors();
    switch_on(disturbances);
    Sensing sensing(model, disturbances, plant->scene(), {"tool", "left_tool"});
    EXPECT_EQ(plant->reset(q, VectorXd::Zero(model.nv)), Status::Ok);
    const Wrenches measured = sensing.measure(*plant, tau).wrenches;  // the true wrenches are zero
    return std::string(measured.col(0).head<3>().isZero(0.0) ? "" : "force ") +
           (measured.col(1).head<3>().isZero(0.0) ? "" : "wrench's force ") +
           (measured.col(1).tail<3>().isZero(0.0) ? "" : "moment ");
  };
  EXPECT_EQ(noise_of([](Disturbances&) {}), "");
  EXPECT_EQ(noise_of([](Disturbances& d) { d.force_noise = 1.0; }), "force ");
  EXPECT_EQ(noise_of([](Disturbances& d) { d.support_force_noise = 1.0; }), "wrench's force ");
  EXPECT_EQ(noise_of([](Disturbances& d) { d.support_moment_noise = 1.0; }), "moment ");
}

TEST(TouchNames, FrameThatRepeatsAColumn_IsRefused) {
  for (const bool repeats : {false, true}) {
    const std::string second = repeats ? "force" : "probe";
    ModelOptions options = arm7::options(Base::Fixed);
    options.frames.push_back({second, "flange", Eigen::Isometry3d::Identity()});
    const Model model = build_model(arm7::tree(), options);
    const auto plant =
        make_mujoco_plant(model, {.touches = {round_tip("tool"), round_tip(second)}});
    ConstantTorque limp = no_torque(model);
    const std::string refused = refusal([&] { ClosedLoop(*plant, limp); });
    if (repeats)
      expect_words(refused, {"two columns 'tool_force_x_world'", "touches"});
    else
      EXPECT_EQ(refused, "");
  }
}

INSTANTIATE_TEST_SUITE_P(contacts, TwoTools,
                         ::testing::Values(MujocoContact::Exact, MujocoContact::Engine),
                         [](const auto& test) {
                           return test.param == MujocoContact::Exact ? "exact" : "engine";
                         });

}  // namespace
}  // namespace burnish::test
