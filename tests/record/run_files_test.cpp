// Tests of the files that a run of any task writes into its folder.
#include "record/run_files.hpp"

#include <gtest/gtest.h>

#include "record/figures_json.hpp"
#include "record/mesh_file.hpp"
#include "record/page_data.hpp"
#include "support/refusal.hpp"
#include "support/scratch.hpp"

namespace burnish::testing {
namespace {

namespace fs = std::filesystem;

/// A run without a task.
struct MadeUpRun {
  Trace trace = page_trace(page_model(), 100);
  FaultReport fault = {};

  std::vector<std::string> write(const fs::path& folder, const RunFilesOptions& options,
                                 bool with_page) const {
    PageWriter pages(with_page, false);
    return write_run_files(
        {.trace = trace,
         .fault = fault,
         .figures = {{"fault", fault_json(fault)}, {"metrics", metrics_json(Metrics{})}},
         .task_file = "kind: made up\n",
         .plots = {{"plot.svg",
                    [] {
                      return PlotSpec{.panels = {{.curves = {{.x = Eigen::Vector2d(0, 1),
                                                              .y = Eigen::Vector2d(0, 1)}}}}};
                    }},
                   {"nothing.svg", [] { return PlotSpec{}; }}},
         .page = [] { return page_of_run(100); }},
        options, folder, pages);
  }
};

TEST(RunFiles, AnyTask_WritesTraceMetricsTaskAndPlots) {
  const Scratch scratch;
  const std::vector<std::string> names =
      MadeUpRun{}.write(scratch.folder / "run", {.record_every = 7}, false);
  EXPECT_EQ(names,
            (std::vector<std::string>{"trace.csv", "metrics.json", "task.yaml", "plot.svg"}));
  EXPECT_EQ(contents(scratch.folder / "run" / "task.yaml"), "kind: made up\n");
  const std::string table = contents(scratch.folder / "run" / "trace.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 15 + 1)
      << "expected every 7th row and the last";
  const Json figures = Json::parse(contents(scratch.folder / "run" / "metrics.json"));
  EXPECT_TRUE(figures["fault"].is_null());
  EXPECT_EQ(figures["metrics"]["position_rmse_m"], 0.0);
  EXPECT_TRUE(figures["metrics"]["overshoot_N"].is_null());
  EXPECT_FALSE(figures["metrics"].contains("solver"));
}

TEST(MeshFolders, LocalFolder_DoesNotHideALibraryRobot) {
  const Scratch scratch;
  scratch.write("arm7/robot.yaml", "urdf: arm7.urdf\n");
  const fs::path before = fs::current_path();
  fs::current_path(scratch.folder);
  for (const fs::path& folder : mesh_folders("arm7"))
    EXPECT_EQ(folder.parent_path().filename(), "robots") << folder;
  EXPECT_EQ(mesh_folders("./arm7"),
            std::vector<fs::path>{fs::weakly_canonical(fs::current_path() / "arm7")});
  EXPECT_TRUE(mesh_folders("nowhere").empty());
  EXPECT_FALSE(mesh_folders("arm7").empty());
  fs::current_path(before);
}

TEST(RunFiles, Plots_AreWrittenWithoutAPageOrOnRequest) {
  const Scratch scratch;
  const fs::path plot = scratch.folder / "plot.svg";
  MadeUpRun{}.write(scratch.folder, {.plots = true}, true);
  EXPECT_TRUE(fs::exists(plot));
  MadeUpRun{}.write(scratch.folder, {}, true);
  EXPECT_NE(fs::exists(plot), fs::exists(scratch.folder / "run.html"))
      << "an old plot must be removed";
}

TEST(RunFiles, Fault_IsWrittenAndRemovedByTheNextRun) {
  const Scratch scratch;
  MadeUpRun run;
  run.fault.kind = FaultKind::SpeedLimit;
  run.fault.time = 0.25;
  run.fault.last_second = run.trace;
  const auto names = run.write(scratch.folder, {}, false);
  EXPECT_EQ(names.back(), "last_second.csv");
  EXPECT_EQ(contents(scratch.folder / "fault.txt"), run.fault.text() + "\n");
  EXPECT_EQ(fault_json(run.fault)["kind"], "speed limit");
  EXPECT_EQ(fault_json(run.fault)["time_s"], 0.25);
  MadeUpRun{}.write(scratch.folder, {}, false);
  EXPECT_FALSE(fs::exists(scratch.folder / "fault.txt")) << "the file of the previous run remains";
  expect_words(refusal([&] { run.write(scratch.folder, {.record_every = 0}, false); }),
               {"record_every is 0", "wanted at least 1"});
}

}  // namespace
}  // namespace burnish::testing
