// Public robots: the shipped list, descriptions in a folder, and the experiment on them.
#include "polishing/experiments/public_robots.hpp"

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/experiments/found_posture.hpp"
#include "polishing/experiments/public_arms.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"
#include "tasks/quick_experiment.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

TEST(PublicRobots, ShippedList_NamesEverySource) {
  std::map<std::string, int> kinds;
  std::set<std::string> names;
  for (const PublicRobot& robot : shipped_public_robots()) {
    EXPECT_TRUE(names.insert(robot.name).second) << robot.name;
    EXPECT_EQ(robot.commit.size(), 40U) << robot.name;
    EXPECT_NE(robot.stands(), !robot.tool.empty()) << robot.name;
    EXPECT_EQ(robot.url(), "https://github.com/" + robot.repository + "/blob/" + robot.commit +
                               "/" + robot.file);
    ++kinds[robot.stands() ? "legged" : "arm"];
  }
  EXPECT_GE(kinds["arm"], 25);
  EXPECT_GE(kinds["legged"], 12);
}

/// With BURNISH_WRITE=1 in the environment, the test rewrites the table in the docs.
TEST(PublicRobots, DocsTable_MatchesTheList) {
  const std::string file = BURNISH_DOCS_DIR "/public_robots.md", begin = "<!-- robots -->\n",
                    end = "<!-- end of robots -->";
  std::string text = contents(file);
  const std::size_t from = text.find(begin), to = text.find(end);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos && from < to) << file;
  const std::size_t first = from + begin.size();
  const std::string wanted = markdown(public_robots_table(shipped_public_robots()));
  if (std::getenv("BURNISH_WRITE") != nullptr)
    std::ofstream(file) << text.replace(first, to - first, wanted);
  EXPECT_EQ(text.substr(first, text.find(end) - first), wanted)
      << "BURNISH_WRITE=1 tasks_test --gtest_filter='PublicRobots*' updates the table";
}

TEST(PublicRobots, Descriptions_AreFoundInAnyLayout) {
  const Scratch scratch;
  const PublicRobot robot{.name = "r", .repository = "who/what", .file = "a/b.urdf"};
  EXPECT_FALSE(find_description(scratch.folder, robot));
  for (const char* place : {"what", "who/what", "who+what"}) {
    const fs::path file = scratch.write(std::string(place) + "/a/b.urdf", "");
    EXPECT_EQ(find_description(scratch.folder, robot), file);
  }
  const PublicRobot own{.name = "o", .file = "o.urdf"};
  const fs::path file = scratch.write("o.urdf", "");
  EXPECT_EQ(find_description(scratch.folder, own), file);
  EXPECT_EQ(own.url(), "o.urdf");
}

TEST(PublicRobots, InvalidLists_AreRefused) {
  const auto refused = [](const std::string& text) {
    return refusal([&] { parse_public_robots(text, "list.yaml"); });
  };
  expect_words(refused("arms: {a: {file: a.urdf}}"), {"list.yaml: line 1", "tool"});
  expect_words(refused("arms: {a: {file: a.urdf, tool: t, feet: [f]}}"), {"arms.a", "feet"});
  expect_words(refused("arms: {a: {repository: who/what, file: a.urdf, tool: t}}"),
               {"arms.a.repository", "'who/what' has no commit under the key 'repositories'"});
  expect_words(refused("arms: {a: {file: a.urdf, tool: t, set: [force=3]}}"),
               {"only one of the keys 'set' and 'because' is given"});
  expect_words(refused("legged: {a: {file: a.urdf, feet: [f], task: stand}}"),
               {"legged.a.task", "quadruped"});
  expect_words(refused("repositories: {who/what: 1}"), {"under the keys 'arms' and 'legged'"});
  const Scratch scratch;
  expect_words(refusal([&] { public_robots_in(scratch.folder / "none"); }),
               {"none' does not exist; wanted a folder of robot descriptions"});
  scratch.write("robots.yaml", "arms: {a: {file: a.urdf, tool: t}}");
  expect_words(refusal([&] { public_robots_in(scratch.folder); }),
               {"has none of the 1 descriptions", "'a.urdf'"});
}

TEST(PublicArms, WeakMotors_PressWithTheLargestPossibleForce) {
  ArmBench bench;
  put_on(bench.task, "table");
  bench.task.robot = "arm7";
  bench.task.posture = "ready";
  bench.task.force = 200.0;  // takes more torque than the weight of the arm
  bench.robot = load_robot("arm7");
  bench.search();
  EXPECT_EQ(bench.force, 200.0);
  EXPECT_EQ(bench.reason, "");
  // Motors slightly too weak for that force.
  const ReachReport reach = check_reach(bench.task, make_setting(bench.task, bench.robot));
  bench.robot.model.effort_limit *= 0.9 * reach.torque_share / ReachOptions().torque_share;
  bench.search();
  EXPECT_EQ(bench.reason, "");
  EXPECT_LT(bench.force, 200.0);
  EXPECT_GE(bench.force, 100.0);
  Task more = bench.task;
  more.force = bench.force + 1.0;
  EXPECT_EQ(check_reach(more, make_setting(more, bench.robot)).problem, ReachProblem::Torque);
  bench.robot.model.effort_limit *= 0.01;
  bench.search();
  expect_words(bench.reason, {"out of reach", "Nm"});
}

TEST(PublicArms, ErrorsBeyondTheTolerance_AreListed) {
  ArmBench bench;
  bench.arm.name = "a";
  bench.surface = "table";
  std::vector<RunFigures> figures;
  std::vector<ArmTrial> trials;
  const auto add = [&](const char* preset, ControllerKind controller, double force, double path) {
    ArmTrial trial{.bench = &bench, .preset = preset, .controller = controller};
    for (const double times : {0.5, 1.0, 3.0}) {  // the table shows the median
      trial.runs.push_back(figures.size());
      RunFigures run{.made = true, .succeeded = true, .metrics = Metrics{}};
      run.metrics->force_rmse = times * force;
      run.metrics->position_rmse = times * path;
      figures.push_back(run);
    }
    trials.push_back(trial);
  };
  add("mismatch", ControllerKind::Mpc, 0.109, 14.9e-6);
  add("mismatch", ControllerKind::Baseline, 0.1, 10e-6);
  add("joint_friction", ControllerKind::Mpc, 0.13, 20e-6);
  add("joint_friction", ControllerKind::Baseline, 0.1, 10e-6);
  PublicReport common;
  const ResultTable table = arms_table(trials, figures, common);
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(table.rows[0].back()),
            "joint_friction: force +0.030 N and path +0.010 mm");
  EXPECT_NEAR(number_at(table, 0, "mismatch: mpc"), 0.109, 1e-12);
  EXPECT_NEAR(number_at(table, 0, "worst"), 0.327, 1e-12);
  figures[1].made = false;  // runs that were not made are left out
  PublicReport none;
  EXPECT_TRUE(arms_table(trials, figures, none).rows.empty());
  figures[1].made = true;
  figures[0].succeeded = false;  // a run that does not polish counts as the worst
  EXPECT_EQ(std::get<std::string>(arms_table(trials, figures, common).rows[0].back()),
            "mismatch: polishes 2, baseline 3; joint_friction: force +0.030 N and path +0.010 mm");
  ExperimentReport report;
  common.write(report);
  const ResultTable& aims = table_named(report, "aims");
  ASSERT_EQ(aims.rows.size(), 6U);
  EXPECT_EQ(number_at(aims, 0, "met"), 1.0) << "all runs polish";
  EXPECT_EQ(number_at(aims, 1, "met"), 0.0) << "the worst force error is 0.327 N";
  EXPECT_EQ(number_at(aims, 3, "met"), 0.0);
}

TEST(FoundPosture, ContinuousJoint_KeepsItsAngle) {
  Robot crane = load_robot("crane");
  Eigen::VectorXd q = crane.reference_configuration();
  const Joint& wrist = crane.model.joints.back();
  ASSERT_EQ(wrist.kind, JointKind::Continuous);
  q.segment<2>(wrist.q_index) = Eigen::Vector2d(std::cos(2.5), std::sin(2.5));
  Task task;
  start_from(q, crane, task);
  EXPECT_LT((crane.posture(task.posture) - q).norm(), 1e-12);
}

/// Writes checkouts: an arm, a pendulum that reaches nothing, and a robot with legs.
void write_checkouts(const Scratch& scratch) {
  const fs::path robots = BURNISH_ROBOTS_DIR;
  scratch.write("who+arms/arm7.urdf", contents(robots / "arm7/arm7.urdf"));
  scratch.write("who/arms/pendulum.urdf", contents(robots / "pendulum/pendulum.urdf"));
  for (const char* file : {"quadruped.urdf", "robot.yaml"})
    scratch.write(std::string("legs/dog/") + file, contents(robots / "quadruped" / file));
  scratch.write("robots.yaml",
                "repositories: {who/arms: abc, who/legs: def}\n"
                "arms:\n"
                "  Seven: {repository: who/arms, file: arm7.urdf, tool: flange}\n"
                "  Rod: {repository: who/arms, file: pendulum.urdf, tool: rod}\n"
                "  Lost: {repository: who/legs, file: lost.urdf, tool: flange}\n"
                "legged:\n"
                "  Dog: {repository: who/legs, file: dog/robot.yaml, task: quadruped,\n"
                "        feet: [fl_foot, fr_foot, rl_foot, rr_foot]}\n");
}

TEST(Experiments, PublicRobotsInAFolder_AreRun) {
  if (!has_mujoco()) GTEST_SKIP() << "needs MuJoCo";
  const Scratch scratch;
  write_checkouts(scratch);
  ExperimentSpec spec = quick();
  spec.folder = scratch.folder.string();
  spec.overrides = {"limits.joint_speed_ratio=2"};  // short, fast runs
  const ExperimentReport report = experiment_named("robots").perform(spec);
  ASSERT_EQ(report.failures.size(), 1U) << report.failures.back();
  expect_words(report.failures[0], {"Rod, table: "});
  expect_words(report.findings[0], {"3 of 4 descriptions are in the folder"});
  expect_words(report.findings[1],
               {"Missing: Lost, https://github.com/who/legs/blob/def/lost.urdf"});
  EXPECT_EQ(report.tables.front().name, "runs");
  EXPECT_EQ(report.tables.front().rows.size(), 13U);
  const ResultTable& arms = table_named(report, "arms");
  ASSERT_EQ(arms.rows.size(), 1U);
  EXPECT_EQ(std::get<std::string>(arms.rows[0][0]), "Seven");
  EXPECT_EQ(number_at(arms, 0, "force"), 30.0);
  EXPECT_GT(number_at(arms, 0, "mismatch: mpc"), 0.0);
  const ResultTable& delays = table_named(report, "delays");
  ASSERT_EQ(delays.rows.size(), 1U);
  EXPECT_GT(number_at(delays, 0, "predicted"), 1.0);
  const ResultTable& legs = table_named(report, "legs");
  ASSERT_EQ(legs.rows.size(), 1U);
  EXPECT_EQ(number_at(legs, 0, "stood"), 1.0);
  EXPECT_GT(number_at(legs, 0, "com_moved, worst"), 5.0);
  EXPECT_EQ(table_named(report, "others").rows.size(), 1U);
  EXPECT_EQ(table_named(report, "aims").rows.size(), 6U);
}

}  // namespace
}  // namespace burnish::testing
