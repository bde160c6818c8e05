// What a run leaves in its folder, whatever its task: tables, figures, the task, its plots, page
// and recording, and what is known of a fault.
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

/// How much of a run is written.
struct RunFilesOptions {
  int record_every = 10;  ///< plant steps between two rows of trace.csv
  bool plots = false;     ///< as SVG files too, where the page has them
};

/// An SVG file: its name and what makes it, without panels where there is nothing to show.
using PlotFile = std::pair<std::string, std::function<PlotSpec()>>;

/// What there is to write. Functions are called where their part is wanted.
struct RunFiles {
  const Trace& trace;
  const FaultReport& fault;
  nlohmann::ordered_json figures;  ///< metrics.json
  std::string task_file;           ///< the text of task.yaml
  std::vector<PlotFile> plots;
  std::function<RunPage()> page;
};

/// Writes trace.csv, metrics.json, task.yaml, the plots where they are asked for or there is no
/// page, after a fault fault.txt and last_second.csv, and what `pages` writes; their names. Throws
/// Error if a file cannot be written, and for a `record_every` that is not positive.
std::vector<std::string> write_run_files(const RunFiles& run, const RunFilesOptions& options,
                                         const std::filesystem::path& folder, PageWriter& pages);

/// A fault in figures; null without one.
nlohmann::ordered_json fault_json(const FaultReport& fault);
/// As the page shows it.
std::optional<PageFault> page_fault(const FaultReport& fault);
/// A robot at q with its postures and meshes, which lie where `name` (load_robot()) leads to.
RobotDrawing drawing_of(const Robot& robot, const std::string& name, const Eigen::VectorXd& q);

}  // namespace burnish
