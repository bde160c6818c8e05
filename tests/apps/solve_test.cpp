// Tests of the command burnish solve: files, exit codes, warm starts, Ctrl-C.
#include <algorithm>
#include <csignal>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

const std::string problem =
    "robot: arm7\n"
    "contacts:\n"
    "  table: {tool: tool, directions: z, kd: 20}\n"
    "stages:\n"
    "  press:\n"
    "    contacts: [table]\n"
    "    costs:\n"
    "      posture: {type: state}\n"
    "      torque: {type: control, target: hold, weight: 1e-3}\n"
    "      point: {type: frame_position, frame: tool, target: {here: [0.05, 0, 0]}, weight: 100}\n"
    "      force: {type: contact_force, contact: table, target: 20, weight: 0.1}\n"
    "horizon:\n"
    "  - press: 20\n"
    "terminal: {posture: {type: state}}\n";

TEST(SolveCommand, PressingArm_WritesTrajectorySummaryGainsAndPlots) {
  const Scratch scratch;
  const auto file = scratch.write("press.yaml", problem);
  const auto out = scratch.folder / "out";
  const Outcome outcome = run("solve " + quoted(file) + " --out " + quoted(out));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("converged: the expected improvement"), std::string::npos);
  const std::string table = contents(out / "trajectory.csv");
  EXPECT_EQ(lines_of(table), 1 + 21);
  for (const char* column : {"time [s],", "q_joint_1 [rad]", "v_joint_7 [rad/s]",
                             "tau_joint_1 [Nm]", "u_joint_1 [Nm]", "table_force_z_centered [N]",
                             "table_force_z_centered_target [N]", "tool_x_world_target [m]"})
    EXPECT_NE(table.find(column), std::string::npos) << column;

  const Json summary = Json::parse(contents(out / "summary.json"));
  EXPECT_TRUE(summary["converged"].get<bool>());
  EXPECT_EQ(summary["reason"], "converged");
  EXPECT_EQ(summary["log"].size(), summary["iterations"].get<std::size_t>());
  EXPECT_LE(summary["largest_gap"].get<double>(), 1e-9);
  const Json& steps = summary["discretization"];
  EXPECT_EQ(steps["status"], "ok");
  EXPECT_FALSE(steps["coarse"].get<bool>());
  EXPECT_EQ(steps["position"]["unit"], "rad");
  EXPECT_LT(steps["position"]["error"].get<double>(), steps["position"]["limit"].get<double>());
  EXPECT_EQ(outcome.err.find("warning"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("discretisation: largest error of a step"), std::string::npos);

  const Json gains = Json::parse(contents(out / "gains.json"));
  ASSERT_EQ(gains["knots"].size(), 20U);
  EXPECT_EQ(gains["rows"].size(), 7U);
  EXPECT_EQ(gains["columns"].size(), 14U);
  EXPECT_EQ(gains["columns"][7], "v joint_1");
  const Json& knot = gains["knots"][3];
  EXPECT_EQ(knot["x"].size(), 14U);
  EXPECT_EQ(knot["gain"].size(), 7U);
  EXPECT_EQ(knot["gain"][0].size(), 14U);

  for (const char* plot : {"states.svg", "torques.svg", "forces.svg", "path.svg", "cost.svg"}) {
    const std::string text = contents(out / plot);
    EXPECT_EQ(text.rfind("<svg ", 0), 0U) << plot;
    EXPECT_NE(text.find("class='curve'"), std::string::npos) << plot;
    EXPECT_EQ(text.find("nan"), std::string::npos) << plot;
  }
}

TEST(SolveCommand, Page_HasTheLimitsAndIsReadByReport) {
  const Scratch scratch;
  const auto file =
      scratch.write("swing.yaml",
                    "robot: pendulum\n"
                    "stages:\n"
                    "  go:\n"
                    "    costs: {effort: {type: control}}\n"
                    "    constraints: {push: {type: control, lower: -2, upper: 2}}\n"
                    "horizon: [go: 30]\n"
                    "terminal: {there: {type: state, target: {q: [1]}, weight: 1000}}\n");
  const auto out = scratch.folder / "out";
  const Outcome outcome = run("solve " + quoted(file) + " --out " + quoted(out));
  const Json page = Json::parse(contents(out / "run.json"));
  const Json& motion = page["runs"].at(0);
  EXPECT_EQ(motion["name"], "swing");
  EXPECT_EQ(motion["series"]["time"]["n"], 31);
  EXPECT_EQ(motion["phases"].at(0)["name"], "go");
  const Json& limit = motion["plan"]["limits"].at(0);
  EXPECT_EQ(limit["margin"]["n"], 31);
  EXPECT_EQ(limit["multiplier"]["n"], 31);
  EXPECT_EQ(outcome.err.find("meshes"), std::string::npos);
  const auto report = scratch.folder / "report.html";
  if (std::filesystem::exists(out / "run.html")) {
    EXPECT_NE(outcome.out.find("run.html"), std::string::npos);
    EXPECT_EQ(run("report " + quoted(out) + " --out " + quoted(report)).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(report));
  }
}

TEST(SolveCommand, DistanceFromTarget_IgnoresAxesWithoutWeight) {
  const Scratch scratch;
  std::string slope = problem;
  const std::string from = "target: {here: [0.05, 0, 0]}, weight: 100";
  slope.replace(slope.find(from), from.size(),
                "axes: {normal: [-0.5, 0, 0.866]}, target: {here: [0.05, 0, 0.02]},"
                " weights: [1, 1, 0], weight: 100");
  const auto out = scratch.folder / "out";
  run("solve " + quoted(scratch.write("slope.yaml", slope)) + " --no-page --quiet --out " +
      quoted(out));
  const std::string table = contents(out / "trajectory.csv");
  const std::string first = table.substr(table.find('\n') + 1);
  const std::string line = first.substr(0, first.find('\n'));
  EXPECT_NE(table.find("tool_distance_from_target [m]\n"), std::string::npos)
      << "the distance is not the last column";
  EXPECT_NEAR(std::stod(line.substr(line.rfind(',') + 1)), 0.05, 1e-9);
}

TEST(SolveCommand, ActiveConstraints_AreListedByKnot) {
  const Scratch scratch;
  const std::string free =
      "robot: pendulum\n"
      "stages:\n"
      "  swing:\n"
      "    costs: {torque: {type: control}}\n"
      "horizon: [swing: 40]\n"
      "terminal: {there: {type: state, target: {q: [1]}, weight: 1000}}\n";
  std::string limited = free;
  limited.insert(limited.find("horizon"),
                 "    constraints: {speed: {type: joint_velocity, lower: -3, upper: 3}}\n");
  const auto solved = [&](const std::string& name, const std::string& text) {
    const auto out = scratch.folder / name;
    const Outcome outcome =
        run("solve " + quoted(scratch.write(name + ".yaml", text)) + " --out " + quoted(out));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    return out;
  };
  EXPECT_FALSE(std::filesystem::exists(solved("free", free) / "limits.csv"));
  const auto out = solved("limited", limited);
  const std::string table = contents(out / "limits.csv");
  EXPECT_EQ(table.rfind("knot [-],time [s],stage [-],row,value,lower,upper,multiplier\n", 0), 0U);
  const Json row = Json::parse(contents(out / "summary.json"))["constraints"][0];
  EXPECT_GT(row["active_knots"].get<int>(), 0);
  EXPECT_EQ(lines_of(table), 1 + row["active_knots"].get<int>());
  EXPECT_NE(table.find("," + row["row"].get<std::string>() + ","), std::string::npos) << table;
  for (const Json& range : row["active_times"])
    EXPECT_LE(range[0].get<double>(), range[1].get<double>());
  EXPECT_GT(row["active_times"].size(), 0U);
  EXPECT_NE(contents(out / "limits.svg").find("class='curve'"), std::string::npos);
}

TEST(SolveCommand, CoarseSteps_AreAWarningAndInTheSummary) {
  const Scratch scratch;
  std::string coarse = problem;
  coarse.replace(coarse.find("    contacts: [table]\n"), 0, "    step: 0.5\n");
  coarse.replace(coarse.find("kd: 20"), 6, "kd: 2");
  const auto out = scratch.folder / "out";
  const Outcome outcome = run("solve " + quoted(scratch.write("coarse.yaml", coarse)) +
                              " --quiet --out " + quoted(out));
  for (const char* word : {"warning: the steps are too coarse", "0.5 s", "short enough"})
    EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
  const Json steps = Json::parse(contents(out / "summary.json"))["discretization"];
  EXPECT_TRUE(steps["coarse"].get<bool>());
  EXPECT_LT(steps["sufficient_step"].get<double>(), 0.5);
  EXPECT_GT(steps["sufficient_step"].get<double>(), 0.0);
}

TEST(SolveCommand, IterationLimit_GivesExitCodeOneAndWritesFiles) {
  const Scratch scratch;
  const auto file = scratch.write("press.yaml", problem);
  const auto out = scratch.folder / "out";
  const Outcome outcome =
      run("solve " + quoted(file) + " --iterations 1 --quiet --out " + quoted(out));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(lines_of(outcome.out), 1) << outcome.out;
  EXPECT_NE(outcome.out.find("stopped after 1 iterations"), std::string::npos);
  // The gains belong to the written trajectory.
  const Json gains = Json::parse(contents(out / "gains.json"));
  ASSERT_EQ(gains["knots"].size(), 20U);
  std::istringstream rows(contents(out / "trajectory.csv"));
  std::string row;
  for (int i = 0; i < 7; ++i) std::getline(rows, row);  // header and knots 0 to 5
  std::istringstream cells(row);
  std::string cell;
  for (int i = 0; i < 3; ++i) std::getline(cells, cell, ',');  // time, stage, q of joint_1
  EXPECT_EQ(gains["knots"][5]["x"][0].get<double>(), std::stod(cell));
}

TEST(SolveCommand, GuessFromATrajectory_ConvergesInOneIteration) {
  const Scratch scratch;
  const auto first = scratch.write("press.yaml", problem);
  ASSERT_EQ(run("solve " + quoted(first) + " --out " + quoted(scratch.folder / "a")).exit_code, 0);
  const auto again = scratch.write("again.yaml", problem + "guess: {file: a/trajectory.csv}\n");
  const Outcome outcome =
      run("solve " + quoted(again) + " --json --out " + quoted(scratch.folder / "b"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_LE(Json::parse(outcome.out)["iterations"].get<int>(), 1);
}

TEST(SolveCommand, CheckOption_PrintsTheDerivativeCheck) {
  const Scratch scratch;
  const auto file = scratch.write("press.yaml", problem);
  const Outcome outcome =
      run("solve " + quoted(file) + " --check --quiet --out " + quoted(scratch.folder / "out"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("next state"), std::string::npos) << outcome.out;
}

TEST(SolveCommand, BadInput_IsRefusedInOneSentence) {
  const Scratch scratch;
  expect_refused(run("solve nowhere.yaml"), "nowhere.yaml: the file cannot be opened");
  expect_refused(run("solve"), "PROBLEM is required");
  const auto file = scratch.write("press.yaml", problem);
  expect_refused(run("solve " + quoted(file) + " --iteration 3"), "did you mean '--iterations'?");
  expect_refused(run("solve " + quoted(file) + " --threads 0"), "--threads");
  expect_refused(run("solve " + quoted(file) + " --tolerance nan"), "stop_tolerance is nan");
  expect_refused(run("solve " + quoted(file) + " --out " + quoted(file)), "cannot make the folder");
  const auto bad = scratch.write("bad.yaml", problem + "solvr: {}\n");
  expect_refused(run("solve " + quoted(bad)), "did you mean 'solver'?");
}

TEST(SolveCommand, ProblemBeyondTheMemory_IsRefused) {
  const Scratch scratch;
  const auto file = scratch.write(
      "long.yaml",
      "robot: talos\nstages: {wait: {costs: {torque: {type: control}}}}\nhorizon: [wait: 90000]\n");
  const Outcome outcome = shell("ulimit -v 4000000; '" BURNISH_PROGRAM "' solve " + quoted(file));
  expect_refused(outcome, file.string() + ": solver: 90000 knots of ");
  EXPECT_NE(outcome.err.find("GB of memory; at most 4 GB are supported"), std::string::npos)
      << outcome.err;
}

TEST(SolveCommand, MissingValues_AreEmptyCells) {
  const Scratch scratch;
  const auto file = scratch.write("press.yaml", problem);
  ASSERT_EQ(
      run("solve " + quoted(file) + " --quiet --out " + quoted(scratch.folder / "out")).exit_code,
      0);
  const std::string table = contents(scratch.folder / "out" / "trajectory.csv");
  EXPECT_EQ(table.find("nan"), std::string::npos);
  const std::string last = table.substr(table.rfind('\n', table.size() - 2) + 1);
  EXPECT_NE(last.find(",,,,,,"), std::string::npos) << last;
}

TEST(SolveCommand, Interrupt_EndsTheIterationAndWritesFiles) {
  const Scratch scratch;
  // The solve must outlast the signal, on a busy machine too.
  std::string text = contents(std::filesystem::path(BURNISH_ROBOTS_DIR).parent_path() /
                              "examples/problems/standing_wall.yaml");
  const std::string horizon = "stand: 100";
  ASSERT_NE(text.find(horizon), std::string::npos);
  text.replace(text.find(horizon), horizon.size(), "stand: 600");
  text += "solver: {stop_tolerance: 1e-30, max_iterations: 100000}\n";
  const auto file = scratch.write("wall.yaml", text);
  const auto out = scratch.folder / "out", output = scratch.folder / "output";
  const auto seen = scratch.folder / "seen";
  const std::string script =
      "'" BURNISH_PROGRAM "' solve " + quoted(file) + " --out " + quoted(out) + " >" +
      quoted(output) + " 2>&1 & pid=$!; until grep -q '^ *1 ' " + quoted(output) +
      "; do kill -0 $pid || exit 9; done; kill -INT $pid; grep -c '^ *[0-9]' " + quoted(output) +
      " >" + quoted(seen) + "; wait $pid";
  const int status = std::system(script.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1) << contents(output);
  const Json summary = Json::parse(contents(out / "summary.json"));
  EXPECT_EQ(summary["reason"], "interrupted");
  // At most the iteration in progress is added, and one that was finished but not yet printed.
  EXPECT_LE(summary["iterations"].get<int>(), std::stoi(contents(seen)) + 1);
  EXPECT_EQ(lines_of(contents(out / "trajectory.csv")), 1 + 601);
}

TEST(SolveCommand, InterruptDuringTheSetUp_WritesNothing) {
  const Scratch scratch;
  const auto file = std::filesystem::path(BURNISH_ROBOTS_DIR).parent_path() /
                    "examples/problems/standing_wall.yaml";
  const auto out = scratch.folder / "out";
  // The check of derivatives takes longer than the wait for the program's signal handler.
  const Outcome outcome = shell(
      "'" BURNISH_PROGRAM "' solve " + quoted(file) + " --check --out " + quoted(out) +
      " & pid=$!; until grep -q 'SigCgt:[[:space:]]*0*[1-9a-f]' /proc/$pid/status; do kill -0 $pid "
      "|| exit 9; done; sleep 0.05; kill -INT $pid; wait $pid");
  EXPECT_EQ(outcome.exit_code, 128 + SIGINT) << outcome.out;
  EXPECT_EQ(outcome.err, "burnish: Ctrl-C: interrupted, nothing was written\n");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace burnish::testing
