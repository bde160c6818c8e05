// Laws that every plant must satisfy. A new plant joins with one line.
#include <gtest/gtest.h>

#include <limits>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/sim/ideal_plant.hpp"
#ifdef BURNISH_HAS_MUJOCO
#include "burnish/mujoco/mujoco_plant.hpp"
#endif
#include "support/allocation_guard.hpp"
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
    SceneSpec result;
    result.surface.friction = friction;
    return scene_under_tip(model, q, normal, result, clearance);
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
  ASSERT_EQ(plant->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  const Eigen::VectorXd a = (plant->v() - v) / plant->dt();
  EXPECT_LE((a - dynamics.a()).norm(), 0.02 * dynamics.a().norm());
  EXPECT_EQ(plant->time(), plant->dt());
  EXPECT_FALSE(plant->in_contact());
  EXPECT_EQ(plant->contact_force_world(), Eigen::Vector3d::Zero());
}

TEST_P(PlantLaw, PressedSurface_ReactsAlongItsNormal) {
  for (const Eigen::Vector3d& normal :
       {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(-0.6, 0.0, 0.8)}) {
    const auto plant = at_rest(normal, 0.0);
    // The contact is frictionless: the reaction to a normal force is along the normal.
    for (int i = 0; i < 200; ++i)
      ASSERT_EQ(plant->step(holding(*plant, -30.0 * normal), Eigen::Vector3d::Zero()), Status::Ok);
    EXPECT_TRUE(plant->in_contact());
    const Eigen::Vector3d force = plant->contact_force_world();
    EXPECT_GT(force.dot(normal), 5.0);
    EXPECT_LE((force - force.dot(normal) * normal).norm(), 1e-9 * force.norm());
    ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
    const double depth = gap(plant->scene(), body.placement(body.frame("tool")).translation());
    EXPECT_LE(depth, 1e-5);
    EXPECT_GE(depth, -GetParam().sinking);
  }
}

TEST_P(PlantLaw, SurfaceExtent_EndsTheContact) {
  const Eigen::Vector3d normal(-0.6, 0.0, 0.8);
  SceneSpec square = scene(normal, 0.0);
  square.surface.extent = 0.05;
  const Eigen::Matrix3d axes = Reference::surface_with_normal(normal).rotation;
  for (const int side : {0, 1})
    for (const double offset : {-0.051, -0.049, 0.049, 0.051}) {
      SceneSpec beside = square;
      beside.surface.point += offset * axes.col(side);
      const auto plant = started(model, beside);
      for (int i = 0; i < 20; ++i)
        ASSERT_EQ(plant->step(holding(*plant, -30.0 * normal), Eigen::Vector3d::Zero()),
                  Status::Ok);
      EXPECT_EQ(plant->in_contact(), std::abs(offset) < 0.05) << side << " " << offset;
    }
}

TEST_P(PlantLaw, TipBeyondTheEdge_HasNoContactFromBelow) {
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  SceneSpec square = scene(normal, 0.0);
  square.surface.extent = 0.05;
  const Eigen::Vector3d along = Reference::surface_with_normal(normal).rotation.col(0);
  square.surface.point -= 0.049 * along;
  const auto plant = started(model, square);
  const auto push = [&](const Eigen::Vector3d& force, int steps) {
    for (int i = 0; i < steps; ++i)
      ASSERT_EQ(plant->step(holding(*plant, force), Eigen::Vector3d::Zero()), Status::Ok);
  };
  push(-20.0 * normal, 20);
  EXPECT_TRUE(plant->in_contact());
  push(-20.0 * normal + 20.0 * along, 400);
  EXPECT_FALSE(plant->in_contact());
  push(-60.0 * normal, 200);
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  EXPECT_LT(body.placement(body.frame("tool")).translation().dot(normal),
            square.surface.point.dot(normal));
  push(-40.0 * along - 20.0 * normal, 400);
  EXPECT_FALSE(plant->in_contact());
  EXPECT_EQ(plant->contact_force_world(), Eigen::Vector3d::Zero());
}

TEST_P(PlantLaw, SoftSurface_StaysInContactWhenTheTipSinks) {
  // 60 N sink the tip by 12 cm, six of its radii. A surface with an extent must support it like an
  // endless one.
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  SceneSpec soft = scene(normal, 0.0);
  soft.surface.stiffness = 500.0;
  SceneSpec square = soft;
  square.surface.extent = 0.4;
  Model braked = model;
  braked.damping.setConstant(50.0);
  const auto endless = started(braked, soft), ending = started(braked, square);
  for (int i = 0; i < 4000; ++i)
    for (const auto* plant : {&endless, &ending})
      ASSERT_EQ((*plant)->step(holding(**plant, -60.0 * normal), Eigen::Vector3d::Zero()),
                Status::Ok);
  EXPECT_TRUE(ending->in_contact());
  EXPECT_GT(ending->contact_force_world().norm(), 30.0);
  EXPECT_EQ(ending->q(), endless->q());
}

TEST_P(PlantLaw, AtRest_GravityContactAndTorqueBalance) {
  // The robot's joints are damped strongly, so the surface's force balances the tool's force.
  Model braked = model;
  braked.damping.setConstant(200.0);
  const Eigen::Vector3d normal(0.0, 0.0, 1.0);
  const auto plant = started(braked, scene(normal, 0.0));
  Eigen::VectorXd tau;
  for (int i = 0; i < 4000; ++i) {
    tau = holding(*plant, -30.0 * normal) + 2.0 * plant->v();
    ASSERT_EQ(plant->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  }
  // M a = tau - gravity + friction + J^T force, with a and v almost zero.
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
  const Eigen::VectorXd rest =
      tau - body.gravity_torque() + plant->friction_torque() +
      motion.jacobian.topRows(3).transpose() * plant->contact_force_world();
  EXPECT_LE(rest.cwiseAbs().maxCoeff(), 0.1);
  EXPECT_GT(plant->contact_force_world().z(), 5.0);
}

TEST_P(PlantLaw, Push_EqualsItsJointTorques) {
  const Eigen::Vector3d push(3.0, -4.0, 5.0);
  const auto pushed = at_rest({0.0, 0.0, 1.0}, 0.5), driven = at_rest({0.0, 0.0, 1.0}, 0.5);
  const Eigen::VectorXd hold = holding(*pushed, Eigen::Vector3d::Zero());
  const Eigen::VectorXd torque = motion.jacobian.topRows(3).transpose() * push;
  ASSERT_EQ(pushed->step(hold, push), Status::Ok);
  ASSERT_EQ(driven->step(hold + torque, Eigen::Vector3d::Zero()), Status::Ok);
  EXPECT_LE((pushed->v() - driven->v()).norm(), 1e-12);
  EXPECT_GT(pushed->v().norm(), 1e-4);
}

TEST_P(PlantLaw, SeparatingTip_GetsNoForce) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.0, 0.3);
  for (int i = 0; i < 400; ++i) {
    const double force = i < 100 ? -30.0 : 30.0;
    ASSERT_EQ(plant->step(holding(*plant, {0.0, 0.0, force}), Eigen::Vector3d::Zero()), Status::Ok);
    EXPECT_GE(plant->contact_force_world().z(), 0.0);
    EXPECT_EQ(plant->in_contact(), plant->contact_force_world().z() > 0.0);
  }
  EXPECT_FALSE(plant->in_contact());
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  EXPECT_GT(gap(plant->scene(), body.placement(body.frame("tool")).translation()), 1e-3);
}

TEST_P(PlantLaw, SlidingTip_GetsCoulombFrictionAgainstItsMotion) {
  const double mu = 0.3;
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.0, mu);
  for (int i = 0; i < 300; ++i)
    ASSERT_EQ(plant->step(holding(*plant, {40.0, 0.0, -30.0}), Eigen::Vector3d::Zero()),
              Status::Ok);
  const Eigen::Vector3d force = plant->contact_force_world();
  const Eigen::Vector2d sliding = force.head<2>();
  EXPECT_NEAR(sliding.norm(), mu * force.z(), 0.02 * mu * force.z());
  ASSERT_EQ(body.update(plant->q(), plant->v()), Status::Ok);
  const Vector6 v = body.velocity(body.frame("tool"), Reference::centered());
  const Eigen::Vector3d arm(0.0, 0.0, -plant->scene().tip.radius);
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
  for (int i = 0; i < 200; ++i) ASSERT_EQ(blocked->step(none, Eigen::Vector3d::Zero()), Status::Ok);
  EXPECT_LE(blocked->v().cwiseAbs().maxCoeff(), GetParam().stiction);
  // Friction carries gravity.
  ASSERT_EQ(body.update(blocked->q(), blocked->v()), Status::Ok);
  EXPECT_LE((blocked->friction_torque() - body.gravity_torque()).norm(),
            0.02 * body.gravity_torque().norm());

  Model slowed = model;
  slowed.damping.setConstant(3.0);
  const auto plant = started(slowed, scene({0.0, 0.0, 1.0}, 0.5));
  for (int i = 0; i < 100; ++i) ASSERT_EQ(plant->step(none, Eigen::Vector3d::Zero()), Status::Ok);
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
  ASSERT_EQ(plant->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  ASSERT_EQ(loose->step(tau + pull, Eigen::Vector3d::Zero()), Status::Ok);
  const double moved = (loose->v() - v).norm();
  EXPECT_LE((plant->v() - loose->v()).norm(), 0.02 * moved);
  EXPECT_LE((plant->friction_torque() - loose->friction_torque() - pull).norm(),
            0.02 * pull.norm());
}

TEST_P(PlantLaw, RestoredSnapshot_GivesTheSameBits) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 1e-4, 0.3);
  const auto drive = [&](int steps) {
    for (int i = 0; i < steps; ++i)
      ASSERT_EQ(plant->step(holding(*plant, {10.0, 0.0, -30.0}), {0.0, 1.0, 0.0}), Status::Ok);
  };
  drive(150);
  PlantSnapshot snapshot;
  plant->save(snapshot);
  const Eigen::Vector3d force = plant->contact_force_world();
  drive(100);
  const Eigen::VectorXd q_then = plant->q(), v_then = plant->v();
  const Eigen::Vector3d force_then = plant->contact_force_world();
  EXPECT_NE(force, force_then);
  ASSERT_EQ(plant->restore(snapshot), Status::Ok);
  EXPECT_EQ(plant->contact_force_world(), force);
  EXPECT_NEAR(plant->time(), 150 * plant->dt(), 1e-12);
  drive(100);
  EXPECT_EQ(plant->q(), q_then);
  EXPECT_EQ(plant->v(), v_then);
  EXPECT_EQ(plant->contact_force_world(), force_then);

  snapshot.numbers.conservativeResize(snapshot.numbers.size() - 1);
  EXPECT_EQ(plant->restore(snapshot), Status::WrongSize);
  EXPECT_EQ(plant->q(), q_then);
}

TEST_P(PlantLaw, InvalidInput_ReturnsAStatusAndKeepsTheState) {
  const auto plant = at_rest({0.0, 0.0, 1.0}, 0.0);
  const Eigen::VectorXd v = Eigen::VectorXd::Zero(model.nv);
  Eigen::VectorXd bad = v;
  bad[2] = std::numeric_limits<double>::quiet_NaN();
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  EXPECT_EQ(plant->step(bad, none), Status::NotFinite);
  EXPECT_EQ(plant->step(v, {0.0, 0.0, std::numeric_limits<double>::infinity()}), Status::NotFinite);
  EXPECT_EQ(plant->step(v.head(3), none), Status::WrongSize);
  EXPECT_EQ(plant->reset(q, bad), Status::NotFinite);
  EXPECT_EQ(plant->reset(q.head(2), v), Status::WrongSize);
  EXPECT_EQ(plant->q(), q);
  EXPECT_EQ(plant->v(), v);
  EXPECT_EQ(plant->time(), 0.0);
}

TEST_P(PlantLaw, RobotWithoutATool_TouchesNothing) {
  // The surface is where the tool is.
  SceneSpec without = scene({0.0, 0.0, 1.0}, -0.01);
  const auto above = started(model, scene({0.0, 0.0, 1.0}, 0.5));
  without.tip.frame.clear();
  const auto plant = started(model, without);
  const Eigen::VectorXd tau = Eigen::VectorXd::LinSpaced(model.nv, -5.0, 5.0);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(plant->step(tau, {0.0, 0.0, 50.0}), Status::Ok);  // the push has nothing to act on
    ASSERT_EQ(above->step(tau, Eigen::Vector3d::Zero()), Status::Ok);
  }
  EXPECT_LT((plant->q() - above->q()).norm(), 1e-12);
  EXPECT_FALSE(plant->in_contact());
  EXPECT_EQ(plant->contact_force_world(), Eigen::Vector3d::Zero());
  PlantSnapshot snapshot;
  plant->save(snapshot);
  EXPECT_EQ(plant->restore(snapshot), Status::Ok);
  testing::expect_words(testing::refusal([&] {
                          scene_under_tip(model, q, {0.0, 0.0, 1.0}, without);
                        }),
                        {"no tip", "tip.frame"});
}

TEST_P(PlantLaw, InvalidScenes_AreRefused) {
  const auto refused = [&](auto&& change) {
    SceneSpec bad = scene({0.0, 0.0, 1.0}, 0.0);
    change(bad);
    return testing::refusal([&] { GetParam().make(model, bad); });
  };
  testing::expect_words(refused([](SceneSpec& s) { s.tip.frame = "tol"; }), {"'tol'", "tool"});
  const std::string root = has_robot_files ? "base_link" : "base";
  testing::expect_words(refused([&](SceneSpec& s) { s.tip.frame = root; }),
                        {root, "fixed to the world"});
  testing::expect_words(refused([](SceneSpec& s) { s.surface.normal.setZero(); }), {"normal"});
  testing::expect_words(refused([](SceneSpec& s) { s.surface.friction = -1.0; }),
                        {"friction", "-1"});
  testing::expect_words(refused([](SceneSpec& s) { s.tip.radius = 0.0; }),
                        {"radius", "more than 0"});
}

TEST_P(PlantLaw, Run_AllocatesNothing) {
  BURNISH_SKIP_WITHOUT_ALLOCATION_GUARD();
  Model with_friction = model;
  with_friction.friction.setConstant(0.5);
  with_friction.damping.setConstant(0.5);
  const auto plant = started(with_friction, scene({0.0, 0.0, 1.0}, 1e-4, 0.3));
  const Eigen::VectorXd tau = holding(*plant, {5.0, 0.0, -30.0});
  PlantSnapshot snapshot;
  plant->save(snapshot);
  Status status = Status::Ok;
  bool touched = false;
  const AllocationGuard guard;
  for (int i = 0; i < 200; ++i) {
    status = worst(status, plant->step(tau, {1.0, 0.0, 0.0}));
    touched = touched || plant->in_contact();
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
