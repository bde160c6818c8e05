#include "record/run_files.hpp"

#include <fmt/format.h>

#include "base/whole_file.hpp"
#include "burnish/contact/loops.hpp"
#include "record/json_text.hpp"
#include "record/mesh_file.hpp"
#include "record/run_folder.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

/// Returns every `every`th row and the last row.
Trace thinned(const Trace& trace, int every) {
  if (every <= 1) return trace;
  Trace result(trace.columns(), trace.rows() / every + 2);
  const int columns = static_cast<int>(trace.columns().size());
  for (int row = 0; row < trace.rows(); ++row) {
    if (row % every != 0 && row + 1 != trace.rows()) continue;
    double* to = result.add_row();
    for (int column = 0; column < columns; ++column) to[column] = trace.at(row, column);
  }
  return result;
}

/// Writes the plots and returns their names. Removes plots of an earlier run in this folder.
std::vector<std::string> write_plots(const RunFiles& run, bool wanted, const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& [name, make] : run.plots) {
    std::error_code ignored;
    fs::remove(folder / name, ignored);
    if (!wanted || run.trace.rows() == 0) continue;
    const PlotSpec plot = make();
    if (plot.panels.empty()) continue;
    write_svg_plot(plot, folder / name);
    names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<std::string> write_run_files(const RunFiles& run, const RunFilesOptions& options,
                                         const fs::path& folder, PageWriter& pages) {
  if (options.record_every < 1)
    throw Error(
        fmt::format("record_every is {}; wanted at least 1 plant step", options.record_every));
  make_folder(folder);
  std::vector<std::string> names{"trace.csv", "metrics.json", "task.yaml"};
  thinned(run.trace, options.record_every).write_csv(folder / "trace.csv");
  write_text(folder / "metrics.json", json_text(run.figures));
  write_whole_file(folder / "task.yaml", run.task_file);
  for (std::string& name : write_plots(run, options.plots || !pages.makes_pages(), folder))
    names.push_back(std::move(name));
  std::error_code ignored;
  for (const char* name : {"fault.txt", "last_second.csv"}) fs::remove(folder / name, ignored);
  if (run.fault.kind != FaultKind::None) {
    write_text(folder / "fault.txt", run.fault.text());
    run.fault.last_second.write_csv(folder / "last_second.csv");
    names.insert(names.end(), {"fault.txt", "last_second.csv"});
  }
  const bool has_page = run.trace.rows() > 0;
  for (std::string& name : pages.write(folder, has_page ? run.page : nullptr))
    names.push_back(std::move(name));
  return names;
}

Json fault_json(const FaultReport& fault) {
  if (fault.kind == FaultKind::None) return nullptr;
  Json json{{"kind", name_of(fault.kind)},
            {"time_s", fault.time},
            {"value", number_json(fault.value)},
            {"limit", number_json(fault.limit)}};
  if (!fault.joint_name.empty()) json["joint"] = fault.joint_name;
  if (!fault.cause.empty()) json["cause"] = fault.cause;
  return json;
}

std::optional<PageFault> page_fault(const FaultReport& fault) {
  if (fault.kind == FaultKind::None) return std::nullopt;
  return PageFault{std::string(name_of(fault.kind)), fault.time, fault.text()};
}

RobotDrawing drawing_of(const Robot& robot, const std::string& name, const Eigen::VectorXd& q) {
  RobotDrawing drawing{.model = robot.model, .q = q};
  for (const auto& [posture, values] : robot.postures)
    drawing.postures[posture] = closed_configuration(robot.model, values);
  drawing.meshes = load_meshes(robot.model, mesh_folders(name));
  return drawing;
}

}  // namespace burnish
