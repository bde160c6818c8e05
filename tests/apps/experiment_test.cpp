// Tests of the command burnish experiment: files, exit codes, bad input, Ctrl-C.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/program.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;

TEST(Experiment, Seeds_WriteTablesFiguresAndNumbers) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const Outcome outcome =
      run("experiment seeds --quick --seeds 2 --set force=20 --threads 2 --out " + quoted(out));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_EQ(outcome.err, "");  // no progress bar: standard error is not a terminal
  const std::string text = contents(out / "results.md");
  EXPECT_EQ(outcome.out.rfind(text, 0), 0U);
  for (const char* words :
       {"# All disturbances at once", "`burnish experiment seeds --seeds 2 --quick --set ",
        "0 of 2 runs diverged", "| force_rmse [N]"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  const Json json = Json::parse(contents(out / "results.json"));
  EXPECT_EQ(json["experiment"], "seeds");
  EXPECT_EQ(json["failures"].size(), 0U);
  const Json& table = json["tables"][0];
  ASSERT_EQ(table["rows"].size(), 2U);
  EXPECT_EQ(table["rows"][0].size(), table["columns"].size());
  const std::string csv = contents(out / "results.csv");
  EXPECT_EQ(csv.rfind("seed,surface,diverged,", 0), 0U) << csv;
  EXPECT_NE(csv.find("force_rmse [N]"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_EQ(contents(out / "distributions.svg").rfind("<svg ", 0), 0U);
  EXPECT_NE(contents(out / "worst_seed.yaml").find("\nforce: 20 "), std::string::npos);
}

TEST(Experiment, SameArguments_GiveTheSameFilesOnAnyThreads) {
  const Scratch scratch;
  const auto results = [&](const std::string& name, const std::string& threads) {
    const auto out = scratch.folder / name;
    EXPECT_EQ(run("experiment paper --quick --quiet --surface table --plant ideal --threads " +
                  threads + " --out " + quoted(out))
                  .exit_code,
              0);
    return contents(out / "results.md") + contents(out / "results.json") +
           contents(out / "results.csv") + contents(out / "force_and_path.svg");
  };
  const std::string once = results("one", "1"), again = results("two", "3");
  EXPECT_GT(once.size(), 5000U);
  EXPECT_EQ(once, again);
}

TEST(Experiment, FailedRun_GivesExitCodeOne) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const Outcome outcome =
      run("experiment seeds --quick --seeds 1 --set limits.tool_speed=0.005 --out " + quoted(out));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("speed limit"), std::string::npos) << outcome.out;
  EXPECT_EQ(Json::parse(contents(out / "results.json"))["failures"].size(), 1U);
}

TEST(Experiment, BadInput_IsRefusedInOneSentence) {
  const Scratch scratch;
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    expect_refused(run("experiment --out " + quoted(scratch.folder / "out") + " " + arguments),
                   words);
  };
  refused("papers", "did you mean 'paper'?");
  refused("paper --surface tabl", "did you mean 'table'?");
  refused("paper --set forse=3", "did you mean 'force'?");
  refused("paper --seeds 0", "--seeds");
  refused("paper --plant gazebo", "--plant");
  refused("paper --fast", "unknown argument '--fast'");
  refused("paper --folder /tmp", "--folder is for the experiment 'robots', not for 'paper'");
  refused("robots --folder /tmp --robot arm7", "wanted --folder without --robot and --tool");
  refused("robots --folder " + quoted(scratch.folder / "none"), "wanted a folder of robot");
  expect_refused(run("experiment"), "EXPERIMENT is required");
  EXPECT_FALSE(std::filesystem::exists(scratch.folder / "out"));
}

TEST(Experiment, Help_NamesEveryExperiment) {
  const Outcome outcome = run("experiment --help");
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* name : {"paper", "orientation", "frames", "seeds", "tick", "--quick"})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
}

TEST(Experiment, Interrupt_EndsTheRunsAndWritesTheResults) {
  const Scratch scratch;
  const auto out = scratch.folder / "out", output = scratch.folder / "output";
  const std::string script = "'" BURNISH_PROGRAM "' experiment seeds --plant ideal --out " +
                             quoted(out) + " >" + quoted(output) + " 2>&1 & pid=$!; until [ -d " +
                             quoted(out) +
                             " ]; do kill -0 $pid || exit 9; done; sleep 0.3; kill -INT $pid; "
                             "wait $pid";
  const int status = std::system(script.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1) << contents(output);
  const Json json = Json::parse(contents(out / "results.json"));
  EXPECT_TRUE(json["interrupted"].get<bool>());
  EXPECT_NE(contents(out / "results.md").find("Interrupted"), std::string::npos);
}

}  // namespace
}  // namespace burnish::testing
