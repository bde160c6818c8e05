// MuJoCo as a plant: the same robot as the model to the last digits, and the contact that was asked
// for.
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

TEST_P(MujocoPlantModel, has_the_mass_matrix_and_the_bias_of_the_model) {
  const Model model = GetParam().model();
  SceneSpec scene;
  scene.tip.frame = GetParam().tool;
  scene.surface.point.z() = -100.0;
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

TEST_P(MujocoPlantModel, falls_as_the_ideal_plant_does) {
  const Model model = plant_model(GetParam().model(), {});
  SceneSpec scene;
  scene.tip.frame = GetParam().tool;
  scene.surface.point.z() = -100.0;
  MujocoPlantOptions fine;
  fine.dt = 2e-5;  // its integrator is of first order
  fine.joint_stops = false;
  const auto theirs = make_mujoco_plant(model, scene, fine);
  const auto ours = make_ideal_plant(model, scene);
  std::mt19937_64 generator(8);
  const Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd v = random_vector(model.nv, 0.3, generator);
  const Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  ASSERT_EQ(theirs->reset(q, v), Status::Ok);
  ASSERT_EQ(ours->reset(q, v), Status::Ok);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(theirs->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  for (int i = 0; i < 40; ++i) ASSERT_EQ(ours->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
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

TEST(MujocoPlant, keeps_followers_where_their_leaders_put_them) {
  const Model model = TestRobot{"followers", Base::Fixed, "tip"}.model();
  SceneSpec scene;
  scene.tip.frame = "tip";
  scene.surface.point.z() = -100.0;
  mujoco::Engine engine(model, scene, {});
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

TEST(MujocoPlant, sinks_in_by_the_force_over_the_stiffness) {
  for (const double stiffness : {2e4, 1e5}) {
    PolishingCase wanted;
    wanted.ki = 10.0;
    PolishingRun run(wanted, [&](const Model& model, SceneSpec scene) {
      scene.surface.stiffness = stiffness;
      return make_mujoco_plant(model, scene);
    });
    ASSERT_EQ(run.run(1.5), Status::Ok);
    RigidBody body(run.plant().model());
    ASSERT_EQ(body.update(run.plant().q(), run.plant().v()), Status::Ok);
    const double depth =
        -gap(run.plant().scene(), body.placement(body.frame("tool")).translation());
    const double force = run.plant().contact_force_world().z();
    EXPECT_NEAR(force, 30.0, 1.0);
    EXPECT_NEAR(depth * stiffness / force, 1.0, 0.01);
  }
}

/// The same arm pushed and drawn along, over both contacts.
TEST(MujocoPlant, its_exact_contact_pushes_as_the_engines_own_does) {
  for (const auto kind :
       {SurfaceShape::Kind::Plane, SurfaceShape::Kind::Sphere, SurfaceShape::Kind::Cylinder}) {
    Eigen::VectorXd q;
    const Model model = plant_model(right_arm(&q), {});
    const Eigen::Vector3d n = Eigen::Vector3d(0.1, -0.2, 1.0).normalized();
    SceneSpec scene;
    scene.surface.friction = 0.3;
    scene.surface.damping = 200.0;
    scene.surface.shape = {.kind = kind, .radius = 0.3};
    scene = scene_under_tip(model, q, n, scene);
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
        EXPECT_EQ(plant->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
        if (i == 999 || i == 1199) forces.push_back(plant->contact_force_world());
      }
      return forces;
    };
    const auto exact = run(MujocoContact::Exact), engine = run(MujocoContact::Engine);
    EXPECT_LT((exact[0] - engine[0]).norm(), 0.01 * engine[0].norm())
        << name_of(kind) << exact[0].transpose() << " and " << engine[0].transpose();
    // The engine lifts what slides, so that the forces differ, but not their direction.
    EXPECT_LT((exact[1].normalized() - engine[1].normalized()).norm(), 0.01)
        << name_of(kind) << exact[1].transpose() << " and " << engine[1].transpose();
  }
}

TEST(MujocoPlant, the_engines_own_contact_is_refused_for_what_it_has_not) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene;
  scene.surface.shape = {.kind = SurfaceShape::Kind::Saddle};
  const std::string sentence = testing::refusal(
      [&] { make_mujoco_plant(model, scene, {.contact = MujocoContact::Engine}); });
  testing::expect_words(sentence, {"has no saddle", "contact: exact"});
  scene.surface.shape = {.kind = SurfaceShape::Kind::Sphere, .radius = 0.01, .hollow = true};
  testing::expect_words(testing::refusal([&] { make_mujoco_plant(model, scene); }),
                        {"0.02 m does not fit into the hollow sphere", "smaller tip"});
}

/// The tip's velocity that joint velocities make along a direction alone, by the least of them.
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

TEST(MujocoPlant, a_surface_that_moves_pushes_as_one_at_rest_that_is_moved_into) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  const Eigen::Vector3d normal = Eigen::Vector3d(-0.6, 0.0, 0.8);
  SceneSpec rest = scene_under_tip(model, q, normal, {}, -1e-4);  // 10 N deep
  SceneSpec moves = rest;
  moves.surface.motion = {.drift = 0.02};  // 10 N by damping
  const auto force = [&](const SceneSpec& scene, const Eigen::VectorXd& v) {
    const auto plant = make_mujoco_plant(model, scene, {.dt = 1e-5});
    EXPECT_EQ(plant->reset(q, v), Status::Ok);
    EXPECT_EQ(plant->step(Eigen::VectorXd::Zero(model.nv), Eigen::Vector3d::Zero()), Status::Ok);
    return plant->contact_force_world();
  };
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.nv);
  const Eigen::Vector3d pushed = force(moves, still);
  const Eigen::Vector3d met = force(rest, moving_along(model, q, -0.02 * normal));
  EXPECT_LT((pushed - met).norm(), 1e-3 * met.norm());
  EXPECT_GT(pushed.norm(), 1.5 * force(rest, still).norm());
}

TEST(MujocoPlant, a_surface_carries_the_tip_that_is_pressed_on_it) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene = scene_under_tip(model, q, {0.0, 0.0, 1.0});
  scene.surface.motion = {.amplitude = 2e-3, .frequency = 2.0, .drift = 5e-3, .start = 0.1};
  const auto plant = make_mujoco_plant(model, scene);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  RigidBody body(model);
  FrameDerivatives motion;
  while (plant->time() < 1.0) {
    ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
    body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
    const double height = body.placement(body.frame("tool")).translation().z();
    const double surface = scene.surface.point.z() + scene.surface.motion.way(plant->time());
    if (plant->time() > 0.05) {
      EXPECT_TRUE(plant->in_contact()) << plant->time();
      EXPECT_NEAR(height - surface, scene.tip.radius, 6e-4) << plant->time();
    }
    Eigen::VectorXd tau = body.gravity_torque() - 3.0 * plant->v();
    tau += motion.jacobian.topRows(3).transpose() * Eigen::Vector3d(0.0, 0.0, -30.0);
    ASSERT_EQ(plant->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  }
  EXPECT_EQ(scene.surface.motion.way(0.1), 0.0);
  EXPECT_NEAR(scene.surface.motion.way(0.225), 2e-3 + 0.125 * 5e-3, 1e-12);
}

TEST(MujocoPlant, an_edge_pushes_along_the_plane_that_is_touched_and_between_them_over_it) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  constexpr double slope = 0.3, radius = 0.02;
  const auto direction = [&](double edge) {
    SceneSpec scene = scene_under_tip(model, q, {0.0, 0.0, 1.0});
    scene.surface.shape = {.kind = SurfaceShape::Kind::Ridge, .edge = edge, .slope = slope};
    // Sunk by a tenth of a millimetre, wherever the nearest point is.
    const double above = gap(scene, frame_placement(model, q, "tool").translation());
    scene.surface.point.z() += (above + 1e-4) / std::cos(edge < -radius ? slope : 0.0);
    const auto plant = make_mujoco_plant(model, scene);
    EXPECT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    EXPECT_EQ(plant->step(Eigen::VectorXd::Zero(model.nv), Eigen::Vector3d::Zero()), Status::Ok);
    EXPECT_TRUE(plant->in_contact()) << edge;
    const Eigen::Vector3d force = plant->contact_force_world().normalized();
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

TEST(MujocoPlant, surfaces_that_move_are_refused_where_they_cannot) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene;
  scene.surface.motion.amplitude = 1e-3;
  testing::expect_words(testing::refusal([&] {
                          make_mujoco_plant(model, scene, {.contact = MujocoContact::Engine});
                        }),
                        {"no surface that moves", "contact: exact"});
  testing::expect_words(testing::refusal([&] { make_ideal_plant(model, scene); }),
                        {"surface moves", "MuJoCo as the plant"});
}

TEST(MujocoPlant, answers_a_torque_that_blows_up_with_a_status) {
  Eigen::VectorXd q;
  const Model model = right_arm(&q);
  SceneSpec scene = scene_under_tip(model, q, {0.0, 0.0, 1.0});
  const auto plant = make_mujoco_plant(model, scene);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const Eigen::VectorXd huge = Eigen::VectorXd::Constant(model.nv, 5e8);
  EXPECT_EQ(plant->step(huge, Eigen::Vector3d::Zero()), Status::NotFinite);
  EXPECT_EQ(plant->q(), q);
  EXPECT_EQ(plant->step(Eigen::VectorXd::Zero(model.nv), Eigen::Vector3d::Zero()), Status::Ok);
}

TEST(MujocoPlant, stops_joints_at_their_limits_unless_told_not_to) {
  Eigen::VectorXd q;
  const Model model = plant_model(right_arm(&q), {});
  SceneSpec scene;
  scene.surface.point.z() = -100.0;
  MujocoPlantOptions free;
  free.joint_stops = false;
  const auto stopped = make_mujoco_plant(model, scene);
  const auto endless = make_mujoco_plant(model, scene, free);
  const int last = model.nv - 1;
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  tau[last] = 30.0;
  for (Plant* plant : {stopped.get(), endless.get()}) {
    ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(plant->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  }
  EXPECT_LE(stopped->q()[last], model.q_upper[last] + 0.1);
  EXPECT_GT(endless->q()[last], model.q_upper[last] + 0.5);
}

TEST(MujocoPlant, refuses_options_with_a_sentence) {
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
