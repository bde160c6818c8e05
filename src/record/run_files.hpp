// Files in the folder of a run, common to all tasks: tables, figures, the task, plots, page,
// recording and the fault report.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "burnish/mpc/fault.hpp"
#include "burnish/report/svg_plot.hpp"
#include "burnish/robots/robot.hpp"
#include "record/page_files.hpp"

namespace burnish {

/// Options for the files of a run.
struct RunFilesOptions {
  int record_every = 10;  ///< Plant steps between two rows of trace.csv
  bool plots = false;     ///< Write plots as SVG files even if there is a page
};

/// Name of an SVG file and the function that makes its plot. A plot without panels is not written.
using PlotFile = std::pair<std::string, std::function<PlotSpec()>>;

/// Data for the files of a run. The functions are called only if a file needs them.
struct RunFiles {
  const Trace& trace;
  const FaultReport& fault;
  nlohmann::ordered_json figures;  ///< Content of metrics.json
  std::string task_file;           ///< Content of task.yaml
  std::vector<PlotFile> plots;
  std::function<RunPage()> page;
};

/// Writes trace.csv, metrics.json, task.yaml, and the files of `pages`. Writes the plots if
/// requested or if there is no page. After a fault, writes fault.txt and last_second.csv. Returns
/// the names of the files. Throws Error if a file cannot be written or if `record_every` is below
/// 1.
std::vector<std::string> write_run_files(const RunFiles& run, const RunFilesOptions& options,
                                         const std::filesystem::path& folder, PageWriter& pages);

/// Returns kind, time and values of a fault as JSON; null without a fault.
nlohmann::ordered_json fault_json(const FaultReport& fault);
/// Returns the fault for the page; empty without a fault.
std::optional<PageFault> page_fault(const FaultReport& fault);
/// Returns a robot at q with its postures and meshes. `name` is the robot's name for load_robot();
/// mesh_folders() derives the folders of the meshes from this name.
RobotDrawing drawing_of(const Robot& robot, const std::string& name, const Eigen::VectorXd& q);

}  // namespace burnish
