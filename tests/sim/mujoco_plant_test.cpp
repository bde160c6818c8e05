// Tests of MuJoCo as the plant: the robot equals the model to rounding errors, and contact forces
// follow the scene.
#include "burnish/mujoco/mujoco_plant.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "mujoco/mujoco_engine.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

double relative(const Eigen::MatrixXd& got, const Eigen::MatrixXd& want) {
  return (got - want).cwiseAbs().maxCoeff() / want.cwiseAbs().maxCoeff();
}

class MujocoPlantModel : public ::testing::TestWithParam<TestRobot> {};

TEST_P(MujocoPlantModel, MassMatrixAndBias_EqualTheModels) {
  const Model model = GetParam().model();
  const SceneSpec scene = out_of_reach(GetParam().tool);
  mujoco::Engine engine(model, scene, {});
  ContactDynamics dynamics(model);
  std::mt19937_64 generator(4);
  for (int i = 0; i < 30; ++i) {
    const Eigen::VectorXd q = random_configuration(model, generator);
    const Eigen::VectorXd v = random_vector(model.nv, 1.0, generator);
    ASSERT_EQ(dynamics.forward(q, v, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    engine.coordinates.store(q, v, *engine.d);
    mj_fwdPosition(engine.m.get(), engine.d.get());
    mj_fwdVelocity(engine.m.get(), engine.d.get());
    EXPECT_LE(relative(mujoco::mass_matrix(*engine.m, *engine.d, engine.coordinates),
                       dynamics.mass_matrix()),
              1e-12);
    EXPECT_LE(relative(mujoco::bias(*engine.m, *engine.d, engine.coordinates), dynamics.bias()),
              1e-12);
  }
}

TEST_P(MujocoPlantModel, FreeFall_MatchesTheIdealPlant) {
  const Model model = plant_model(GetParam().model(), {});
  const SceneSpec scene = out_of_reach(GetParam().tool);
  MujocoPlantOptions fine;
  fine.dt = 2e-5;  // MuJoCo's integrator has first order
  fine.joint_stops = false;
  const auto theirs = make_mujoco_plant(model, scene, fine);
  const auto ours = make_ideal_plant(model, scene);
  std::mt19937_64 generator(8);
  const Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd v = random_vector(model.nv, 0.3, generator);
  const Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(theirs->reset(q, v), Status::Ok);
  ASSERT_EQ(ours->reset(q, v), Status::Ok);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(theirs->step(tau), Status::Ok);
  for (int i = 0; i < 40; ++i) ASSERT_EQ(ours->step(tau), Status::Ok);
  EXPECT_NEAR(theirs->time(), ours->time(), 1e-12);
  EXPECT_LE((theirs->q() - ours->q()).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LE((theirs->v() - ours->v()).cwiseAbs().maxCoeff(), 1e-2);
}

INSTANTIATE_TEST_SUITE_P(robots, MujocoPlantModel,
                         ::testing::Values(TestRobot{"talos:right_arm", Base::Fixed, "tool"},
                                           TestRobot{"talos", Base::FreeFlyer, "tool"},
                                           TestRobot{"crane", Base::FreeFlyer, "left_tip"},
                                           TestRobot{"followers", Base::Fixed, "tip"},
                                           TestRobot{"followers", Base::FreeFlyer, "z_5"}),
                         [](const auto& test) { return test.param.label(); });

TEST(MujocoPlant, Followers_AreAtTheirLeadersPositions) {
  const Model model = TestRobot{"followers", Base::Fixed, "tip"}.model();
  mujoco::Engine engine(model, out_of_reach("tip"), {});
  std::mt19937_64 generator(6);
  const Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd v = random_vector(model.nv, 1.0, generator);
  engine.coordinates.store(q, v, *engine.d);
  mj_fwdPosition(engine.m.get(), engine.d.get());
  const std::vector<Eigen::Isometry3d> placements = frame_placements(model, q);
  for (std::size_t f = 0; f < model.frames.size(); ++f) {
    const int site =
        mj_name2id(engine.m.get(), mjOBJ_SITE, mujoco::site_name(static_cast<int>(f)).c_str());
    EXPECT_LE((Eigen::Map<const Eigen::Vector3d>(engine.d->site_xpos + 3 * site) -
               placements[f].translation())
                  .norm(),
              1e-12)
        << model.frames[f].name;
  }
  Eigen::VectorXd q_back = model.q_neutral, v_back;
  engine.coordinates.load(*engine.d, q_back, v_back);
  EXPECT_LE((q_back - q).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LE((v_back - v).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(MujocoPlant, PenetrationDepth_IsForceOverStiffness) {
  for (const double stiffness : {2e4, 1e5}) {
    PolishingCase setup;
    setup.ki = 10.0;
    PolishingRun run(setup, [&](const Model& model, SceneSpec scene) {
      scene.tool().surface.stiffness = stiffness;
      return make_mujoco_plant(model, scene);
    });
    ASSERT_EQ(run.run(1.5 - run.plant().dt()), Status::Ok);
    const Eigen::VectorXd q_before = run.plant().q();
    ASSERT_EQ(run.run(run.plant().dt()), Status::Ok);
    RigidBody body(run.plant().model());
    ASSERT_EQ(body.update(run.plant().q(), run.plant().v()), Status::Ok);
    const double depth =
        -gap(run.plant().scene().tool(), body.placement(body.frame("tool")).translation());
    const double force = force_world(run.plant(), q_before).z();
    EXPECT_NEAR(force, 30.0, 1.0);
    EXPECT_NEAR(depth * stiffness / force, 1.0, 0.01);
  }
}

/// Presses and drags an arm over both kinds of contact.
TEST(MujocoPlant, ExactContact_MatchesTheEnginesContact) {
  for (const auto kind :
       {SurfaceShape::Kind::Plane, SurfaceShape::Kind::Sphere, SurfaceShape::Kind::Cylinder}) {
    Eigen::VectorXd q;
    const Model model = plant_model(right_arm(&q), {});
    const Eigen::Vector3d n = Eigen::Vector3d(0.1, -0.2, 1.0).normalized();
    TouchSpec tip = round_tip();
    tip.surface.friction = 0.3;
    tip.surface.damping = 200.0;
    tip.surface.shape = {.kind = kind, .radius = 0.3};
    const SceneSpec scene{.touches = {with_surface_at(model, q, n, tip)}};
    const auto run = [&](MujocoContact contact) {
      const auto plant = make_mujoco_plant(model, scene, {.contact = contact});
      EXPECT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
      RigidBody body(model);
      FrameDerivatives motion;
      const Eigen::Vector3d along = Reference::surface_with_normal(n).rotation.col(0);
      std::vector<Eigen::Vector3d> forces;
      for (int i = 0; i < 1200; ++i) {
        EXPECT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
        body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
        const Eigen::Vector3d push = -30.0 * n + (i < 1000 ? 0.0 : 12.0) * along;
        const Eigen::VectorXd tau = Eigen::VectorXd(body.gravity_torque()) +
                                    motion.jacobian.topRows(3).transpose() * push -
                                    3.0 * plant->v();
        const Eigen::VectorXd q_before = plant->q();
        EXPECT_EQ(plant->step(tau), Status::Ok);
        if (i == 999 || i == 1199) forces.push_back(force_world(*plant, q_before));
      }
      return forces;
    };
    const auto exact = run(MujocoContact::Exact), engine = run(MujocoContact::Engine);
    EXPECT_LT((exact[0] - engine[0]).norm(), 0.01 * engine[0].norm())
        << name_of(kind) << exact[0].transpose() << " and " << engine[0].transpose();
    // The engine lifts a sliding tip, so the forces differ in size, but not in direction.
    EXPECT_LT((exact[1].normalized() - engine[1].normalized()).norm(), 0.01)
        << name_of(kind) << exact[1].transpose() << " and " << engine[1].transpose();
  }
}

TEST(MujocoPlant, EngineContact_RefusesUnsupportedShapes) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene{.touches = {round_tip()}};
  scene.tool().surface.shape = {.kind = SurfaceShape::Kind::Saddle};
  const std::string sentence = testing::refusal(
      [&] { make_mujoco_plant(model, scene, {.contact = MujocoContact::Engine}); });
  testing::expect_words(sentence, {"does not support a saddle", "contact: exact"});
  scene.tool().surface.shape = {.kind = SurfaceShape::Kind::Sphere, .radius = 0.01, .hollow = true};
  testing::expect_words(testing::refusal([&] { make_mujoco_plant(model, scene); }),
                        {"0.02 m does not fit into the hollow sphere", "wanted a radius below"});
}

/// Returns the smallest joint velocities that move the tip with this velocity, without rotation.
Eigen::VectorXd moving_along(const Model& model, const Eigen::VectorXd& q,
                             const Eigen::Vector3d& v_world) {
  RigidBody body(model);
  FrameDerivatives motion;
  EXPECT_EQ(body.update(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
  Eigen::VectorXd twist = Eigen::VectorXd::Zero(6);
  twist.head<3>() = v_world;
  return motion.jacobian.completeOrthogonalDecomposition().solve(twist);
}

TEST(MujocoPlant, MovingSurface_GivesTheForceOfAnApproachingTip) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.6, 0.0, 0.8);
  const SceneSpec at_rest = plane_under_tip(model, q, normal, -1e-4);  // 10 N by stiffness
  SceneSpec moving = at_rest;
  moving.tool().surface.motion = {.drift = 0.02};  // 10 N by damping
  const auto force = [&](const SceneSpec& scene, const Eigen::VectorXd& v) {
    const auto plant = make_mujoco_plant(model, scene, {.dt = 1e-5});
    EXPECT_EQ(plant->reset(q, v), Status::Ok);
    EXPECT_EQ(plant->step(Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    return force_world(*plant, q);
  };
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.nv);
  const Eigen::Vector3d moving_force = force(moving, still);
  const Eigen::Vector3d approach_force = force(at_rest, moving_along(model, q, -0.02 * normal));
  EXPECT_LT((moving_force - approach_force).norm(), 1e-3 * approach_force.norm());
  EXPECT_GT(moving_force.norm(), 1.5 * force(at_rest, still).norm());
}

TEST(MujocoPlant, MovingSurface_CarriesThePressedTip) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene = plane_under_tip(model, q, {0.0, 0.0, 1.0});
  TouchSpec& tip = scene.tool();
  tip.surface.motion = {.amplitude = 2e-3, .frequency = 2.0, .drift = 5e-3, .start = 0.1};
  const auto plant = make_mujoco_plant(model, scene);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  RigidBody body(model);
  FrameDerivatives motion;
  while (plant->time() < 1.0) {
    ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
    body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
    const double height = body.placement(body.frame("tool")).translation().z();
    const double surface = tip.surface.point.z() + tip.surface.motion.displacement(plant->time());
    if (plant->time() > 0.05) {
      EXPECT_TRUE(is_touching(*plant)) << plant->time();
      EXPECT_NEAR(height - surface, tip.radius, 6e-4) << plant->time();
    }
    Eigen::VectorXd tau = body.gravity_torque() - 3.0 * plant->v();
    tau += motion.jacobian.topRows(3).transpose() * Eigen::Vector3d(0.0, 0.0, -30.0);
    ASSERT_EQ(plant->step(tau), Status::Ok);
  }
  EXPECT_EQ(tip.surface.motion.displacement(0.1), 0.0);
  EXPECT_NEAR(tip.surface.motion.displacement(0.225), 2e-3 + 0.125 * 5e-3, 1e-12);
}

TEST(MujocoPlant, Ridge_GivesANormalForceAtFacesAndEdge) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  constexpr double slope = 0.3, radius = 0.02;
  const auto direction = [&](double edge) {
    SceneSpec scene = plane_under_tip(model, q, {0.0, 0.0, 1.0});
    TouchSpec& tip = scene.tool();
    tip.surface.shape = {.kind = SurfaceShape::Kind::Ridge, .edge = edge, .slope = slope};
    // The tip is 0.1 mm inside the surface, at any edge position.
    const double clearance = gap(tip, frame_placement(model, q, "tool").translation());
    tip.surface.point.z() += (clearance + 1e-4) / std::cos(edge < -radius ? slope : 0.0);
    const auto plant = make_mujoco_plant(model, scene);
    EXPECT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    EXPECT_EQ(plant->step(Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    EXPECT_TRUE(is_touching(*plant)) << edge;
    const Eigen::Vector3d force = force_world(*plant, q).normalized();
    const Eigen::Matrix3d axes = Reference::surface_with_normal({0.0, 0.0, 1.0}).rotation;
    const Eigen::Vector3d seen = axes.transpose() * force;
    EXPECT_NEAR(seen.y(), 0.0, 1e-12);
    return std::atan2(seen.x(), seen.z());
  };
  EXPECT_NEAR(direction(0.01), 0.0, 1e-12);
  EXPECT_NEAR(direction(-0.05), slope, 1e-12);
  const double over = direction(-0.5 * radius * std::sin(slope));
  EXPECT_GT(over, 0.1 * slope);
  EXPECT_LT(over, 0.9 * slope);
}

TEST(MujocoPlant, MovingSurface_IsRefusedByPlantsWithoutSupport) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene{.touches = {round_tip()}};
  scene.tool().surface.motion.amplitude = 1e-3;
  testing::expect_words(testing::refusal([&] {
                          make_mujoco_plant(model, scene, {.contact = MujocoContact::Engine});
                        }),
                        {"does not support a moving surface", "contact: exact"});
  testing::expect_words(testing::refusal([&] { make_ideal_plant(model, scene); }),
                        {"surface moves", "MuJoCo as the plant"});
}

TEST(MujocoPlant, DivergingTorque_ReturnsAStatusAndKeepsTheState) {
  Eigen::VectorXd q;
  const Model model = right_arm(&q);
  const SceneSpec scene = plane_under_tip(model, q, {0.0, 0.0, 1.0});
  const auto plant = make_mujoco_plant(model, scene);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const Eigen::VectorXd huge = Eigen::VectorXd::Constant(model.nv, 5e8);
  EXPECT_EQ(plant->step(huge), Status::NotFinite);
  EXPECT_EQ(plant->q(), q);
  EXPECT_EQ(plant->step(Eigen::VectorXd::Zero(model.nv)), Status::Ok);
}

TEST(MujocoPlant, JointStops_LimitPositionsUnlessDisabled) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  const SceneSpec scene = out_of_reach();
  MujocoPlantOptions without_stops;
  without_stops.joint_stops = false;
  const auto stopped = make_mujoco_plant(model, scene);
  const auto endless = make_mujoco_plant(model, scene, without_stops);
  const int last = model.nv - 1;
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  tau[last] = 30.0;
  for (Plant* plant : {stopped.get(), endless.get()}) {
    ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(plant->step(tau), Status::Ok);
  }
  EXPECT_LE(stopped->q()[last], model.q_upper[last] + 0.1);
  EXPECT_GT(endless->q()[last], model.q_upper[last] + 0.5);
}

TEST(MujocoPlant, InvalidOptions_AreRefused) {
  Eigen::VectorXd q;
  const Model model = right_arm(&q);
  MujocoPlantOptions options;
  options.impedance = 1.0;
  testing::expect_words(testing::refusal([&] { make_mujoco_plant(model, {}, options); }),
                        {"impedance", "more than 0 and less than 1"});
  options = {};
  options.dt = -1.0;
  testing::expect_words(testing::refusal([&] { make_mujoco_plant(model, {}, options); }),
                        {"dt", "-1"});
}

}  // namespace
}  // namespace burnish::test
