// Runs that begin away from the start of their task: the move to the start, its limits, refusals.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/model/state.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "support/refusal.hpp"

namespace burnish::testing {
namespace {

using namespace burnish::polishing;

Task task_from(const std::string& robot, const std::string& posture) {
  Task task;
  task.robot = robot;
  put_on(task, "table");
  if (robot == "arm7") task.posture = "ready";
  task.polish_duration = 1.5;
  task.path.start_up = 1.0;
  task.home.posture = posture;
  return task;
}

struct HomeCase {
  std::string robot, posture;
};

class HomeMoves : public ::testing::TestWithParam<HomeCase> {
 protected:
  Task task = task_from(GetParam().robot, GetParam().posture);
  Setting setting = make_setting(task);
};

INSTANTIATE_TEST_SUITE_P(Arms, HomeMoves,
                         ::testing::Values(HomeCase{"arm7", "bent"},
                                           HomeCase{"talos:right_arm", "board_y"}));

TEST_P(HomeMoves, SearchedMove_KeepsSpeedAndTorqueLimits) {
  ASSERT_TRUE(setting.home.has_value());
  const HomeMove& move = *setting.home;
  const Model& model = setting.robot.model;
  EXPECT_EQ(move.corners.front(), setting.robot.posture(GetParam().posture));
  EXPECT_EQ(move.corners.back(), setting.q_start);
  EXPECT_GE(move.duration(), 1.0);
  EXPECT_LT(move.duration(), 15.0);
  ContactDynamics dynamics(model);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.nv);
  double max_speed_ratio = 0.0;
  for (std::size_t leg = 0; leg < move.durations.size(); ++leg) {
    const Eigen::VectorXd displacement =
        difference(model, move.corners[leg], move.corners[leg + 1]);
    const double T = move.durations[leg];
    for (double x = 0.0; x <= 1.0; x += 0.01) {
      const double s = x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
      const double ds = 30.0 * x * x * (1.0 - x) * (1.0 - x) / T;
      const double ds2 = 60.0 * x * (1.0 - x) * (1.0 - 2.0 * x) / (T * T);
      ASSERT_EQ(dynamics.forward(integrate(model, move.corners[leg], s * displacement),
                                 ds * displacement, zero),
                Status::Ok);
      const Eigen::VectorXd tau = dynamics.mass_matrix() * (ds2 * displacement) + dynamics.bias();
      for (int k = 0; k < model.nv; ++k) {
        max_speed_ratio =
            std::max(max_speed_ratio, std::abs(ds * displacement[k]) / model.velocity_limit[k]);
        EXPECT_LT(std::abs(tau[k]), 0.81 * model.effort_limit[k]) << model.v_name(k);
      }
    }
  }
  EXPECT_LT(max_speed_ratio, 0.301);
}

TEST_P(HomeMoves, RunFromHome_PolishesLikeARunFromTheStart) {
  RunSpec spec{.task = task, .plant = PlantKind::Ideal, .plan_rate = 0.0};
  spec.task.update_rate = 200.0;
  const RunResult from_home = run_task(spec);
  spec.task.home = {};
  const RunResult from_start = run_task(spec);
  ASSERT_TRUE(from_home.succeeded) << from_home.outcome;
  ASSERT_TRUE(from_start.succeeded) << from_start.outcome;
  EXPECT_NEAR(from_home.metrics->force_rmse, from_start.metrics->force_rmse, 0.03);
  EXPECT_NEAR(from_home.metrics->position_rmse, from_start.metrics->position_rmse, 5e-5);
  EXPECT_NEAR(*from_home.metrics->tool_to_normal, *from_start.metrics->tool_to_normal, 2e-3);

  const Trace& trace = from_home.trace;
  const Model& model = setting.robot.model;
  const auto phase = trace.column("phase"), time = trace.column("time");
  EXPECT_EQ(name_of(static_cast<Phase>(phase[0])), "home");
  EXPECT_EQ(from_start.trace.column("phase")[0], number_of(Phase::Reach));
  int reach = 0;
  while (phase[reach] == number_of(Phase::Home)) ++reach;
  EXPECT_EQ(phase[reach], number_of(Phase::Reach));
  EXPECT_NEAR(time[reach], setting.home->duration() + setting.home->settle, 1e-3);
  for (int k = 0; k < model.nq; ++k) {
    const auto q = trace.column("q_" + model.q_name(k));
    EXPECT_NEAR(q[0], setting.home->corners.front()[k], 1e-12);
    EXPECT_NEAR(q[reach], setting.q_start[k], 1e-3) << model.q_name(k);
    EXPECT_GE(q.minCoeff(), model.q_lower[k]);
    EXPECT_LE(q.maxCoeff(), model.q_upper[k]);
  }
  for (int k = 0; k < model.nv; ++k)
    EXPECT_LT(trace.column("v_" + model.v_name(k)).head(reach).cwiseAbs().maxCoeff(),
              0.31 * model.velocity_limit[k]);
}

TEST(Home, ControllersWithoutPlans_MoveToTheStart) {
  RunSpec spec{.task = task_from("arm7", "home"), .plant = PlantKind::Ideal};
  for (const ControllerKind kind : {ControllerKind::Baseline, ControllerKind::Admittance}) {
    spec.controller = kind;
    const RunResult result = run_task(spec);
    EXPECT_TRUE(result.succeeded) << name_of(kind) << ": " << result.outcome;
    EXPECT_EQ(result.trace.column("phase")[0], number_of(Phase::Home));
  }
}

TEST(Home, StatedDuration_IsKept) {
  Task task = task_from("arm7", "home");
  task.home.duration = 5.0;
  EXPECT_NEAR(make_setting(task).home->duration(), 5.0, 1e-12);
  task.home.duration = 0.1;
  expect_words(refusal([&] { make_setting(task); }), {"home.duration", "0.1 s", "joint_", "auto"});
}

TEST(Home, StraightPathThroughTheSurface_GoesOverALiftedStart) {
  Task task = task_from("arm7", "ready");
  task.home.joints = {
      {"joint_3", -0.67}, {"joint_4", -2.35}, {"joint_5", -0.28}, {"joint_7", -0.08}};
  const Setting setting = make_setting(task);
  ASSERT_EQ(setting.home->corners.size(), 3U);
  const double lift =
      (frame_placement(setting.robot.model, setting.home->corners[1], "tool").translation() -
       frame_placement(setting.robot.model, setting.q_start, "tool").translation())
          .dot(setting.scene.tool().surface.normal);
  EXPECT_GE(lift, 0.049);
  EXPECT_TRUE(check_home(task, setting).ok()) << check_home(task, setting).text;
}

TEST(Home, HomeInsideTheSurface_IsRefusedWithARemedy) {
  Task task = task_from("arm7", "");
  Setting setting = make_setting(task);
  task.home.joints = {{"joint_2", 0.9}};
  setting = make_setting(task, setting.robot, setting.q_start);
  const ReachReport report = check_home(task, setting);
  EXPECT_EQ(report.problem, ReachProblem::Collision);
  expect_words(report.text, {"at home", "m inside the surface", "from the posture '",
                             "' is free of collisions"});
  RunSpec spec{.task = task, .robot = setting.robot, .plant = PlantKind::Ideal};
  expect_words(refusal([&] { run_task(spec); }), {"at home", "inside the surface", "another home"});
}

TEST(Home, HomeOfAnotherRobot_IsRefused) {
  Task task = task_from("arm7", "hom");
  expect_words(refusal([&] { make_setting(task); }), {"home", "'hom'", "'home'"});
  task.home = {.joints = {{"joint_9", 0.0}}};
  expect_words(refusal([&] { make_setting(task); }), {"home.joints", "'joint_9'"});
  task.home = {.joints = {{"joint_4", 1.0}}};
  expect_words(refusal([&] { make_setting(task); }), {"home", "'joint_4'", "-2.4", "0.6"});
}

TEST(Home, FreeHomes_ListPosturesWithACollisionFreePath) {
  const Task task = task_from("arm7", "");
  const std::vector<FreeHome> homes = free_homes(task, make_setting(task));
  ASSERT_FALSE(homes.empty());
  for (const FreeHome& home : homes) {
    Task from = task;
    from.home.posture = home.posture;
    EXPECT_NEAR(make_setting(from).home->duration(), home.duration, 1e-9) << home.posture;
  }
}

TEST(Home, TaskFile_AcceptsAWordOrKeys) {
  const Task word = parse_task("home: ready", "text");
  EXPECT_EQ(word.home.posture, "ready");
  const Task keys = parse_task("home: {joints: {a: 0.5}, duration: 3, speed_ratio: 0.1}", "text");
  EXPECT_EQ(keys.home.joints.at("a"), 0.5);
  EXPECT_EQ(keys.home.duration, 3.0);
  EXPECT_EQ(task_text(parse_task(task_text(keys), "text")), task_text(keys));
  EXPECT_FALSE(parse_task("home: none", "text").home.is_stated());
}

}  // namespace
}  // namespace burnish::testing
