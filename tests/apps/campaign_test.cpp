// Tests of shards, merge and resume: their files equal those of one process, no run is repeated.
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

const std::string paper = "experiment paper --quick --quiet --surface table --plant ideal ";
const std::string seeds = "experiment seeds --quick --quiet --seeds 3 --plant ideal ";

std::string to(const fs::path& folder) { return " --out " + quoted(folder); }

bool is_timing(const fs::path& file) { return file.filename().string().ends_with(".times.json"); }

/// Returns the contents of a folder's files by name, without the measured times.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && !is_timing(entry.path()))
      files[entry.path().filename().string()] = contents(entry.path());
  return files;
}

/// Returns the files of a report: all files but the folder's marker and campaign.json.
std::map<std::string, std::string> report_in(const fs::path& folder) {
  std::map<std::string, std::string> files = files_in(folder);
  files.erase(".burnish");
  files.erase("campaign.json");
  return files;
}

TEST(Campaign, MergedShards_EqualTheFilesOfOneProcess) {
  for (const std::string& experiment : {paper, seeds}) {
    const Scratch scratch;
    const fs::path one = scratch.folder / "one", merged = scratch.folder / "merged";
    ASSERT_EQ(run(experiment + to(one)).exit_code, 0);
    std::string folders;
    std::map<std::string, std::string> results;
    for (const char* number : {"1", "2", "3"}) {
      const fs::path folder = scratch.folder / number;
      ASSERT_EQ(run(experiment + "--threads 1 --shard " + number + "/3" + to(folder)).exit_code, 0);
      EXPECT_FALSE(fs::exists(folder / "results.md"));
      for (const auto& [name, text] : files_in(folder / "runs"))
        EXPECT_TRUE(results.emplace(name, text).second) << name << " was made twice";
      folders += " " + quoted(folder);
    }
    const Outcome outcome = run("merge" + folders + to(merged));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("results.csv"), std::string::npos);
    // The report may lie beside the runs; --force then finds only files of the program there.
    const fs::path first = scratch.folder / "1";
    for (const char* number : {"2", "3"})
      fs::copy(scratch.folder / number / "runs", first / "runs",
               fs::copy_options::overwrite_existing | fs::copy_options::recursive);
    for (int time = 0; time < 2; ++time)
      EXPECT_EQ(run("merge --quiet " + quoted(first) + to(first)).exit_code, 0);
    EXPECT_TRUE(report_in(first) == report_in(one));
    EXPECT_EQ(run(experiment + "--force" + to(first)).exit_code, 0);
    EXPECT_TRUE(results == files_in(one / "runs"));
    EXPECT_TRUE(report_in(merged) == report_in(one));
    EXPECT_GE(report_in(merged).size(), 4U);
  }
}

TEST(Campaign, ResumedExperiment_RepeatsNoFinishedRun) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  const std::string shard =
      "experiment seeds --quick --seeds 3 --plant ideal --shard 1/2 --resume" + to(out);
  const Outcome first = run(shard);
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.out.find("2 of 2 runs, 2 new and 0 from before"), std::string::npos) << first.out;
  EXPECT_NE(run(shard).out.find("0 new and 2 from before"), std::string::npos);
  for (const auto& [name, text] : files_in(out / "runs")) {
    fs::remove(out / "runs" / name);
    break;
  }
  EXPECT_NE(run(shard).out.find("1 new and 1 from before"), std::string::npos);
  // The whole experiment reuses the runs of the shard, and so do more seeds.
  const Outcome all = run(seeds + "--resume" + to(out));
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(files_in(out / "runs").size(), 3U);
  EXPECT_EQ(
      run("experiment seeds --quick --quiet --seeds 4 --plant ideal --resume" + to(out)).exit_code,
      0);
  EXPECT_EQ(files_in(out / "runs").size(), 4U);
}

TEST(Campaign, InterruptedExperiment_ResumesToTheSameFiles) {
  const Scratch scratch;
  const fs::path one = scratch.folder / "one", out = scratch.folder / "out";
  const std::string command =
      "experiment seeds --quick --quiet --seeds 6 --threads 1 --plant ideal";
  ASSERT_EQ(run(command + to(one)).exit_code, 0);
  // The first process is interrupted, the second one killed, each after some results.
  for (const auto& [signal, count] : {std::pair("INT", 1), std::pair("KILL", 3)}) {
    const Outcome outcome =
        shell("'" BURNISH_PROGRAM "' " + command + " --resume" + to(out) +
              " >/dev/null 2>&1 & pid=$!; until [ $(ls " + quoted(out / "runs") +
              "/*[0-9a-f].json 2>/dev/null | grep -vc times) -ge " + std::to_string(count) +
              " ]; do kill -0 $pid || exit 9; done; kill -" + signal +
              " $pid; { wait $pid; } 2>/dev/null; true");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_LT(files_in(out / "runs").size(), 6U) << signal;
  }
  EXPECT_EQ(run(command + " --resume" + to(out)).exit_code, 0);
  EXPECT_TRUE(files_in(out / "runs") == files_in(one / "runs"));
  EXPECT_TRUE(report_in(out) == report_in(one));
}

TEST(Campaign, List_HasNumberKeyAndNameOfEachRun) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  const std::string list = run("experiment seeds --quick --seeds 3 --plant ideal --list").out;
  EXPECT_TRUE(
      std::regex_match(list, std::regex("1\t[0-9a-f]{32}\tseed 0\n2\t.*\tseed 1\n3\t.*\tseed 2\n")))
      << list;
  ASSERT_EQ(run(seeds + "--shard 2/3" + to(out)).exit_code, 0);
  EXPECT_NE(list.find(fs::path(files_in(out / "runs").begin()->first).stem().string()),
            std::string::npos);
}

TEST(Campaign, RobotsOfAFolder_AreShardedAndResumed) {
  const Scratch scratch;
  scratch.write("checkouts/arm7.urdf", contents(BURNISH_ROBOTS_DIR "/arm7/arm7.urdf"));
  scratch.write("checkouts/robots.yaml", "arms: {Seven: {file: arm7.urdf, tool: flange}}");
  const std::string command = "experiment robots --quick --plant ideal --folder " +
                              quoted(scratch.folder / "checkouts") + " ";
  const std::string list = run(command + "--list").out;
  EXPECT_TRUE(std::regex_search(list, std::regex("2\t[0-9a-f]{32}\tSeven, table, mismatch, "
                                                 "baseline, seed 0\n")))
      << list;
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 6);
  const fs::path out = scratch.folder / "out";
  const std::string shard = command + "--shard 2/6 --resume" + to(out);
  const Outcome first = run(shard);
  EXPECT_EQ(first.exit_code, 0) << first.out << first.err;
  EXPECT_NE(run(shard).out.find("0 new and 1 from before"), std::string::npos);
  EXPECT_NE(list.find(fs::path(files_in(out / "runs").begin()->first).stem().string()),
            std::string::npos);
}

TEST(Campaign, IncompatibleShards_AreRefusedByMerge) {
  const Scratch scratch;
  const fs::path first = scratch.folder / "first", second = scratch.folder / "second",
                 other = scratch.folder / "other", merged = scratch.folder / "merged";
  ASSERT_EQ(run(seeds + "--shard 1/2" + to(first)).exit_code, 0);
  ASSERT_EQ(run(seeds + "--shard 2/2" + to(second)).exit_code, 0);
  ASSERT_EQ(run(seeds + "--set force=20 --shard 2/2" + to(other)).exit_code, 0);
  const auto refused = [&](const std::string& folders, const std::string& words) {
    expect_refused(run("merge " + folders + to(merged)), words);
    EXPECT_FALSE(fs::exists(merged));
  };
  refused(quoted(first),
          "1 of 3 runs are missing, the first is 'seed 1' (number 2); wanted "
          "all shards, each with all of its runs (no folder holds 2/2)");
  refused(quoted(first) + " " + quoted(other),
          "'" + other.string() +
              "' holds runs of `burnish experiment seeds --seeds 3 --plant "
              "ideal --quick --set force=20`, but '" +
              first.string() + "' holds runs of");
  refused(quoted(scratch.folder), "holds no runs of an experiment: it has no file campaign.json");
  const auto replace = [](const fs::path& file, const std::string& what, const std::string& by) {
    const std::string text = std::regex_replace(contents(file), std::regex(what), by);
    std::ofstream(file) << text;
  };
  replace(second / "campaign.json", BURNISH_VERSION, "0.1.7");
  refused(quoted(first) + " " + quoted(second), "'" + second.string() +
                                                    "' holds runs of burnish "
                                                    "0.1.7, but this is burnish " BURNISH_VERSION);
  replace(second / "campaign.json", "0.1.7", BURNISH_VERSION);
  for (const auto& entry : fs::directory_iterator(second / "runs"))
    if (is_timing(entry.path()))
      replace(entry.path(), "\"kernels\": \"[^\"]*\"", "\"kernels\": \"MMX\"");
  refused(quoted(first) + " " + quoted(second), "kernels for different processors");
  const Outcome mixed = run("merge --mixed " + quoted(first) + " " + quoted(second) + to(merged));
  EXPECT_EQ(mixed.exit_code, 0) << mixed.err;
  EXPECT_NE(contents(merged / "results.md").find("1 with MMX"), std::string::npos);
  // A folder that is resumed must hold runs of the same experiment.
  expect_refused(run(seeds + "--set force=20 --shard 1/2 --resume" + to(first)),
                 "wanted these options (only --seeds and --first-seed may differ)");
}

TEST(Campaign, BadArguments_AreRefusedInOneSentence) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  for (const char* shard : {"0/4", "5/4", "2", "2/4x", "a/b", "-1/2"})
    expect_refused(run(seeds + "--shard " + std::string(shard) + to(out)),
                   "wanted I/N, part I of N parts, such as 2/4");
  expect_refused(run("experiment tick --shard 1/2" + to(out)), "wanted none of --shard");
  expect_refused(run(seeds + "--resume"),
                 "--resume needs a folder to continue in; wanted --out DIR");
  expect_refused(run(seeds + "--resume --force" + to(out)), "wanted one of them");
  expect_refused(run(seeds + "--time-limit -1" + to(out)), "--time-limit");
  expect_refused(run(seeds + "--scheduler tcp://a:1 --shard 1/2" + to(out)),
                 "wanted none of --shard");
  expect_refused(run("experiment tick --scheduler tcp://a:1"),
                 "wanted none of --shard, --scheduler");
  expect_refused(run("merge"), "SHARD is required");
  for (const char* command : {"sweep", "tune"}) expect_refused(run(command), "FILE is required");
  EXPECT_FALSE(fs::exists(out));
}

TEST(Campaign, FullDisk_IsOneSentenceAndLeavesNoPartialResult) {
  const Scratch scratch;
  const fs::path out = scratch.folder / "out";
  // Files cannot grow beyond two blocks of 512 bytes, which is less than a result needs.
  const Outcome outcome =
      shell("trap '' XFSZ; ulimit -f 2; '" BURNISH_PROGRAM "' " + seeds + "--threads 1" + to(out));
  expect_refused(outcome, "cannot write '" + (out / "runs").string());
  for (const auto& entry : fs::directory_iterator(out / "runs"))
    EXPECT_TRUE(is_timing(entry.path())) << entry.path();
  EXPECT_EQ(run(seeds + "--resume" + to(out)).exit_code, 0);
}

}  // namespace
}  // namespace burnish::testing
