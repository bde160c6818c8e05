// Tests of the ideal plant: order of integration, energy, impacts, and limits of contact and
// friction.
#include "burnish/sim/ideal_plant.hpp"

#include <gtest/gtest.h>

#include "burnish/derivatives/rigid_body.hpp"
#include "support/polishing_run.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

/// Returns the kinetic and potential energy of a plant [J].
double energy(RigidBody& body, const Plant& plant) {
  EXPECT_EQ(body.update(plant.q(), plant.v()), Status::Ok);
  return body.kinetic_energy() + body.potential_energy() + body.spring_energy();
}

struct Fall {
  double drift = 0.0;  ///< largest change of energy [J]
  double energy = 0.0;
};

/// Lets a robot fall freely with a random velocity, far from any surface.
Fall fall(const TestRobot& robot, double dt, double duration) {
  Model model = plant_model(robot.model(), {});
  for (Tendon& tendon : model.tendons) tendon.damping = 0.0;
  std::mt19937_64 generator(5);
  const Eigen::VectorXd q = random_configuration(model, generator);
  const Eigen::VectorXd v = random_vector(model.nv, 0.5, generator);
  IdealPlantOptions options;
  options.dt = dt;
  const auto plant = make_ideal_plant(model, out_of_reach(robot.tool, -1000.0), options);
  EXPECT_EQ(plant->reset(q, v), Status::Ok);
  RigidBody body(model);
  Fall result;
  result.energy = energy(body, *plant);
  const Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.nv);
  for (int i = 0; i < std::lround(duration / dt); ++i) {
    EXPECT_EQ(plant->step(tau), Status::Ok);
    result.drift = std::max(result.drift, std::abs(energy(body, *plant) - result.energy));
  }
  return result;
}

class IdealPlantFall : public ::testing::TestWithParam<TestRobot> {};

TEST_P(IdealPlantFall, EnergyError_FallsWithTheFourthOrderOfTheStep) {
  const double duration = 0.1;
  EXPECT_LE(fall(GetParam(), 5e-4, duration).drift, 1e-5);
  const double coarse = fall(GetParam(), 4e-3, duration).drift;
  const double fine = fall(GetParam(), 2e-3, duration).drift;
  EXPECT_GE(coarse / fine, 10.0) << coarse << " J and " << fine << " J";
}

INSTANTIATE_TEST_SUITE_P(robots, IdealPlantFall,
                         ::testing::ValuesIn(available({{"talos:right_arm", Base::Fixed, "tool"},
                                                        {"arm7", Base::Fixed, "tool"},
                                                        humanoid("tool"),
                                                        {"crane", Base::FreeFlyer, "left_tip"},
                                                        {"followers", Base::Fixed, "tip"},
                                                        {"every_joint", Base::FreeFlyer, "tip"}})),
                         [](const auto& test) { return test.param.label(); });

class IdealPlant : public ::testing::Test {
 protected:
  IdealPlant() : model(plant_model(right_arm(&q), {})) {}

  std::unique_ptr<Plant> on_surface(double friction, const IdealPlantOptions& options = {},
                                    double clearance = 0.0) const {
    const SceneSpec scene = plane_under_tip(model, q, normal, clearance, friction);
    return make_ideal_plant(model, scene, options);
  }
  Eigen::MatrixXd tool_jacobian(const Plant& plant) {
    EXPECT_EQ(body.update(plant.q(), plant.v()), Status::Ok);
    body.frame_derivatives(body.frame("tool"), Reference::centered(), motion);
    return motion.jacobian.topRows(3);
  }
  double gap_of(const Plant& plant) {
    EXPECT_EQ(body.update(plant.q(), plant.v()), Status::Ok);
    return gap(plant.scene().tool(), body.placement(body.frame("tool")).translation());
  }
  /// Returns a velocity along the surface, without the component that moves the tip along the
  /// normal.
  Eigen::VectorXd along_surface(const Plant& plant) {
    const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(model.nv, -0.5, 0.5);
    const Eigen::VectorXd n = tool_jacobian(plant).transpose() * normal;
    return v - n * n.dot(v) / n.squaredNorm();
  }

  Eigen::Vector3d normal{-0.6, 0.0, 0.8};
  Eigen::VectorXd q;
  Model model;
  RigidBody body{model};
  FrameDerivatives motion;
};

TEST_F(IdealPlant, SlidingTip_StaysOnTheSurfaceAndDoesNoWork) {
  const auto plant = on_surface(0.0);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  ASSERT_EQ(plant->reset(q, along_surface(*plant)), Status::Ok);
  const double before = energy(body, *plant);
  double work = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::VectorXd q_before = plant->q();
    const Eigen::VectorXd press = -200.0 * tool_jacobian(*plant).transpose() * normal;
    ASSERT_EQ(plant->step(press), Status::Ok);
    ASSERT_TRUE(is_touching(*plant)) << "step " << i;
    ASSERT_LE(std::abs(gap_of(*plant)), 1e-7);
    work += press.dot(plant->q() - q_before);
  }
  EXPECT_GT(body.kinetic_energy(), 1.0);
  EXPECT_NEAR(energy(body, *plant) - before, work, 1e-5) << "the contact does no work";
}

TEST_F(IdealPlant, Impact_LeavesNoNormalVelocity) {
  const auto plant = on_surface(0.0, {}, 1.3e-3);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const Eigen::VectorXd n = tool_jacobian(*plant).transpose() * normal;
  const Eigen::VectorXd v = -0.1 * n / n.squaredNorm();  // 0.1 m/s towards the surface
  ASSERT_EQ(plant->reset(q, v), Status::Ok);
  double impulse = 0.0, before = 0.0;
  for (int i = 0; i < 100 && !is_touching(*plant); ++i) {
    before = energy(body, *plant);
    const Eigen::VectorXd q_before = plant->q();
    ASSERT_EQ(plant->step(body.gravity_torque()), Status::Ok);
    impulse = force_world(*plant, q_before).dot(normal) * plant->dt();
  }
  ASSERT_TRUE(is_touching(*plant));
  EXPECT_GT(impulse, 0.01);
  EXPECT_LE(std::abs(gap_of(*plant)), 1e-7);
  EXPECT_LE(std::abs(normal.dot(tool_jacobian(*plant) * plant->v())), 1e-6);
  EXPECT_LT(energy(body, *plant), before);
}

TEST_F(IdealPlant, CoulombFriction_HoldsTheTip) {
  const auto plant = on_surface(0.5);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  const Eigen::Vector3d tangent = Eigen::Vector3d::UnitY();
  // The other joints rest because gravity is balanced and the contact point does not slide.
  for (int i = 0; i < 200; ++i) {
    const Eigen::MatrixXd J = tool_jacobian(*plant);
    const Eigen::VectorXd tau =
        body.gravity_torque() + J.transpose() * (5.0 * tangent - 30 * normal) - 20.0 * plant->v();
    const Eigen::VectorXd q_before = plant->q();
    ASSERT_EQ(plant->step(tau), Status::Ok);
    const Eigen::Vector3d force = force_world(*plant, q_before);
    const double pressed = force.dot(normal);
    EXPECT_LE((force - pressed * normal).norm(), 0.5 * pressed * (1.0 + 1e-2) + 1e-9);
  }
  const Vector6 v = body.velocity(body.frame("tool"), Reference::centered());
  const Eigen::Vector3d slip = v.head<3>() - 0.02 * v.tail<3>().cross(normal);
  EXPECT_LE(slip.norm(), 1e-4);
}

TEST_F(IdealPlant, ViscousSurface_GivesAForceProportionalToTheSpeed) {
  IdealPlantOptions options;
  options.tip_viscous = 40.0;
  const auto plant = on_surface(0.0, options);
  ASSERT_EQ(plant->reset(q, Eigen::VectorXd::Zero(model.nv)), Status::Ok);
  Eigen::VectorXd q_before;
  for (int i = 0; i < 200; ++i) {
    const Eigen::MatrixXd J = tool_jacobian(*plant);
    const Eigen::VectorXd tau =
        body.gravity_torque() + J.transpose() * (Eigen::Vector3d(0.0, 5.0, 0.0) - 30.0 * normal);
    q_before = plant->q();
    ASSERT_EQ(plant->step(tau), Status::Ok);
  }
  const Vector6 v = body.velocity(body.frame("tool"), Reference::centered());
  const Eigen::Vector3d slip = v.head<3>() - 0.02 * v.tail<3>().cross(normal);
  const Eigen::Vector3d force = force_world(*plant, q_before);
  const Eigen::Vector3d sliding = force - force.dot(normal) * normal;
  EXPECT_GT(sliding.norm(), 0.1);
  EXPECT_LE((sliding + 40.0 * slip).norm(), 0.05 * sliding.norm());
}

TEST(IdealPlantModel, SingularMassMatrix_IsRefusedWithItsJoint) {
  TreeSpec tree;
  tree.name = "bare";
  tree.links.resize(2);
  tree.links[0].name = "base";
  tree.links[1].name = "tip";
  JointSpec hinge;
  hinge.name = "hinge";
  hinge.type = JointType::Revolute;
  hinge.parent_link = "base";
  hinge.child_link = "tip";
  tree.joints = {hinge};
  const SceneSpec scene{.touches = {round_tip("tip")}};
  testing::expect_words(testing::refusal([&] { make_ideal_plant(build_model(tree), scene); }),
                        {"robot 'bare'", "joint 'hinge' moves no mass"});
}

TEST_F(IdealPlant, InvalidOptions_AreRefused) {
  IdealPlantOptions options;
  options.dt = 0.0;
  testing::expect_words(testing::refusal([&] { on_surface(0.0, options); }), {"dt", "more than 0"});
  options = {};
  options.tip_viscous = -1.0;
  testing::expect_words(testing::refusal([&] { on_surface(0.0, options); }), {"tip_viscous", "-1"});
}

}  // namespace
}  // namespace burnish::test
