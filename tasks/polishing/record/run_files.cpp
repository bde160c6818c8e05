#include "polishing/record/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/figures.hpp"
#include "record/figures_json.hpp"
#include "record/run_folder.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;

/// What came, and what was wanted of it; the force's error in N and as a share of the force.
Json verdict_json(const Task& task, const VerdictFigures& figures) {
  Json json;
  each_verdict_figure([&](const FigureEntry& entry, auto member, auto wanted, bool at_least) {
    const double value = figures.*member, most = task.verdict.*wanted;
    const bool share = !*entry.unit.unit;
    Json& of = json[entry.name];
    of["value"] = number_json(share ? value : value / task.force);
    of[at_least ? "at_least" : "at_most"] = number_json(most);
    if (!share) of[std::string("value_") + entry.unit.unit] = number_json(value);
  });
  return json;
}

Json ticks_json(const RunResult& result) {
  Json json;
  each_tick_figure([&](const FigureEntry& entry, auto member) {
    json[entry.key()] = figure_json(result.ticks.*member);
  });
  json["first_s"] = result.first_tick;
  return json;
}

/// Every `every`th row, and the last.
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

}  // namespace

Json run_json(const PolishJob& job, const RunResult& result) {
  Json json{{"name", job.name},
            {"controller", name_of(job.spec.controller)},
            {"plant", name_of(job.spec.plant)},
            {"seed", job.spec.task.disturbances.seed},
            {"polished", result.polished},
            {"outcome", result.outcome},
            {"fault", nullptr}};
  if (result.fault.kind != FaultKind::None)
    json["fault"] = {{"kind", name_of(result.fault.kind)},
                     {"time_s", result.fault.time},
                     {"value", number_json(result.fault.value)},
                     {"limit", number_json(result.fault.limit)}};
  json["verdict"] = result.verdict ? verdict_json(job.spec.task, *result.verdict) : Json(nullptr);
  json["metrics"] = result.metrics ? metrics_json(*result.metrics) : Json(nullptr);
  json["ticks"] = ticks_json(result);
  json["reach"] = {{"points", result.reach.points},
                   {"path_length_m", result.reach.path_length},
                   {"joint_margin_rad", number_json(result.reach.joint_margin)},
                   {"tightest_joint", result.reach.tightest_joint},
                   {"torque_share", result.reach.torque_share},
                   {"tightest_torque", result.reach.tightest_torque}};
  json["wall_time_s"] = result.wall_time;
  return json;
}

std::vector<std::string> write_run(const PolishJob& job, const RunResult& result,
                                   const RunFilesOptions& options, const fs::path& folder,
                                   PageWriter& pages) {
  if (options.record_every < 1)
    throw Error(fmt::format("record_every is {}; wanted is a positive number of plant steps",
                            options.record_every));
  make_folder(folder);
  std::vector<std::string> names{"trace.csv", "metrics.json", "task.yaml"};
  thinned(result.trace, options.record_every).write_csv(folder / "trace.csv");
  write_text(folder / "metrics.json", json_text(run_json(job, result)));
  write_task(job.spec.task, folder / "task.yaml");
  std::error_code ignored;  // of a run before in the same folder
  for (const char* name :
       {"force.svg", "path.svg", "torques.svg", "solver.svg", "fault.txt", "last_second.csv"})
    fs::remove(folder / name, ignored);
  if (options.plots || !pages.makes_pages())
    for (std::string& name : write_polish_plots(job, result, folder))
      names.push_back(std::move(name));
  if (result.fault.kind != FaultKind::None) {
    write_text(folder / "fault.txt", result.fault.text());
    result.fault.last_second.write_csv(folder / "last_second.csv");
    names.insert(names.end(), {"fault.txt", "last_second.csv"});
  }
  std::function<RunPage()> page;
  if (result.trace.rows() > 0)
    page = [&] { return make_run_page(job, result, options.record_every); };
  for (std::string& name : pages.write(folder, page)) names.push_back(std::move(name));
  return names;
}

}  // namespace burnish::polishing
