// Laws that every plant must satisfy. A new plant joins with one line.
#include <gtest/gtest.h>

#include <limits>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#ifdef BURNISH_HAS_MUJOCO
#include "burnish/mujoco/mujoco_plant.hpp"
#endif
#include "support/allocation_guard.hpp"
#include "support/constant_torque.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

struct Kind {
  std::string name;
  std::unique_ptr<Plant> (*make)(const Model&, const SceneSpec&);
  double sinking;   ///< penetration under 30 N [m]
  double stiction;  ///< creep of joints under static friction [rad/s]
};
void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

std::vector<Kind> kinds() {
  std::vector<Kind> result{
      {"ideal", [](const Model& m, const SceneSpec& s) { return make_ideal_plant(m, s); }, 1e-7,
       1e-9}};
#ifdef BURNISH_HAS_MUJOCO
  result.push_back({"mujoco",
                    [](const Model& m, const SceneSpec& s) { return make_mujoco_plant(m, s); },
                    4e-4, 1e-3});
  result.push_back({"engine",
                    [](const Model& m, const SceneSpec& s) {
                      return make_mujoco_plant(m, s, {.contact = MujocoContact::Engine});
                    },
                    4e-4, 1e-2});
#endif
  return result;
}

class PlantLaw : public ::testing::TestWithParam<Kind> {
 protected:
  explicit PlantLaw() : model(plant_model(right_arm(&q), {})) {}

  SceneSpec scene(const Eigen::Vector3d& normal, double clearance, double friction = 0.0) const {
    return plane_under_tip(model, q, normal, clearance, friction);
  }
  std::unique_ptr<Plant> at_rest(const Eigen::Vector3d& normal, double clearance,
                                 double friction = 0.0) const {
    return started(model, scene(normal, clearance, friction));
  }
  std::unique_ptr<Plant> started(const Model& robot, const SceneSpec& where) const {
    std::unique_ptr<Plant> plant = GetParam().make(robot, where);
    EXPECT_EQ(plant->reset(q, Eigen::VectorXd::Zero(robot.nv)), Status::Ok);
    return plant;
  }
  /// Returns torques that compensate gravity and make the tool push with a force.
  Eigen::VectorXd holding(const Plant& plant, const Eigen::Vector3d& force_world) {
    EXPECT_EQ(body.update(plant.q(), plant.v()), Status::Ok);
    body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
    return body.gravity_torque() + motion.jacobian.topRows(3).transpose() * force_world -
           2.0 * plant.v();
  }

  Eigen::VectorXd q;
  Model model;
  RigidBody body{model};
  FrameDerivatives motion;
};

TEST_P(PlantLaw, FreeMotion_MatchesTheModelsAcceleration) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.5);
  ContactDynamics dynamics(model);
  std::mt19937_64 generator(3);
  const Eigen::VectorXd v = random_vector(model.nv, 0.5, generator);
  const Eigen::VectorXd tau = random_vector(model.nv, 20.0, generator);
  ASSERT_EQ(plant->reset(q, v), Status::Ok);
  ASSERT_EQ(dynamics.forward(q, v, tau), Status::Ok);
  ASSERT_EQ(plant->step(tau), Status::Ok);
  const Eigen::VectorXd a = (plant->v() - v) / plant->dt();
  EXPECT_LE((a - dynamics.a()).norm(), 0.02 * dynamics.a().norm());
  EXPECT_EQ(plant->time(), plant->dt());
  EXPECT_FALSE(is_touching(*plant));
}

TEST_P(PlantLaw, PressedSurface_ReactsAlongItsNormal) {
  for (const Eigen::Vector3d& normal :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(-0.6, 0.0, 0.8)}) {
    const auto plant = at_rest(normal, 0.0);
    // The contact is frictionless: the reaction to a normal force is along the normal.
    Eigen::VectorXd q_before;
    for (int i = 0; i < 200; ++i) {
      q_before = plant->q();
      ASSERT_EQ(plant->step(holding(*plant, -30.0 * normal)), Status::Ok);
    }
    EXPECT_TRUE(is_touching(*plant));
    const Eigen::Vector3d force = force_world(*plant, q_before);
    EXPECT_GT(force.dot(normal), 5.0);
    EXPECT_LE((force - force.dot(normal) * normal).norm(), 1e-9 * force.norm());
    ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
    const double depth =
        gap(plant->scene().tool(), body.placement(body.frame("tool")).translation());
    EXPECT_LE(depth, 1e-5);
    EXPECT_GE(depth, -GetParam().sinking);
  }
}

TEST_P(PlantLaw, SurfaceExtent_EndsTheContact) {
  const Eigen::Vector3d normal(-0.6, 0.0, 0.8);
  SceneSpec square = scene(normal, 0.0);
  square.tool().surface.extent = 0.05;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(normal).rotation;
  for (const int side : {0, 1})
    for (const double offset : {-0.051, -0.049, 0.049, 0.051}) {
      SceneSpec beside = square;
      beside.tool().surface.point += offset * axes.col(side);
      const auto plant = started(model, beside);
      for (int i = 0; i < 20; ++i)
        ASSERT_EQ(plant->step(holding(*plant, -30.0 * normal)), Status::Ok);
      EXPECT_EQ(is_touching(*plant), std::abs(offset) < 0.05) << side << " " << offset;
    }
}

TEST_P(PlantLaw, TipBeyondTheEdge_HasNoContactFromBelow) {
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  SceneSpec square = scene(normal, 0.0);
  square.tool().surface.extent = 0.05;
  const Eigen::Vector3d along = Reference::surface_with_normal(normal).rotation.col(0);
  square.tool().surface.point -= 0.049 * along;
  const auto plant = started(model, square);
  const auto push = [&](const Eigen::Vector3d& force, int steps) {
    for (int i = 0; i < steps; ++i) ASSERT_EQ(plant->step(holding(*plant, force)), Status::Ok);
  };
  push(-20.0 * normal, 20);
  EXPECT_TRUE(is_touching(*plant));
  push(-20.0 * normal + 20.0 * along, 400);
  EXPECT_FALSE(is_touching(*plant));
  push(-60.0 * normal, 200);
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  EXPECT_LT(body.placement(body.frame("tool")).translation().dot(normal),
            square.tool().surface.point.dot(normal));
  push(-40.0 * along - 20.0 * normal, 400);
  EXPECT_FALSE(is_touching(*plant));
}

TEST_P(PlantLaw, SoftSurface_StaysInContactWhenTheTipSinks) {
  // 60 N sink the tip by 12 cm, six of its radii. A surface with an extent must support it like an
  // endless one.
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  SceneSpec soft = scene(normal, 0.0);
  soft.tool().surface.stiffness = 500.0;
  SceneSpec square = soft;
  square.tool().surface.extent = 0.4;
  Model braked = model;
  braked.damping.setConstant(50.0);
  const auto endless = started(braked, soft), ending = started(braked, square);
  for (int i = 0; i < 4000; ++i)
    for (const auto* plant : {&endless, &ending})
      ASSERT_EQ((*plant)->step(holding(**plant, -60.0 * normal)), Status::Ok);
  EXPECT_GT(ending->wrenches().col(0).head<3>().norm(), 30.0);
  EXPECT_EQ(ending->q(), endless->q());
}

TEST_P(PlantLaw, AtRest_GravityContactAndTorqueBalance) {
  // The robot's joints are damped strongly, so the surface's force balances the tool's force.
  Model braked = model;
  braked.damping.setConstant(200.0);
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  const auto plant = started(braked, scene(normal, 0.0));
  Eigen::VectorXd tau, q_before;
  for (int i = 0; i < 4000; ++i) {
    tau = holding(*plant, -30.0 * normal) + 2.0 * plant->v();
    q_before = plant->q();
    ASSERT_EQ(plant->step(tau), Status::Ok);
  }
  // M a = tau - gravity + friction + J^T force, with a and v almost zero.
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Eigen::Vector3d force = force_world(*plant, q_before);
  const Eigen::VectorXd rest =
      tau - body.gravity_torque() + plant->friction_torque() + torque_of_force(body, "tool", force);
  EXPECT_LE(rest.cwiseAbs().maxCoeff(), 0.1);
  EXPECT_GT(force.z(), 5.0);
}

TEST_P(PlantLaw, Push_EqualsItsJointTorques) {
  const Eigen::Vector3d push(3.0, -4.0, 5.0);
  const auto pushed = at_rest({0.0, 0.0, 1.0}, 0.5), driven = at_rest({0.0, 0.0, 1.0}, 0.5);
  const Eigen::VectorXd hold = holding(*pushed, Eigen::Vector3d::Zero());
  ConstantTorque controller(hold);
  ClosedLoop loop(*pushed, controller, {.pushes = {{.duration = 1.0, .force_world = push}}});
  ASSERT_EQ(loop.reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  ASSERT_EQ(loop.step(), Status::Ok);
  ASSERT_EQ(driven->step(hold + torque_of_force(body, "tool", push)), Status::Ok);
  EXPECT_LE((pushed->v() - driven->v()).norm(), 1e-12);
  EXPECT_GT(pushed->v().norm(), 1e-4);
}

TEST_P(PlantLaw, SeparatingTip_GetsNoForce) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.0, 0.3);
  for (int i = 0; i < 400; ++i) {
    const double pressed = i < 100 ? -30.0 : 30.0;
    const Eigen::VectorXd q_before = plant->q();
    ASSERT_EQ(plant->step(holding(*plant, {0.0, 0.0, pressed})), Status::Ok);
    const Eigen::Vector3d force = force_world(*plant, q_before);
    EXPECT_GE(force.z(), 0.0);
    EXPECT_EQ(is_touching(*plant), force.z() > 0.0);
  }
  EXPECT_FALSE(is_touching(*plant));
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  EXPECT_GT(gap(plant->scene().tool(), body.placement(body.frame("tool")).translation()), 1e-3);
}

TEST_P(PlantLaw, SlidingTip_GetsCoulombFrictionAgainstItsMotion) {
  const double mu = 0.3;
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.0, mu);
  Eigen::VectorXd q_before;
  for (int i = 0; i < 300; ++i) {
    q_before = plant->q();
    ASSERT_EQ(plant->step(holding(*plant, {40.0, 0.0, -30.0})), Status::Ok);
  }
  const Eigen::Vector3d force = force_world(*plant, q_before);
  const Eigen::Vector2d sliding = force.head<2>();
  EXPECT_NEAR(sliding.norm(), mu * force.z(), 0.02 * mu * force.z());
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 v = body.velocity(body.frame("tool"), Reference::centered());
  const Eigen::Vector3d arm(0.0, 0.0, -plant->scene().tool().radius);
  const Eigen::Vector3d at_point = v.head<3>() + v.tail<3>().cross(arm);
  EXPECT_GT(at_point.head<2>().norm(), 1e-3);
  EXPECT_LE(sliding.dot(at_point.head<2>()), -0.99 * sliding.norm() * at_point.head<2>().norm())
      << sliding.transpose() << " and " << at_point.transpose();
}

TEST_P(PlantLaw, JointFriction_HoldsAndDampsJoints) {
  Model stiff_joints = model;
  stiff_joints.friction.setConstant(200.0);
  const auto blocked = started(stiff_joints, scene({0.0, 0.0, 1.0}, 0.5));
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(model.nv);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(blocked->step(none), Status::Ok);
  EXPECT_LE(blocked->v().cwiseAbs().maxCoeff(), GetParam().stiction);
  // Friction carries gravity.
  ASSERT_EQ(body.update(blocked->q(), blocked->v()), Status::Ok);
  EXPECT_LE((blocked->friction_torque() - body.gravity_torque()).norm(),
            0.02 * body.gravity_torque().norm());

  Model slowed = model;
  slowed.damping.setConstant(3.0);
  const auto plant = started(slowed, scene({0.0, 0.0, 1.0}, 0.5));
  for (int i = 0; i < 100; ++i) ASSERT_EQ(plant->step(none), Status::Ok);
  EXPECT_LE((plant->friction_torque() + 3.0 * plant->v()).norm(), 0.05 * 3.0 * plant->v().norm());
}

TEST_P(PlantLaw, SpringsAndTendons_ActAsTheModelsPassiveTorque) {
  Model sprung = model;
  sprung.stiffness.setConstant(80.0);
  sprung.spring_rest.setConstant(0.3);
  const auto entry = [&](int k, double coefficient) {
    return Tendon::Entry{sprung.joints[static_cast<std::size_t>(sprung.joint_of_v[k])].q_index, k,
                         coefficient};
  };
  sprung.tendons = {{"tendon", {entry(0, 1.0), entry(2, -2.0)}, 0.1, 50.0, 3.0}};
  RigidBody sprung_body(sprung);
  ContactDynamics dynamics(sprung);
  std::mt19937_64 generator(3);
  const Eigen::VectorXd v = random_vector(model.nv, 0.5, generator);
  const Eigen::VectorXd tau = random_vector(model.nv, 20.0, generator);
  const auto plant = started(sprung, scene({0.0, 0.0, 1.0}, 0.5));
  ASSERT_EQ(plant->reset(q, v), Status::Ok);
  ASSERT_EQ(sprung_body.update(q, v), Status::Ok);
  // The reference plant keeps the arm's own damping and friction.
  Model unsprung = sprung;
  unsprung.stiffness.setZero();
  unsprung.tendons.clear();
  const auto loose = started(unsprung, scene({0.0, 0.0, 1.0}, 0.5));
  ASSERT_EQ(loose->reset(q, v), Status::Ok);
  RigidBody loose_body(unsprung);
  ASSERT_EQ(loose_body.update(q, v), Status::Ok);
  const Eigen::VectorXd pull = sprung_body.passive_torque() - loose_body.passive_torque();
  EXPECT_GT(pull.norm(), 50.0);
  ASSERT_EQ(plant->step(tau), Status::Ok);
  ASSERT_EQ(loose->step(tau + pull), Status::Ok);
  const double moved = (loose->v() - v).norm();
  EXPECT_LE((plant->v() - loose->v()).norm(), 0.02 * moved);
  EXPECT_LE((plant->friction_torque() - loose->friction_torque() - pull).norm(),
            0.02 * pull.norm());
}

TEST_P(PlantLaw, RestoredSnapshot_GivesTheSameBits) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 1e-4, 0.3);
  const auto drive = [&](int steps) {
    for (int i = 0; i < steps; ++i)
      ASSERT_EQ(plant->step(holding(*plant, {10.0, 1.0, -30.0})), Status::Ok);
  };
  drive(150);
  PlantSnapshot snapshot;
  plant->save(snapshot);
  const Wrenches wrenches = plant->wrenches();
  drive(100);
  const Eigen::VectorXd q_then = plant->q(), v_then = plant->v();
  const Wrenches wrenches_then = plant->wrenches();
  EXPECT_NE(wrenches, wrenches_then);
  ASSERT_EQ(plant->restore(snapshot), Status::Ok);
  EXPECT_EQ(plant->wrenches(), wrenches);
  EXPECT_NEAR(plant->time(), 150 * plant->dt(), 1e-12);
  drive(100);
  EXPECT_EQ(plant->q(), q_then);
  EXPECT_EQ(plant->v(), v_then);
  EXPECT_EQ(plant->wrenches(), wrenches_then);

  snapshot.numbers.conservativeResize(snapshot.numbers.size() - 1);
  EXPECT_EQ(plant->restore(snapshot), Status::WrongSize);
  EXPECT_EQ(plant->q(), q_then);
}

TEST_P(PlantLaw, InvalidInput_ReturnsAStatusAndKeepsTheState) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.0);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.nv);
  Eigen::VectorXd bad = v;
  bad[2] = std::numeric_limits<double>::quiet_NaN();
  Eigen::VectorXd endless = v;
  endless[2] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(plant->step(bad), Status::NotFinite);
  EXPECT_EQ(plant->step(endless), Status::NotFinite);
  EXPECT_EQ(plant->step(v.head(3)), Status::WrongSize);
  EXPECT_EQ(plant->reset(q, bad), Status::NotFinite);
  EXPECT_EQ(plant->reset(q.head(2), v), Status::WrongSize);
  EXPECT_EQ(plant->q(), q);
  EXPECT_EQ(plant->v(), v);
  EXPECT_EQ(plant->time(), 0.0);
}

TEST_P(PlantLaw, RobotWithoutATool_TouchesNothing) {
  const SceneSpec without;
  const auto above = started(model, scene({0.0, 0.0, 1.0}, 0.5));
  const auto plant = started(model, without);
  const Eigen::VectorXd tau = Eigen::VectorXd::LinSpaced(model.nv, -5.0, 5.0);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(plant->step(tau), Status::Ok);
    ASSERT_EQ(above->step(tau), Status::Ok);
  }
  EXPECT_LT((plant->q() - above->q()).norm(), 1e-12);
  EXPECT_EQ(plant->wrenches().cols(), 0);
  PlantSnapshot snapshot;
  plant->save(snapshot);
  EXPECT_EQ(plant->restore(snapshot), Status::Ok);
  EXPECT_EQ(without.tool_index(), -1);
  testing::expect_words(testing::refusal([&] { (void)without.tool(); }),
                        {"no tool", "not a support"});
  testing::expect_words(testing::refusal([&] {
                          (void)with_surface_at(model, q, {0.0, 0.0, 1.0}, {});
                        }),
                        {"touch", "no frame"});
}

TEST_P(PlantLaw, InvalidScenes_AreRefused) {
  const auto refused = [&](auto&& change) {
    SceneSpec bad = scene({0.0, 0.0, 1.0}, 0.0);
    change(bad);
    return testing::refusal([&] { GetParam().make(model, bad); });
  };
  testing::expect_words(refused([](SceneSpec& s) { s.tool().frame = "tol"; }), {"'tol'", "tool"});
  const std::string root = has_robot_files ? "base_link" : "base";
  testing::expect_words(refused([&](SceneSpec& s) { s.tool().frame = root; }),
                        {root, "fixed to the world"});
  testing::expect_words(refused([](SceneSpec& s) { s.tool().surface.normal.setZero(); }),
                        {"normal"});
  testing::expect_words(refused([](SceneSpec& s) { s.tool().surface.friction = -1.0; }),
                        {"friction", "-1"});
  testing::expect_words(refused([](SceneSpec& s) { s.tool().radius = 0.0; }),
                        {"radius", "more than 0"});
}

TEST_P(PlantLaw, InvalidTouches_AreRefused) {
  const auto refused = [&](auto&& change) {
    SceneSpec bad = scene({0.0, 0.0, 1.0}, 0.0);
    bad.touches.push_back(bad.tool());
    bad.touches[1].is_support = true;
    change(bad.touches[1]);
    return testing::refusal([&] { GetParam().make(model, bad); });
  };
  const std::string flange = has_robot_files ? "wrist_right_ft_link" : "flange";
  testing::expect_words(refused([](TouchSpec&) {}), {"two touches with frame 'tool'"});
  testing::expect_words(refused([](TouchSpec& t) { t.frame.clear(); }), {"touch", "no frame"});
  testing::expect_words(refused([&](TouchSpec& t) {
                          t.frame = flange;
                          t.half_x = 0.1;
                        }),
                        {flange, "0.1 and 0 m", "both above 0 for a rectangle"});
  testing::expect_words(refused([&](TouchSpec& t) {
                          t.frame = flange;
                          t.half_x = t.half_y = 0.1;
                          t.is_support = false;
                        }),
                        {flange, "a rectangle, but not a support", "half_x"});
  const auto surface_refused = [&](auto&& change) {
    return refused([&](TouchSpec& t) {
      t.frame = flange;
      change(t.surface);
    });
  };
  const std::string wanted = "wanted a plane in the world without edges for a support";
  testing::expect_words(surface_refused([](SurfaceSpec& s) {
                          s.shape = {.kind = SurfaceShape::Kind::Sphere, .radius = 0.5};
                        }),
                        {flange, "its surface is a sphere", wanted});
  const std::string carrier = has_robot_files ? "torso_2_link" : "link_1";
  testing::expect_words(surface_refused([&](SurfaceSpec& s) { s.frame = carrier; }),
                        {flange, "its surface is carried by frame", carrier, wanted});
  testing::expect_words(surface_refused([](SurfaceSpec& s) { s.motion.drift = 0.1; }),
                        {flange, "its surface moves", wanted});
  testing::expect_words(surface_refused([](SurfaceSpec& s) { s.extent = 0.1; }),
                        {flange, "its surface has edges", wanted});
}

TEST_P(PlantLaw, Run_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  Model with_friction = model;
  with_friction.friction.setConstant(0.5);
  with_friction.damping.setConstant(0.5);
  const auto plant = started(with_friction, scene({0.0, 0.0, 1.0}, 1e-4, 0.3));
  const Eigen::VectorXd tau = holding(*plant, {6.0, 0.0, -30.0});
  PlantSnapshot snapshot;
  plant->save(snapshot);
  Status status = Status::Ok;
  bool touched = false;
  const AllocationGuard guard;
  for (int i = 0; i < 200; ++i) {
    status = worst(status, plant->step(tau));
    touched = touched || is_touching(*plant);
  }
  plant->save(snapshot);
  status = worst(status, plant->restore(snapshot));
  status = worst(status, plant->reset(q, plant->v()));
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(status, Status::Ok);
  EXPECT_TRUE(touched);
}

INSTANTIATE_TEST_SUITE_P(plants, PlantLaw, ::testing::ValuesIn(kinds()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace burnish::test
