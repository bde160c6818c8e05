// Tests of output folders: new folders, folders that contain runs, full disks.
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

const std::string quick_polish =
    " --surface table --controller baseline --plant ideal --duration 0.4 --set path.start_up=0.2 "
    "--set phases.reach_duration=0.2 --set verdict.force_rmse=never --no-page --quiet ";

const std::string small_problem =
    "robot: pendulum\n"
    "stages: {swing: {costs: {state: {type: state}, torque: {type: control}}}}\n"
    "horizon: [swing: 10]\n";

/// Runs burnish in a shell whose working directory is `folder`.
Outcome run_in(const fs::path& folder, const std::string& arguments) {
  return shell("cd " + quoted(folder) + " && '" BURNISH_PROGRAM "' " + arguments);
}

TEST(RunFolder, RepeatedCommand_WritesIntoANewFolder) {
  const Scratch scratch;
  scratch.write("swing.yaml", small_problem);
  for (const auto& [command, name] :
       {std::pair("polish" + quick_polish, "polishing_run"),
        std::pair(std::string("solve swing.yaml --quiet"), "swing_solution"),
        std::pair(std::string("experiment tick --quick --quiet --plant ideal"), "experiment_tick")})
    for (const char* number : {"", "_2", "_3"}) {
      const std::string folder = name + std::string(number);
      const Outcome outcome = run_in(scratch.folder, command);
      ASSERT_EQ(outcome.exit_code, 0) << command << outcome.out << outcome.err;
      EXPECT_TRUE(fs::is_directory(scratch.folder / folder)) << folder;
      EXPECT_EQ(fs::read_symlink(scratch.folder / "latest"), folder);
      EXPECT_EQ(contents(scratch.folder / folder / ".burnish").rfind("finished", 0), 0U);
    }
  // A file 'latest' that is not a link stays.
  fs::remove(scratch.folder / "latest");
  scratch.write("latest", "mine");
  EXPECT_EQ(run_in(scratch.folder, "solve swing.yaml --quiet").exit_code, 0);
  EXPECT_EQ(contents(scratch.folder / "latest"), "mine");
}

TEST(RunFolder, FolderWithARun_IsRefusedUnlessForced) {
  const Scratch scratch;
  const fs::path file = scratch.write("swing.yaml", small_problem), out = scratch.folder / "out";
  const std::string to_out = " --out " + quoted(out), solve = "solve " + quoted(file) + " --quiet";
  ASSERT_EQ(run("polish" + quick_polish + to_out).exit_code, 0);
  const std::string words = "'" + out.string() + "' holds a run; wanted another folder, or --force";
  expect_refused(run("polish" + quick_polish + to_out), words);
  expect_refused(run(solve + to_out), words);
  expect_refused(run("experiment tick --quick" + to_out), words);
  EXPECT_TRUE(fs::exists(out / "table_baseline" / "trace.csv"));
  // No file of the old run remains beside the new one.
  ASSERT_EQ(run(solve + " --force" + to_out).exit_code, 0);
  EXPECT_FALSE(fs::exists(out / "table_baseline"));
  EXPECT_TRUE(fs::exists(out / "trajectory.csv"));
  // Files of the user are never removed.
  std::ofstream(out / "notes.txt") << "mine";
  expect_refused(run(solve + " --force" + to_out), "holds 'notes.txt', which is not part of a run");
  EXPECT_EQ(contents(out / "notes.txt"), "mine");
  EXPECT_TRUE(fs::exists(out / "trajectory.csv"));
}

TEST(RunFolder, RunWithoutAListOfFiles_IsRefusedEvenIfForced) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  fs::create_directories(out / "table_mpc");
  std::ofstream(out / "table_mpc" / "metrics.json") << "{}";
  const std::string command = "polish" + quick_polish + "--out " + quoted(out);
  expect_refused(run(command), "holds a run; wanted another folder");
  expect_refused(run(command + " --force"), "without a list of its files");
  EXPECT_TRUE(fs::exists(out / "table_mpc" / "metrics.json"));
}

TEST(RunFolder, FolderWithOtherFiles_IsUsedAndKeepsThem) {
  const Scratch scratch;
  std::ofstream(scratch.folder / "notes.txt") << "mine";
  EXPECT_EQ(run("polish" + quick_polish + "--out " + quoted(scratch.folder)).exit_code, 0);
  EXPECT_EQ(contents(scratch.folder / "notes.txt"), "mine");
  EXPECT_TRUE(fs::exists(scratch.folder / "summary.json"));
}

TEST(RunFolder, RefusedCommand_CreatesNoFolder) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  expect_refused(
      run("polish --surface table --surface table" + quick_polish + "--out " + quoted(out)),
      "table_baseline is requested twice");
  EXPECT_FALSE(fs::exists(out));
}

TEST(RunFolder, SecondRunIntoTheSameFolder_IsRefused) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  const std::string command =
      "'" BURNISH_PROGRAM
      "' polish --surface table --controller mpc --plant ideal --duration 60 "
      "--force --no-page --quiet --out " +
      quoted(out);
  // The second run is refused. The first one is killed and leaves an unfinished run.
  const Outcome outcome =
      shell(command + " >/dev/null 2>&1 & pid=$!; until [ -e " + quoted(out / ".burnish") +
            " ]; do kill -0 $pid || exit 9; done; " + command +
            "; code=$?; kill -KILL $pid; { wait $pid; } 2>/dev/null; exit $code");
  expect_refused(outcome, "another run writes into '" + out.string() + "'");
  const std::string again = "polish" + quick_polish + "--out " + quoted(out);
  expect_refused(run(again), "holds a run that did not finish; wanted another folder");
  EXPECT_EQ(run(again + " --force").exit_code, 0);
  EXPECT_FALSE(fs::exists(out / "table_mpc"));
  EXPECT_TRUE(fs::exists(out / "table_baseline"));
}

/// Runs burnish where files cannot grow beyond `blocks` blocks of 512 bytes, which imitates a full
/// disk.
Outcome run_short_of_disk(int blocks, const std::string& arguments) {
  return shell("trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; '" BURNISH_PROGRAM "' " +
               arguments);
}

TEST(RunFolder, PolishOnAFullDisk_PrintsTheTableAndLeavesNoPartialFile) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  const Outcome outcome = run_short_of_disk(
      64, "polish" + quick_polish + "--seed 1 --seed 2 --record-every 1 --out " + quoted(out));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.out.find("table_baseline_seed1"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("table_baseline_seed2"), std::string::npos) << outcome.out;
  EXPECT_EQ(lines_of(outcome.err), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("trace.csv': File too large"), std::string::npos) << outcome.err;
  for (const auto& entry : fs::recursive_directory_iterator(out))
    EXPECT_TRUE(entry.is_directory() || entry.path().filename() == ".burnish") << entry.path();
  EXPECT_EQ(contents(out / ".burnish").rfind("failed", 0), 0U) << contents(out / ".burnish");
  expect_refused(run("polish" + quick_polish + "--out " + quoted(out)), "did not finish");
}

TEST(RunFolder, SecondInterrupt_MarksTheFolderAsNotRunning) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  shell("'" BURNISH_PROGRAM
        "' polish --surface table --controller mpc --plant ideal --duration 60 --no-page --quiet "
        "--out " +
        quoted(out) + " & pid=$!; until grep -q running " + quoted(out / ".burnish") +
        " 2>/dev/null; do kill -0 $pid || exit 9; done; kill -TERM $pid; kill -TERM $pid; wait "
        "$pid");
  const std::string mark = contents(out / ".burnish");
  EXPECT_NE(mark.rfind("running", 0), 0U) << mark;
}

TEST(Output, FullDisk_IsOneSentence) {
  const Outcome full = shell("'" BURNISH_PROGRAM "' show arm7 > /dev/full");
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(full.err, "burnish: the output could not be written: No space left on device\n");
}

TEST(Output, OutputBeyondTheFileSize_IsRemoved) {
  const Scratch scratch;
  const fs::path file = scratch.folder / "table.txt";
  const Outcome outcome =
      shell("trap '' XFSZ; ulimit -f 2; '" BURNISH_PROGRAM "' show talos > " + quoted(file));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("the output could not be written: File too large"), std::string::npos)
      << outcome.err;
  EXPECT_EQ(contents(file), "");
}

TEST(RunFolder, SolveOnAFullDisk_PrintsTheSummaryAndFails) {
  const Scratch scratch;
  const fs::path file = scratch.write("swing.yaml", small_problem);
  const Outcome outcome = run_short_of_disk(
      2, "solve " + quoted(file) + " --quiet --out " + quoted(scratch.folder / "out"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.out.find("converged"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("': File too large"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace burnish::testing
