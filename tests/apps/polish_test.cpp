// Tests of the command burnish polish: files, exit codes, bad input, Ctrl-C.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"
#include "record/page_data.hpp"
#include "support/six_joint_arm.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

/// Options of a run of less than two seconds of simulated time on the ideal plant.
const std::string short_run =
    " --plant ideal --duration 0.6 --set path.start_up=0.2 --set phases.reach_duration=0.2 "
    "--set verdict.force_rmse=0.2";  // wide, as the transient at the start is most of the run

TEST(Polish, TwoControllers_WriteTheFilesOfBothRuns) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const Outcome outcome =
      run("polish --surface board" + short_run + " --time --plots --out " + quoted(out));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");  // no progress bar: standard error is not a terminal
  for (const char* words : {"force_rmse", "position_p95", "board_mpc", "board_baseline",
                            "time of a tick", "m of path", "polished: "})
    EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;

  const Json summary = Json::parse(contents(out / "summary.json"));
  ASSERT_EQ(summary.size(), 2U);
  for (const Json& each : summary) {
    const auto folder = out / each["name"].get<std::string>();
    EXPECT_TRUE(each["succeeded"].get<bool>());
    EXPECT_EQ(Json::parse(contents(folder / "metrics.json")), each);
    EXPECT_NEAR(each["metrics"]["force_mean_N"].get<double>(), 30.0, 5.0);
    EXPECT_GT(each["reach"]["points"].get<int>(), 10);
    const std::string table = contents(folder / "trace.csv");
    EXPECT_EQ(table.rfind("time [s],phase [-]", 0), 0U);
    const bool mpc = each["controller"] == "mpc";
    for (const char* plot : {"force.svg", "path.svg", "torques.svg", "solver.svg"}) {
      const bool expected = mpc || plot != std::string("solver.svg");
      EXPECT_EQ(std::filesystem::exists(folder / plot), expected) << plot;
      if (!expected) continue;
      const std::string text = contents(folder / plot);
      EXPECT_EQ(text.rfind("<svg ", 0), 0U) << plot;
      EXPECT_NE(text.find("<path class="), std::string::npos) << plot;
      EXPECT_EQ(text.find("nan"), std::string::npos) << plot;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "fault.txt"));
  }
}

TEST(Polish, UnstatedGains_AreFittedToTheArmAndWritten) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const std::string what = "polish --surface table --controller mpc --no-page" + short_run;
  const Outcome fitted = run(what + " --out " + quoted(out));
  EXPECT_EQ(fitted.exit_code, 0) << fitted.out << fitted.err;
  EXPECT_EQ(fitted.err, "");
  for (const char* words :
       {"weights.position 100000 in place of 10000", "table: the control loop tolerates ",
        "ms of extra delay", "plans take no time in this simulation"})
    EXPECT_NE(fitted.out.find(words), std::string::npos) << words << "\n" << fitted.out;
  const std::string task = contents(out / "table_mpc" / "task.yaml");
  EXPECT_NE(task.find("  transient_scale: 6 "), std::string::npos) << task;
  EXPECT_NE(task.find("  force_gain: 0.5\n"), std::string::npos) << task;
  const Outcome stated =
      run(what +
          " --set weights.position=1e4 --set model_error.transient_scale=6 --set "
          "model_error.bandwidth=120 --out " +
          quoted(scratch.folder / "stated"));
  EXPECT_EQ(stated.err, "");
  EXPECT_EQ(stated.out.find("in place of"), std::string::npos) << stated.out;
  EXPECT_NE(stated.out.find("table: the control loop tolerates 1."), std::string::npos)
      << stated.out;
}

TEST(Polish, CurvedPath_OnThePageMatchesThePathError) {
  for (const auto& [kind, radius] :
       {std::pair<std::string, std::string>{"cylinder", "0.2"}, {"sphere", "0.3, hollow: true"}}) {
    SCOPED_TRACE(kind);
    const Scratch scratch;
    const auto out = scratch.folder / "out";
    const Outcome outcome = run(
        "polish --surface table --controller baseline --duration 1.2 --quiet "
        "--set path.radius=0.05 --set path.start_up=0.3 --set path.rate=4 --set 'shape={kind: " +
        kind + ", radius: " + radius + "}' --out " + quoted(out));
    if (outcome.err.find("this build has no MuJoCo") != std::string::npos ||
        outcome.err.find("wanted a plane, or MuJoCo") != std::string::npos)
      GTEST_SKIP() << "a curved surface needs MuJoCo";
    EXPECT_LE(outcome.exit_code, 1) << outcome.err;
    const Json page =
        Json::parse(contents(out / ("table_" + kind + "_baseline") / "run.json"))["runs"][0];
    const auto column = [&](const std::string& name) {
      for (const Json& each : page["series"]["columns"])
        if (each["name"] == name) return floats_of(each["data"]);
      ADD_FAILURE() << name;
      return std::vector<float>();
    };
    const std::vector<float> asked_u = floats_of(page["path"]["u"]),
                             asked_w = floats_of(page["path"]["w"]);
    const std::vector<float> u = column("path_u"), w = column("path_w"), phase = column("phase"),
                             error = column("path_error");
    float max_distance = 0.0F;
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (phase[i] != 3.0F) continue;
      float nearest = 1.0F;
      for (std::size_t k = 0; k < asked_u.size(); ++k)
        nearest = std::min(nearest, std::hypot(u[i] - asked_u[k], w[i] - asked_w[k]));
      // The path's points are 2 mm apart. The tip's centre is 3 mm or more off the touched point.
      EXPECT_LT(nearest, 1.2F * error[i] + 2e-3F);
      max_distance = std::max(max_distance, std::hypot(u[i], w[i]));
    }
    EXPECT_NEAR(max_distance, 0.05F, 1e-3F);
  }
}

TEST(Polish, SearchedPosture_IsPrintedAndAddedToTheSettings) {
  const Scratch scratch;
  scratch.write("arm.urdf", six_joint_arm());
  const auto settings = scratch.write(
      "robot.yaml",
      "urdf: arm.urdf\nframes:\n  tool: {parent: flange}\npostures:\n  # mine\n    a: {j1: 1}\n");
  const std::string polish =
      "polish --controller baseline --no-page --duration 0.2 --plant ideal "
      "--set verdict.contact_share=0 --set verdict.force_rmse=100 --force --out " +
      quoted(scratch.folder / "out") + " --robot ";
  const std::string folder = quoted(scratch.folder);
  const Outcome first = run(polish + folder + " --write-posture table");
  EXPECT_EQ(first.exit_code, 0) << first.err << first.out;
  EXPECT_NE(first.out.find("table: start posture found by search: {j1: "), std::string::npos)
      << first.out;
  const std::string text = contents(settings);
  EXPECT_NE(text.find("postures:\n    table: {j1: "), std::string::npos) << text;
  EXPECT_NE(text.find("  # mine\n    a: {j1: 1}\n"), std::string::npos) << text;
  const Outcome again = run(polish + folder);
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.out.find("found by search"), std::string::npos) << again.out;
  expect_refused(run(polish + folder + " --write-posture b"),
                 "the start posture at table comes from the robot's settings");
  expect_refused(run(polish + folder + " --write-posture a --set posture=search"),
                 "posture 'a' already exists");
  expect_refused(
      run(polish + quoted(scratch.folder / "arm.urdf") + " --tool flange --write-posture a"),
      "wanted a settings file, which `burnish show ROBOT --write-settings DIR --tool FRAME` "
      "drafts");
  expect_refused(run(polish + folder + " --surface table --surface board --write-posture a"),
                 "wanted one --surface");
}

TEST(Polish, MeshesOfDraftedSettings_AreFoundOrNamedAsMissing) {
  const Scratch scratch;
  scratch.write("arm/meshes/here.stl",
                "solid facet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                "vertex 0 1 0\nendloop\nendfacet\nendsolid facet\n");
  std::string text = six_joint_arm();
  const auto visual = [](const std::string& uri) {
    return "<visual><geometry><mesh filename='" + uri + "'/></geometry></visual>";
  };
  text.replace(text.find("<link name='base'/>"), 19,
               "<link name='base'>" + visual("meshes/here.stl") +
                   visual("package://left_behind/meshes/here.stl") + visual("meshes/gone.stl") +
                   "</link>");
  const std::string file = quoted(scratch.write("arm/arm.urdf", text));
  const std::string drafted = quoted(scratch.folder / "elsewhere/drafted");
  ASSERT_EQ(run("show " + file + " --write-settings " + drafted + " --tool flange").exit_code, 0);
  const Outcome outcome = run("polish --controller baseline --duration 0.2 --plant ideal --robot " +
                              drafted + " --out " + quoted(scratch.folder / "out"));
  EXPECT_NE(outcome.err.find("meshes, which were not found or could not be read: gone.stl"),
            std::string::npos)
      << outcome.err;
#ifdef BURNISH_HAS_ASSIMP
  EXPECT_NE(outcome.err.find("without 1 of its meshes"), std::string::npos) << outcome.err;
#endif
}

TEST(Polish, AllControllers_RunWithTheirOwnGains) {
  const Scratch scratch;
  const Outcome outcome = run("polish --surface table --controller all --json --no-page" +
                              short_run + " --out " + quoted(scratch.folder / "out"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = Json::parse(outcome.out);
  ASSERT_EQ(summary.size(), 3U);
  const char* const names[] = {"mpc", "baseline", "admittance"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(summary[i]["controller"], names[i]);
    EXPECT_EQ(summary[i]["name"], std::string("table_") + names[i]);
  }
  // The task has separate gains for each controller.
  const auto rmse = [&](const std::string& change, const std::string& name) {
    const Outcome changed =
        run("polish --surface table --controller admittance --json --no-page" + short_run +
            " --set " + change + " --out " + quoted(scratch.folder / name));
    return Json::parse(changed.out)[0]["metrics"]["force_rmse_N"].get<double>();
  };
  const double before = summary[2]["metrics"]["force_rmse_N"].get<double>();
  EXPECT_EQ(rmse("baseline.kp=100", "a"), before);
  EXPECT_NE(rmse("admittance.damping=5000", "b"), before);
}

TEST(Polish, MissingForceSensor_IsANoteWithTheForceErrorPerTorque) {
  const Scratch scratch;
  const Outcome outcome =
      run("polish --surface table --controller mpc --no-page" + short_run +
          " --set controller.force_sensor=false --out " + quoted(scratch.folder / "out"));
  for (const char* words :
       {"table: note: without a force sensor",
        "1 Nm in every joint corresponds to 2.2 N along the normal (torso_2_joint"})
    EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
}

TEST(Polish, FileWithoutDisturbances_IsANoteOfAnIdealWorld) {
  const Scratch scratch;
  const auto file = scratch.folder / "mine.yaml";
  std::ofstream(file) << "force: 30\n";
  const Outcome outcome = run("polish " + quoted(file) + " --controller mpc --no-page" + short_run +
                              " --out " + quoted(scratch.folder / "out"));
  EXPECT_NE(outcome.err.find("mine: note: the world is ideal"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("plans take no time in this simulation (controller.timing fixed, "
                             "solver_delay 0), and none counts as late"),
            std::string::npos)
      << outcome.out;
  const Outcome meant =
      run("polish " + quoted(file) + " --controller baseline --disturbances none --no-page" +
          short_run + " --out " + quoted(scratch.folder / "meant"));
  EXPECT_EQ(meant.err.find("the world is ideal"), std::string::npos) << meant.err;
  EXPECT_EQ(meant.out.find("plans take no time"), std::string::npos) << meant.out;
}

TEST(Polish, Plots_AreWrittenOnlyWithoutAPage) {
  const Scratch scratch;
  const std::string alone = "polish --surface table --controller baseline --quiet" + short_run;
  ASSERT_EQ(run(alone + " --out " + quoted(scratch.folder / "with")).exit_code, 0);
  ASSERT_EQ(run(alone + " --no-page --out " + quoted(scratch.folder / "without")).exit_code, 0);
  const auto with = scratch.folder / "with" / "table_baseline",
             without = scratch.folder / "without" / "table_baseline";
  for (const char* plot : {"force.svg", "path.svg", "torques.svg"}) {
    EXPECT_NE(std::filesystem::exists(with / plot), std::filesystem::exists(with / "run.html"));
    EXPECT_TRUE(std::filesystem::exists(without / plot)) << plot;
  }
}

TEST(Polish, UrdfFileAndToolFrame_AreEnoughToPolish) {
  const Scratch scratch;
  const auto file = scratch.folder / "my arm.urdf";
  std::filesystem::copy(std::filesystem::path(BURNISH_ROBOTS_DIR) / "arm7" / "arm7.urdf", file);
  const std::string what = "polish --robot " + quoted(file) + " --out " +
                           quoted(scratch.folder / "out") + " --controller mpc --json" + short_run;
  const Outcome outcome = run(what + " --tool flange");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = Json::parse(outcome.out);
  ASSERT_EQ(summary.size(), 1U);  // on the table
  EXPECT_EQ(summary[0]["name"], "table_mpc");
  EXPECT_TRUE(summary[0]["succeeded"].get<bool>());
  const Outcome piped = shell("bash -c \"'" BURNISH_PROGRAM "' polish --robot <(cat " +
                              quoted(file) + ") --out " + quoted(scratch.folder / "piped") +
                              " --controller mpc --json" + short_run + " --tool flange\"");
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_EQ(Json::parse(piped.out)[0]["metrics"]["force_rmse_N"],
            summary[0]["metrics"]["force_rmse_N"]);
  const Outcome lost = run(what);
  EXPECT_EQ(lost.exit_code, 2);
  for (const char* words : {"--robot ", "the tool's frame 'tool' does not exist on robot 'arm7'",
                            "frames named like a tool: flange", "--tool FRAME"})
    EXPECT_NE(lost.err.find(words), std::string::npos) << words << ": " << lost.err;
  EXPECT_EQ(lost.err.find("override"), std::string::npos) << lost.err;
}

TEST(Polish, RobotInPlaceOfATask_IsRefusedWithTheOption) {
  for (const char* robot : {BURNISH_ROBOTS_DIR "/arm7/arm7.urdf", "arm7"}) {
    const Outcome outcome = run(std::string("polish ") + robot);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(std::string("did you mean --robot ") + robot + "?"),
              std::string::npos)
        << outcome.err;
  }
  EXPECT_NE(run("polish --robot pendulum").err.find("--tool FRAME"), std::string::npos);
}

TEST(Polish, TiltedSurface_NamesTheRun) {
  const Scratch scratch;
  const Outcome outcome =
      run("polish --robot arm7 --controller baseline --json --set 'surface.normal=[-0.5, 0, 0.866]'"
          " --no-page --out " +
          quoted(scratch.folder / "out") + short_run);
  EXPECT_EQ(Json::parse(outcome.out)[0]["name"], "tilt_30_baseline") << outcome.err;
}

TEST(Polish, RunShorterThanItsPath_IsJudgedAndReportedAsCutShort) {
  const Scratch scratch;
  const Outcome outcome =
      run("polish --surface table --controller baseline --no-page --quiet --set path.kind=zigzag"
          " --out " +
          quoted(scratch.folder / "out") + short_run);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("table_baseline: cut short: "), std::string::npos) << outcome.out;
}

TEST(Polish, WrittenTask_RunsToTheSameResult) {
  const Scratch scratch;
  const auto first = scratch.folder / "first", second = scratch.folder / "second";
  const std::string what = " --controller baseline --json --out ";
  const Outcome once = run("polish --surface table --seed 5 --set force=20 --disturbances sensors" +
                           short_run + what + quoted(first));
  ASSERT_EQ(once.exit_code, 0) << once.err;
  const auto task = first / "table_baseline" / "task.yaml";
  const Outcome again = run("polish --plant ideal " + quoted(task) + what + quoted(second));
  ASSERT_EQ(again.exit_code, 0) << again.err;
  const Json a = Json::parse(once.out)[0], b = Json::parse(again.out)[0];
  EXPECT_EQ(a["metrics"], b["metrics"]);
  EXPECT_EQ(a["seed"], 5);
  EXPECT_NEAR(a["metrics"]["force_mean_N"].get<double>(), 20.0, 4.0);
  EXPECT_EQ(b["name"], "task_baseline");
  EXPECT_EQ(contents(second / "task_baseline" / "task.yaml"), contents(task));
}

TEST(Polish, RecordEvery_ThinsTheTrace) {
  const Scratch scratch;
  const auto rows = [&](const std::string& every) {
    const auto out = scratch.folder / every;
    const Outcome outcome = run("polish --surface table --controller baseline --quiet --out " +
                                quoted(out) + short_run + " --record-every " + every);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out.find("folder"), std::string::npos);
    return lines_of(contents(out / "table_baseline" / "trace.csv")) - 1;
  };
  const int all = rows("1"), some = rows("20");
  EXPECT_GT(all, 2000);
  EXPECT_NEAR(some, all / 20.0, 2.0);
}

TEST(Polish, Fault_GivesExitCodeOneAndAReport) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const Outcome outcome =
      run("polish --surface table --controller mpc --set limits.tool_speed=0.01 --out " +
          quoted(out) + short_run);
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
  const auto folder = out / "table_mpc";
  const std::string fault = contents(folder / "fault.txt");
  EXPECT_NE(fault.find("speed limit"), std::string::npos) << fault;
  EXPECT_NE(outcome.out.find("speed limit"), std::string::npos);
  EXPECT_GT(lines_of(contents(folder / "last_second.csv")), 2);
  EXPECT_GT(lines_of(contents(folder / "trace.csv")), 2);
  const Json metrics = Json::parse(contents(folder / "metrics.json"));
  EXPECT_FALSE(metrics["succeeded"].get<bool>());
  EXPECT_EQ(metrics["fault"]["kind"], "speed limit");
  // A run without a fault removes the report.
  EXPECT_EQ(run("polish --surface table --controller mpc --force --out " + quoted(out) + short_run)
                .exit_code,
            0);
  EXPECT_FALSE(std::filesystem::exists(folder / "fault.txt"));
}

TEST(Polish, FigureBeyondTheVerdict_GivesExitCodeOne) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const Outcome outcome = run("polish --surface table --controller baseline --quiet --out " +
                              quoted(out) + short_run + " --set verdict.force_rmse=1e-5");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.out;
  const Json run = Json::parse(contents(out / "summary.json"))[0];
  EXPECT_FALSE(run["succeeded"].get<bool>());
  EXPECT_EQ(run["verdict"]["force_rmse"]["at_most"], 1e-5);
  EXPECT_GT(run["verdict"]["force_rmse"]["value"].get<double>(), 1e-5);
  EXPECT_GT(run["verdict"]["contact_share"]["value"].get<double>(), 0.9);
  const std::string words = "the force was off by";
  for (const std::string& text : {run["outcome"].get<std::string>(), outcome.out,
                                  contents(out / "table_baseline" / "run.json")})
    EXPECT_NE(text.find(words), std::string::npos) << text.substr(0, 400);
}

TEST(Polish, TwoSeeds_GiveTwoDifferentRuns) {
  const Scratch scratch;
  const Outcome outcome =
      run("polish --surface table --controller baseline --seed 1 --seed 2 --json "
          "--out " +
          quoted(scratch.folder / "out") + short_run);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json summary = Json::parse(outcome.out);
  ASSERT_EQ(summary.size(), 2U);
  EXPECT_EQ(summary[1]["name"], "table_baseline_seed2");
  EXPECT_NE(summary[0]["metrics"], summary[1]["metrics"]);
}

TEST(Polish, WriteTask_WritesTheTaskWithItsChanges) {
  const Scratch scratch;
  const auto file = scratch.folder / "mine.yaml";
  EXPECT_EQ(run("polish --surface board --set force=17 --write-task " + quoted(file)).exit_code, 0);
  const std::string text = contents(file);
  EXPECT_NE(text.find("\nforce: 17 "), std::string::npos) << text;
  EXPECT_NE(text.find("posture: board_x"), std::string::npos);
  EXPECT_NE(text.find("[1/N^2]"), std::string::npos);
}

TEST(Polish, BadInput_IsRefusedInOneSentence) {
  const Scratch scratch;
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    expect_refused(run("polish --out " + quoted(scratch.folder / "out") + " " + arguments), words);
  };
  refused("nowhere.yaml", "nowhere.yaml: the file cannot be opened");
  refused("--surface bord", "did you mean 'board'?");
  refused("--set path.radus=1", "did you mean 'radius'?");
  refused("--set path.radius=0.6", "table is out of reach: ");
  refused("--set 'surface.point=[0.4, -0.3, -1]'", "before the start of the path");
  refused("--set force=300", "limits.force");
  refused("--set force=300 --set limits.force=900", "pressing with 300 N needs");
  refused("--disturbances mismach", "did you mean 'mismatch'?");
  refused("--controller mcp", "--controller");
  refused("--controller both --set 'standing.feet=[left_sole_link, right_sole_link]'",
          "controllers without a plan do not keep balance");
  refused("--plant gazebo", "--plant");
  refused("--duration 0", "phases.polish_duration: it is 0");
  refused("--surfaces table", "did you mean '--surface'?");
  for (const char* line : {"robot: nosuch", "robot: arm7\nposture: nowhere",
                           "robot: arm7\nposture: ready\nsurface: {point: [0, 0, 1]}"}) {
    const auto task = scratch.write("mine.yaml", std::string(line) + "\n");
    refused(quoted(task), task.string() + ": ");
  }
  EXPECT_FALSE(std::filesystem::exists(scratch.folder / "out"));
  const auto file = scratch.write("taken", "");
  expect_refused(run("polish --surface table --quiet --out " + quoted(file) + short_run),
                 "cannot make the folder");
}

/// Starts a run of 60 s, sends `signals` after a while and returns its exit code and output.
Outcome interrupted_run(const Scratch& scratch, const std::string& signals) {
  const auto out = scratch.folder / "out";
  return shell("'" BURNISH_PROGRAM
               "' polish --surface table --controller mpc --plant ideal --duration 60 --out " +
               quoted(out) + " & pid=$!; until [ -e " + quoted(out / ".burnish") +
               " ]; do kill -0 $pid || exit 9; done; sleep 0.3; " + signals + "; wait $pid");
}

TEST(Polish, Signals_EndTheRunAndWriteTheResults) {
  for (const std::string signal : {"INT", "TERM", "HUP"}) {
    SCOPED_TRACE(signal);
    const Scratch scratch;
    const Outcome outcome = interrupted_run(scratch, "kill -" + signal + " $pid");
    EXPECT_EQ(outcome.exit_code, 1) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("the run ends"), std::string::npos) << outcome.err;
    const auto folder = scratch.folder / "out" / "table_mpc";
    const Json metrics = Json::parse(contents(folder / "metrics.json"));
    EXPECT_NE(metrics["outcome"].get<std::string>().find("interrupted at"), std::string::npos);
    EXPECT_GE(lines_of(contents(folder / "trace.csv")), 2);
    EXPECT_EQ(contents(scratch.folder / "out" / ".burnish").rfind("finished", 0), 0U);
  }
}

TEST(Polish, HangUpUnderNohup_IsIgnored) {
  const Scratch scratch;
  const Outcome outcome =
      shell("trap '' HUP; '" BURNISH_PROGRAM "' polish --surface table --controller baseline" +
            short_run + " --out " + quoted(scratch.folder / "out") +
            " & pid=$!; sleep 0.1; kill -HUP $pid; wait $pid");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace burnish::testing
