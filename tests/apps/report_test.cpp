// Tests of the pages of runs: burnish polish, burnish report and burnish show --html.
#include <algorithm>
#include <map>

#include "apps/program.hpp"
#include "record/page_data.hpp"

namespace burnish::testing {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

#ifdef BURNISH_HAS_PAGE
constexpr bool has_page = true;
#else
constexpr bool has_page = false;
#endif

const std::string moment =
    " --surface table --plant ideal --duration 0.6 --set path.start_up=0.2"
    " --set phases.reach_duration=0.2 --set verdict.force_rmse=never";

/// Returns the data of a page.
Json data_of(const fs::path& page) {
  const std::string html = contents(page), before = "id=\"burnish-data\">";
  const std::size_t at = html.find(before);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + before.size();
  return Json::parse(html.substr(begin, html.find("</script>", begin) - begin));
}

/// Returns the rows of trace.csv by their time; each row has its values by the column's name.
std::map<float, std::map<std::string, double>> rows_of(const fs::path& file) {
  std::istringstream lines(contents(file));
  std::map<float, std::map<std::string, double>> rows;
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<std::string> row;
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
    if (names.empty()) {
      for (const std::string& name : row) names.push_back(name.substr(0, name.find(' ')));
      continue;
    }
    auto& values = rows[std::stof(row.at(0))];
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i]] = std::stod(row.at(i));
  }
  return rows;
}

TEST(RunPages, Page_EqualsTheTraceAndTheMetrics) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const Outcome outcome =
      run("polish" + moment + " --controller mpc --record-every 4 --mcap --out " + quoted(out) +
          " --set 'disturbances.surface_tilt_deg=[2, 0]'");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const fs::path folder = out / "table_mpc";
  for (const char* name : {"run.json", "run.mcap"}) {
    EXPECT_TRUE(fs::exists(folder / name)) << name;
    EXPECT_NE(outcome.out.find(name), std::string::npos) << outcome.out;
  }
  EXPECT_FALSE(fs::exists(out / "comparison.html"));
  EXPECT_EQ(fs::exists(folder / "run.html"), has_page);
  const Json page = Json::parse(contents(folder / "run.json"));
  if (has_page) {
    EXPECT_EQ(data_of(folder / "run.html"), page);
  }
  EXPECT_EQ(page["format"], "burnish-page/1");
  const Json& made = page["runs"][0];
  EXPECT_EQ(made["name"], "table_mpc");
  EXPECT_EQ(made["task_file"].get<std::string>(), contents(folder / "task.yaml"));

  const auto rows = rows_of(folder / "trace.csv");
  const Json& columns = made["series"]["columns"];
  const std::vector<float> time = floats_of(made["series"]["time"]);
  EXPECT_EQ(time.size(), rows.size());
  const std::map<std::string, std::string> same{{"tool_x", "tool_x_world"},
                                                {"force_target", "target_force"},
                                                {"in_contact", "in_contact"},
                                                {"q_torso_1_joint", "q_torso_1_joint"},
                                                {"tau_torso_2_joint", "tau_applied_torso_2_joint"}};
  for (const auto& [ours, theirs] : same) {
    const std::vector<float> values = floats_of(named(columns, ours)["data"]);
    for (std::size_t i = 0; i < time.size(); ++i) {
      ASSERT_TRUE(rows.contains(time[i])) << time[i];
      EXPECT_EQ(values[i], static_cast<float>(rows.at(time[i]).at(theirs))) << ours << i;
    }
  }
  // The force is along the normal of the plate, which the disturbance tilts.
  const Json& axes = made["surface"]["true_axes"];
  EXPECT_LT(axes[8].get<double>(), 0.9999);
  EXPECT_EQ(made["surface"]["axes"][8], 1);
  const std::vector<float> force = floats_of(named(columns, "force_normal")["data"]);
  for (std::size_t i = 0; i < time.size(); i += 10) {
    double along = 0.0;
    for (const int k : {0, 1, 2})
      along += axes[6 + static_cast<std::size_t>(k)].get<double>() *
               rows.at(time[i]).at(std::string("tool_force_") + "xyz"[k] + "_world");
    EXPECT_NEAR(force[i], along, 1e-4);
  }
  EXPECT_GT(floats_of(made["horizon"]["q"]).size(), 21U * 6U * 10U);
  EXPECT_GT(floats_of(named(made["costs"]["terms"], "position")["value"]).front(), 0.0F);
  const Json metrics = Json::parse(contents(folder / "metrics.json"))["metrics"];
  EXPECT_EQ(named(made["metrics"], "force_rmse")["value"], metrics["force_rmse_N"]);
}

TEST(RunPages, CommandOnThePage_ReproducesTheRun) {
  const Scratch scratch;
  const auto first = scratch.folder / "first", second = scratch.folder / "second";
  ASSERT_EQ(
      run("polish" + moment +
          " --controller baseline --set 'surface.normal=[0, 0.1, 1]' --seed 3 --quiet --out " +
          quoted(first))
          .exit_code,
      0);
  const Json page = Json::parse(contents(first / "tilt_6_baseline" / "run.json"));
  const std::string command = page["runs"][0]["command"];
  const std::string program = "burnish ";
  ASSERT_EQ(command.rfind(program, 0), 0U) << command;
  ASSERT_EQ(run(command.substr(program.size()) + " --quiet --out " + quoted(second)).exit_code, 0);
  EXPECT_EQ(contents(first / "tilt_6_baseline" / "trace.csv"),
            contents(second / "tilt_6_baseline" / "trace.csv"));
}

TEST(RunPages, NoPageOption_RemovesPagesOfTheEarlierRun) {
  const Scratch scratch;
  const auto out = scratch.folder / "out";
  const std::string what = "polish --controller baseline --seed 1 --seed 2 --out " + quoted(out);
  ASSERT_EQ(run(what + moment).exit_code, 0);
  EXPECT_EQ(fs::exists(out / "comparison.html"), has_page);
  EXPECT_TRUE(fs::exists(out / "table_baseline_seed1" / "run.json"));
  // The next run removes the pages of an earlier one.
  ASSERT_EQ(run(what + moment + " --force --no-page").exit_code, 0);
  for (const char* name : {"run.json", "run.html", "run.mcap"})
    EXPECT_FALSE(fs::exists(out / "table_baseline_seed1" / name)) << name;
  EXPECT_FALSE(fs::exists(out / "comparison.html"));
}

TEST(RunPages, BuildWithoutThePage_IsReportedOnce) {
  if (has_page) GTEST_SKIP() << "this build has the page";
  const Scratch scratch;
  const Outcome outcome = run("polish --controller baseline --seed 1 --seed 2 --out " +
                              quoted(scratch.folder / "out") + moment);
  EXPECT_EQ(outcome.exit_code, 0);
  const std::string words = "no run.html: ";
  const std::size_t at = outcome.out.find(words);
  EXPECT_NE(at, std::string::npos) << outcome.out;
  EXPECT_EQ(outcome.out.find(words, at + 1), std::string::npos);
  expect_refused(run("show pendulum --html " + quoted(scratch.folder / "p.html")),
                 "without the web page of runs");
}

TEST(ReportCommand, TwoRuns_AreWrittenToOnePage) {
  if (!has_page) GTEST_SKIP() << "this build has no page";
  const Scratch scratch;
  for (const std::string force : {"20", "30"})
    ASSERT_EQ(run("polish --controller baseline --quiet --set force=" + force + moment + " --out " +
                  quoted(scratch.folder / force))
                  .exit_code,
              0);
  const auto file = scratch.folder / "both.html";
  const Outcome outcome = run("report " + quoted(scratch.folder / "20" / "table_baseline") + " " +
                              quoted(scratch.folder / "30") + " --out " + quoted(file));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("2 runs in ", 0), 0U) << outcome.out;
  const Json page = data_of(file);
  ASSERT_EQ(page["runs"].size(), 2U);
  EXPECT_EQ(page["title"], "20/table_baseline, 30/table_baseline");
  EXPECT_EQ(page["runs"][0]["name"], "20/table_baseline");
  Json alone = Json::parse(contents(scratch.folder / "30" / "table_baseline" / "run.json"));
  alone["runs"][0]["name"] = "30/table_baseline";
  EXPECT_EQ(page["runs"][1], alone["runs"][0]);
  const Outcome whole =
      run("report " + quoted(scratch.folder) + " --out " + quoted(scratch.folder / "all.html"));
  EXPECT_EQ(whole.out.rfind("2 runs in ", 0), 0U)
      << "runs in folders of any depth: " << whole.out << whole.err;
}

TEST(ReportCommand, BadInput_IsRefusedInOneSentence) {
  const Scratch scratch;
  const auto refused = [&](const std::string& arguments, const std::string& words) {
    expect_refused(run("report --out " + quoted(scratch.folder / "page.html") + " " + arguments),
                   words);
  };
  refused(quoted(scratch.folder / "nowhere"), "does not exist");
  refused(quoted(scratch.folder), "holds no run");
  refused(quoted(scratch.write("broken.json", "{\"format\": ")), "it is not a JSON object");
  refused(quoted(scratch.write("other.json", "{\"some\": 1}")), "the key 'format' is missing");
  refused(quoted(scratch.write("newer.json", R"({"format": "burnish-page/2", "runs": []})")),
          "has the format 'burnish-page/2'; wanted 'burnish-page/1'");
  refused(quoted(scratch.write("empty.json", R"({"format": "burnish-page/1", "runs": []})")),
          "holds no run");
  refused(quoted(scratch.write("odd.json", R"({"format": "burnish-page/1", "runs": [3]})")),
          "holds a run without the key 'name' or 'series'");
  refused("", "RUN");
  EXPECT_FALSE(fs::exists(scratch.folder / "page.html"));
}

TEST(ReportCommand, RunOfVersion03_HasTodaysNames) {
  if (!has_page) GTEST_SKIP() << "this build has no page";
  const Scratch scratch;
  const auto old_run = scratch.write(
      "run.json",
      R"({"format": "burnish-page/1", "runs": [{"name": "lean", "series": {"columns":)"
      R"( [{"name": "believed_normal_x"}, {"name": "tau_elbow"}]}, "envelopes": {"columns":)"
      R"( [{"name": "limits_pushing"}]}, "metrics": [{"name": "solver.limits_outside"},)"
      R"( {"name": "lean"}], "phases": [{"name": "lean"}], "outcome": "lean", "polished": true,)"
      R"( "facts": [["robot", "talos"], ["task", "push_wall"]], "tool": {"frame": "tool"}}]})");
  const auto file = scratch.folder / "page.html";
  const Outcome outcome = run("report " + quoted(old_run) + " --out " + quoted(file));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json page = data_of(file);
  const Json& run_data = page["runs"][0];
  EXPECT_EQ(run_data["series"]["columns"][0]["name"], "estimated_normal_x");
  EXPECT_EQ(run_data["series"]["columns"][1]["name"], "tau_elbow");
  EXPECT_EQ(run_data["envelopes"]["columns"][0]["name"], "active_constraints");
  EXPECT_EQ(run_data["metrics"][0]["name"], "solver.constraint_violation");
  EXPECT_EQ(run_data["metrics"][1]["name"], "com_displacement");
  EXPECT_EQ(run_data["phases"][0]["name"], "force_search");
  EXPECT_EQ(run_data["name"], "lean") << "the name of a run stays";
  EXPECT_EQ(run_data["outcome"], "lean");
  EXPECT_EQ(run_data["succeeded"], true);
  EXPECT_FALSE(run_data.contains("polished"));
  EXPECT_EQ(run_data["tool"]["frame"], "") << "both hands press; neither is a tool";
}

TEST(ShowHtml, RobotWithAMissingMesh_IsDrawnAndTheMeshNamed) {
  if (!has_page) GTEST_SKIP() << "this build has no page";
  const Scratch scratch;
  fs::create_directories(scratch.folder / "parts" / "meshes");
  scratch.write("parts/meshes/facet.stl",
                "solid facet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                "vertex 0 1 0\nendloop\nendfacet\nendsolid facet\n");
  const std::string visual = "<visual><geometry><mesh filename=\"package://parts/meshes/",
                    end = "\" scale=\"0.5 1 1\"/></geometry></visual>";
  const fs::path urdf = scratch.write(
      "parts/arm.urdf",
      "<robot name=\"arm\"><link name=\"base\"/><link name=\"tip\"><inertial><mass value=\"1\"/>"
      "<inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>" +
          visual + "facet.stl" + end + visual + "gone.stl" + end +
          "</link><joint name=\"hinge\" type=\"continuous\"><parent link=\"base\"/>"
          "<child link=\"tip\"/><axis xyz=\"0 0 1\"/></joint></robot>");
  const auto file = scratch.folder / "arm.html";
  const Outcome outcome = run("show " + quoted(urdf) + " --html " + quoted(file));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("gone.stl"), std::string::npos) << outcome.out;
  const Json page = data_of(file);
  EXPECT_EQ(page["kind"], "robot");
  EXPECT_EQ(page["title"], "arm");
  const Json& visuals = page["robot"]["visuals"];
  EXPECT_EQ(visuals[1]["shape"], Json::parse(R"({"kind": "mesh", "name": "gone.stl"})"));
#ifdef BURNISH_HAS_ASSIMP
  EXPECT_EQ(outcome.out.find("facet.stl"), std::string::npos);
  const std::vector<float> vertices = floats_of(visuals[0]["shape"]["vertices"]);
  EXPECT_EQ(vertices.size(), 9U);
  EXPECT_EQ(*std::max_element(vertices.begin(), vertices.end()), 1.0F);  // along y; x is halved
  EXPECT_EQ(std::count(vertices.begin(), vertices.end(), 0.5F), 1);
#else
  EXPECT_FALSE(visuals[0]["shape"].contains("vertices"));
#endif
  expect_refused(run("show pendulum --html /nowhere/at/all.html"), "cannot write");
}

}  // namespace
}  // namespace burnish::testing
