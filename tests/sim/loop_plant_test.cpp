// Tests of robots with kinematic loops as plants, and in closed loop with a planning controller.
#include <gtest/gtest.h>

#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/ideal_plant.hpp"
#ifdef BURNISH_HAS_MUJOCO
#include "burnish/mujoco/mujoco_plant.hpp"
#endif
#include "support/plant_touch.hpp"
#include "support/refusal.hpp"
#include "support/robots.hpp"

namespace burnish::test {
namespace {

using Eigen::VectorXd;

struct LoopPlantKind {
  std::string name;
  std::unique_ptr<Plant> (*make)(const Model&, const SceneSpec&);
  double drift;  ///< largest closure error of loops [m]
};
void PrintTo(const LoopPlantKind& kind, std::ostream* out) { *out << kind.name; }

std::vector<LoopPlantKind> loop_plants() {
  std::vector<LoopPlantKind> result{
      {"ideal", [](const Model& m, const SceneSpec& s) { return make_ideal_plant(m, s); }, 1e-6}};
#ifdef BURNISH_HAS_MUJOCO
  result.push_back({"mujoco",
                    [](const Model& m, const SceneSpec& s) {
                      return make_mujoco_plant(m, s, {.joint_stops = false});
                    },
                    1e-4});
#endif
  return result;
}

Robot loop_robot(const std::string& name) {
  return load_robot(std::string(BURNISH_ROBOTS_DIR) + "/" + name);
}

double max_miss(const Model& model, const VectorXd& q) {
  double worst = 0.0;
  for (const LoopMiss& miss : loop_misses(model, q))
    worst = std::max({worst, miss.translation, miss.rotation});
  return worst;
}

class LoopPlant : public ::testing::TestWithParam<LoopPlantKind> {};

TEST_P(LoopPlant, Step_MatchesTheModelsAcceleration) {
  for (const char* name : {"four_bar", "parallel_ankle", "gripper"}) {
    const Robot robot = loop_robot(name);
    const Model model = plant_model(robot.model, {});
    const auto plant = GetParam().make(model, out_of_reach());
    ContactDynamics dynamics(model, loop_contacts(model));
    const VectorXd q = robot.reference_configuration();
    std::mt19937_64 generator(5);
    const VectorXd v =
        project_velocity_onto_loops(model, q, random_vector(model.nv, 0.3, generator));
    const VectorXd tau = random_vector(model.nv, 0.5, generator);
    ASSERT_EQ(plant->reset(q, v), Status::Ok);
    ASSERT_EQ(plant->step(tau), Status::Ok);
    ASSERT_EQ(dynamics.forward(q, v, tau), Status::Ok);
    const VectorXd a = (plant->v() - v) / plant->dt();
    EXPECT_LE((a - dynamics.a()).norm(), 0.03 * dynamics.a().norm()) << name;
  }
}

TEST_P(LoopPlant, SwingingMotion_KeepsLoopsClosed) {
  for (const char* name : {"four_bar", "parallel_ankle", "gripper"}) {
    const Robot robot = loop_robot(name);
    const Model model = plant_model(robot.model, {});
    const auto plant = GetParam().make(model, out_of_reach());
    const VectorXd q = robot.reference_configuration(), rest = VectorXd::Zero(model.nv);
    ASSERT_EQ(plant->reset(q, rest), Status::Ok);
    double worst = 0.0;
    while (plant->time() < 2.0) {
      // The motors brake: without brakes, a leg falls through its singularities.
      const VectorXd tau = -(model.effort_limit.array() > 0.0).select(0.5 * plant->v(), 0.0);
      ASSERT_LE(plant->step(tau), Status::NotConverged) << name;
      worst = std::max(worst, max_miss(model, plant->q()));
    }
    EXPECT_LT(worst, GetParam().drift) << name;
    EXPECT_GT((plant->q() - q).norm(), 0.1) << name << ": the robot must move";
  }
}

TEST_P(LoopPlant, SurfaceContact_KeepsLoopsClosed) {
  const Robot robot = loop_robot("parallel_ankle");
  const Model model = plant_model(robot.model, {});
  SceneSpec scene = out_of_reach();
  const VectorXd q = robot.reference_configuration();
  scene.tool().radius = 0.01;
  scene.tool().surface.point.z() = frame_placement(model, q, "tool").translation().z() - 0.012;
  const auto plant = GetParam().make(model, scene);
  ASSERT_EQ(plant->reset(q, VectorXd::Zero(model.nv)), Status::Ok);
  bool touched = false;
  double worst = 0.0;
  for (int i = 0; i < 400; ++i) {
    const VectorXd tau = -(model.effort_limit.array() > 0.0).select(2.0 * plant->v(), 0.0);
    ASSERT_LE(plant->step(tau), Status::NotConverged);
    touched = touched || is_touching(*plant);
    worst = std::max(worst, max_miss(model, plant->q()));
  }
  EXPECT_TRUE(touched);
  EXPECT_LT(worst, 2.0 * GetParam().drift);
}

/// Controller that moves the crank to the posture `to`, with plans 0.3 s long.
MpcSpec tracking(const Robot& robot, const VectorXd& q, double to) {
  MpcSpec spec;
  spec.problem.model = robot.model;
  const Model& model = robot.model;
  spec.problem.initial_state = VectorXd::Zero(model.nq + model.nv);
  spec.problem.initial_state.head(model.nq) = q;
  VectorXd target = spec.problem.initial_state;
  target.head(model.nq) = closed_configuration(model, {{"drive", {to}}});
  VectorXd weights = VectorXd::Ones(2 * model.nv);
  weights.tail(model.nv).setConstant(0.003);
  const CostTerm there{.residual = residual::State{target}, .weight = 10.0, .weights = weights};
  spec.problem.stages = {{.name = "track",
                          .costs = {there, {.residual = residual::Control{}, .weight = 1e-3}},
                          .step = 0.01}};
  spec.problem.horizon = {{"track", 30}};
  spec.problem.terminal = {there};
  spec.schedule = {{.name = "track", .stage = "track"}};
  spec.tick_period = 1e-3;
  spec.update_period = 0.01;
  return spec;
}

TEST_P(LoopPlant, MpcWithLoops_ReachesItsTarget) {
  const Robot robot = loop_robot("four_bar");
  const Model& model = robot.model;
  const VectorXd q = closed_configuration(model, {{"drive", {0.8}}});
  const double goal = 1.4;
  MpcController controller(tracking(robot, q, goal));
  const Model nominal = plant_model(model, {});
  const auto plant = GetParam().make(nominal, out_of_reach());
  ClosedLoop loop(*plant, controller, {}, {.control_period = 1e-3, .max_duration = 2.5});
  ASSERT_EQ(loop.reset(q, VectorXd::Zero(model.nv)), Status::Ok);
  double worst = 0.0;
  while (plant->time() < 2.0) {
    ASSERT_LE(loop.step(), Status::NotConverged);
    worst = std::max(worst, max_miss(model, plant->q()));
  }
  EXPECT_EQ(controller.fault().kind, FaultKind::None) << controller.fault().text();
  const int drive = model.joint_index("drive");
  EXPECT_NEAR(plant->q()[model.joints[drive].q_index], goal, 0.02);
  EXPECT_LT(plant->v().norm(), 0.05);
  EXPECT_LT(worst, GetParam().drift);
  // The model is exact: the observer must not take the loop's forces for model errors.
  EXPECT_LT(controller.torque_error().cwiseAbs().maxCoeff(), 0.02);
  for (int k = 0; k < model.nv; ++k) {
    if (k == model.joints[drive].v_index) continue;
    EXPECT_EQ(loop.command().tau[k], 0.0) << "passive joints must get no torque";
  }
}

TEST_P(LoopPlant, Fallback_HoldsTheRobot) {
  const Robot robot = loop_robot("four_bar");
  const Model& model = robot.model;
  const VectorXd q = closed_configuration(model, {{"drive", {0.8}}});
  MpcSpec spec = tracking(robot, q, 1.4);
  spec.limits.joint_speed_ratio = 1e-3;  // the first motion is a fault
  MpcController controller(spec);
  const auto plant = GetParam().make(plant_model(model, {}), out_of_reach());
  ClosedLoop loop(*plant, controller, {}, {.control_period = 1e-3, .max_duration = 2.5});
  ASSERT_EQ(loop.reset(q, VectorXd::Zero(model.nv)), Status::Ok);
  ASSERT_LE(loop.run(1.5), Status::NotConverged);
  EXPECT_NE(controller.fault().kind, FaultKind::None);
  EXPECT_LT(plant->v().norm(), 1e-2);
  EXPECT_LT((plant->q() - q).cwiseAbs().maxCoeff(), 0.05) << "the robot must not fall";
}

INSTANTIATE_TEST_SUITE_P(plants, LoopPlant, ::testing::ValuesIn(loop_plants()),
                         [](const auto& test) { return test.param.name; });

#ifdef BURNISH_HAS_MUJOCO
TEST(MujocoLoops, UnsupportedDirections_AreRefusedByName) {
  Model model = loop_robot("four_bar").model;
  model.loops[0].directions = Directions::parse("x,z");
  testing::expect_words(testing::refusal([&] { make_mujoco_plant(model, out_of_reach()); }),
                        {"MuJoCo", "loop 'pin' holds x,z", "x,y,z"});
}
#endif

}  // namespace
}  // namespace burnish::test
