// Tests of the command burnish run: files, exit codes, bad input.
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

const std::string shipped = contents(std::filesystem::path(BURNISH_ROBOTS_DIR) / ".." / "tasks" /
                                     "press_hold" / "arm7.yaml");

Outcome run_task_text(const Scratch& scratch, const std::string& text, const std::string& more) {
  const auto file = scratch.folder / "my_task.yaml";
  std::ofstream(file) << text;
  return run("run " + quoted(file) + " --plant ideal --out " + quoted(scratch.folder / "out") +
             more);
}

TEST(RunCommand, PressHold_WritesMetricsTracePageAndTask) {
  const Scratch scratch;
  const Outcome outcome = run_task_text(scratch, shipped, "");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("my_task: held: "), std::string::npos) << outcome.out;
  const auto out = scratch.folder / "out";
  const Json figures = Json::parse(contents(out / "metrics.json"));
  EXPECT_TRUE(figures["succeeded"].get<bool>());
  EXPECT_LT(figures["metrics"]["force_rmse_N"].get<double>(), 0.5);
  EXPECT_GT(figures["hold"]["moved_aside_rad"].get<double>(), 0.2);
  EXPECT_LT(figures["hold"]["slip_m"].get<double>(), 2e-3);
  EXPECT_GT(figures["ticks"]["count"].get<int>(), 3000);
  EXPECT_EQ(contents(out / "trace.csv").rfind("time [s],phase [-]", 0), 0U);
  const Json page = Json::parse(contents(out / "run.json"));
  const Json& phases = page["runs"][0]["phases"];
  ASSERT_EQ(phases.size(), 5U);
  EXPECT_EQ(phases[2]["name"], "aside");
  // The written task gives the same result.
  const Scratch again;
  EXPECT_EQ(run_task_text(again, contents(out / "task.yaml"), " --no-page --quiet").exit_code, 0);
  const auto without_times = [](Json metrics) {
    metrics.erase("solver");
    return metrics;
  };
  EXPECT_EQ(without_times(Json::parse(contents(again.folder / "out" / "metrics.json"))["metrics"]),
            without_times(figures["metrics"]));
  EXPECT_FALSE(std::filesystem::exists(again.folder / "out" / "run.json"));
}

TEST(RunCommand, TwoSeeds_WriteAFolderEachAndOneSummary) {
  const Scratch scratch;
  const Outcome outcome =
      run_task_text(scratch, "task: press_hold\n",
                    " --seed 3 --seed 4 --no-page --set phases.hold_duration=0.1"
                    " --set disturbances=sensors");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("my_task_seed3  my_task_seed4"), std::string::npos) << outcome.out;
  const auto out = scratch.folder / "out";
  const Json summary = Json::parse(contents(out / "summary.json"));
  ASSERT_EQ(summary.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(summary[i]["seed"], 3 + i);
    const std::string name = "my_task_seed" + std::to_string(3 + i);
    EXPECT_EQ(Json::parse(contents(out / name / "metrics.json")), summary[i]);
  }
  EXPECT_NE(summary[0]["metrics"]["force_rmse_N"], summary[1]["metrics"]["force_rmse_N"]);
  EXPECT_NE(run_task_text(scratch, "task: press_hold\n", " --seed 3 --seed 3").err.find("twice"),
            std::string::npos);
  EXPECT_NE(run("run my.urdf").err.find("did you mean burnish run TASK --robot my.urdf?"),
            std::string::npos);
}

/// Every override that names another robot adapts the task to it. The file's own robot is not
/// adapted.
TEST(RunCommand, AnotherRobotByAnOverride_AdaptsTheTask) {
  const std::string arm = std::string(BURNISH_ROBOTS_DIR) + "/talos:right_arm";
  const std::string soon = " --quiet --no-page --set phases.hold_duration=0.1";
  const std::string task = "task: press_hold\naside: {joint_3: 0.2}\n";
  for (const std::string& robot : {" --robot " + arm, " --set robot=" + arm}) {
    const Scratch scratch;
    const Outcome outcome = run_task_text(scratch, task, soon + robot);
    EXPECT_EQ(outcome.exit_code, 0) << robot << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("note: aside: robot 'talos' does not have"), std::string::npos)
        << robot << outcome.err;
  }
  const Scratch scratch;
  const Outcome refused = run_task_text(scratch, task + "robot: " + arm + "\n", soon);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("aside.joint_3"), std::string::npos) << refused.err;
}

TEST(RunCommand, UnstatedDisturbances_AreANoteOfAnIdealWorld) {
  const std::string ideal = "note: the world is ideal", task = "task: press_hold\n";
  const std::string soon = " --quiet --no-page --set phases.hold_duration=0.1";
  const auto has_note = [&](const std::string& text, const std::string& more) {
    const Scratch scratch;
    const Outcome outcome = run_task_text(scratch, text, soon + more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    return outcome.err.find(ideal) != std::string::npos;
  };
  EXPECT_TRUE(has_note(task, ""));
  EXPECT_TRUE(has_note(task, " --seed 2"));
  EXPECT_FALSE(has_note(task + "disturbances: none\n", ""));
  EXPECT_FALSE(has_note(task, " --set disturbances=none"));
  EXPECT_FALSE(has_note(task + "disturbances: {force_noise: 0}\n", ""));
}

TEST(RunCommand, SurfaceOutOfReach_FailsWithItsReason) {
  const Scratch far;
  const Outcome failed =
      run_task_text(far, shipped, " --quiet --set disturbances.surface_height=-0.2");
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_NE(failed.out.find("no contact at"), std::string::npos) << failed.out;
  EXPECT_TRUE(std::filesystem::exists(far.folder / "out" / "last_second.csv"));
}

/// A standing robot passes without a push and falls with a push of 400 N.
TEST(RunCommand, StandingRobot_ReportsWhetherItFell) {
  if (run("run --help").out.find("has no MuJoCo") != std::string::npos)
    GTEST_SKIP() << "without MuJoCo there are no feet to stand on";
  const Scratch scratch;
  const auto stand = [&](const std::string& out, const std::string& more) {
    const auto file =
        std::filesystem::path(BURNISH_ROBOTS_DIR) / ".." / "tasks" / "stand" / "quadruped.yaml";
    return run("run " + quoted(file) + " --out " + quoted(scratch.folder / out) +
               " --set sway.rise=0.5 --set phases.sway_duration=1 --set phases.rest_duration=0.1" +
               more);
  };
  const Outcome well = stand("well", "");
  EXPECT_EQ(well.exit_code, 0) << well.out << well.err;
  EXPECT_NE(well.out.find("quadruped: stood: "), std::string::npos) << well.out;
  const Json figures = Json::parse(contents(scratch.folder / "well" / "metrics.json"));
  EXPECT_FALSE(figures["fell"].get<bool>());
  EXPECT_LT(figures["sway"]["com_rmse_m"].get<double>(), 5e-3);
  EXPECT_GT(figures["standing"]["min_load_N"].get<double>(), 5.0);
  const Json page = Json::parse(contents(scratch.folder / "well" / "run.json"))["runs"][0];
  EXPECT_EQ(page["supports"].size(), 4U);
  for (const Json& fact : page["facts"]) EXPECT_NE(fact[0], "force") << "the robot presses nothing";
  const Outcome badly = stand("badly",
                              " --quiet --no-page --set 'disturbances.pushes=[{start: 1.6, "
                              "duration: 0.4, force: [0, 400, 0]}]'");
  EXPECT_EQ(badly.exit_code, 1) << badly.out << badly.err;
  EXPECT_NE(badly.out.find("; the robot fell"), std::string::npos) << badly.out;
  EXPECT_TRUE(Json::parse(contents(scratch.folder / "badly" / "metrics.json"))["fell"].get<bool>());
}

/// --robot replaces the feet of a shipped file by those of the robot. Feet that the command line
/// states must belong to the robot.
TEST(RunCommand, UnknownFeetOnTheCommandLine_AreRefused) {
  const Scratch scratch;
  const auto file =
      std::filesystem::path(BURNISH_ROBOTS_DIR) / ".." / "tasks" / "stand" / "talos.yaml";
  for (const char* change :
       {"'standing.feet=[fl_fot, fr_fot, rl_fot, rr_fot]'", "'standing={feet: [fl_fot]}'"}) {
    const Outcome outcome = run("run " + quoted(file) + " --robot quadruped --out " +
                                quoted(scratch.folder / "out") + " --set " + change);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("frame 'fl_fot'"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("fl_foot"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(scratch.folder / "out"));
  }
}

TEST(RunCommand, PolishingTask_RunsTheMpc) {
  const Scratch scratch;
  const Outcome outcome =
      run_task_text(scratch, "task: polishing\nsurface: table\nphases: {polish_duration: 0.6}\n",
                    " --no-page --json --set path.start_up=0.2 --set phases.reach_duration=0.2"
                    " --set verdict.force_rmse=0.2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const Json metrics = Json::parse(outcome.out);
  EXPECT_EQ(metrics["task"], "polishing");
  EXPECT_EQ(metrics["controller"], "mpc");
  EXPECT_TRUE(metrics["succeeded"].get<bool>());
  EXPECT_TRUE(std::filesystem::exists(scratch.folder / "out" / "trace.csv"));
  EXPECT_FALSE(std::filesystem::exists(scratch.folder / "out" / "summary.json"));
}

TEST(RunCommand, BadTaskFile_IsRefusedWithItsPlace) {
  const Scratch scratch;
  for (const auto& [text, words] :
       {std::pair("robot: arm7\n", "burnish polish"),
        std::pair("task: press_hold\ntool: {frame: tol}\n", "line 2: tool.frame"),
        std::pair("task: press_hold\nrobot: arm8\n", "arm8")}) {
    const Outcome outcome = run_task_text(scratch, text, "");
    EXPECT_EQ(outcome.exit_code, 2) << text;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("my_task.yaml"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace burnish::testing
