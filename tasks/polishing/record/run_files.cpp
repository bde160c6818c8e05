#include "polishing/record/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/tasks/polishing/task_file.hpp"
#include "record/json_text.hpp"
#include "record/run_folder.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;

Json metrics_json(const Metrics& m) {
  Json json{{"start_s", m.start},
            {"end_s", m.end},
            {"rows", m.rows},
            {"average_s", m.average},
            {"force_mean_N", m.force_mean},
            {"force_mae_N", m.force_mae},
            {"force_rmse_N", m.force_rmse},
            {"force_peak_N", m.force_peak},
            {"force_rmse_raw_N", m.force_rmse_raw},
            {"force_peak_raw_N", m.force_peak_raw},
            {"estimate_rmse_N", m.estimate_rmse},
            {"without_contact", m.without_contact},
            {"impact_peak_N", number_json(m.impact_peak)},
            {"overshoot_N", number_json(m.overshoot)},
            {"position_mean_m", m.position_mean},
            {"position_rmse_m", m.position_rmse},
            {"position_p95_m", m.position_p95},
            {"orientation_drift_rad", m.orientation_drift},
            {"joint_margin_rad", number_json(m.joint_margin)},
            {"tightest_joint", m.tightest_joint},
            {"torque_margin", m.torque_margin},
            {"tightest_torque", m.tightest_torque},
            {"limited_torque", m.limited_torque}};
  if (m.solver)
    json["solver"] = {{"updates", m.solver->ticks},
                      {"median_s", m.solver->median},
                      {"p99_s", m.solver->p99},
                      {"maximum_s", m.solver->maximum},
                      {"mean_iterations", m.solver->mean_iterations},
                      {"missed_deadlines", m.solver->missed_deadlines}};
  return json;
}

/// What came, and what was wanted of it; the force's error in N and as a share of the force.
Json verdict_json(const Task& task, const VerdictFigures& figures) {
  const Verdict& wanted = task.verdict;
  return {{"contact_share",
           {{"value", number_json(figures.contact_share)}, {"at_least", wanted.contact_share}}},
          {"force_rmse",
           {{"value", number_json(figures.force_rmse / task.force)},
            {"at_most", number_json(wanted.force_rmse)},
            {"value_N", number_json(figures.force_rmse)}}},
          {"path_share",
           {{"value", number_json(figures.path_share)}, {"at_least", wanted.path_share}}}};
}

Json ticks_json(const RunResult& result) {
  const TickTimes& t = result.ticks;
  return {{"count", t.ticks},
          {"period_s", t.period},
          {"median_s", t.median},
          {"p99_s", t.p99},
          {"maximum_s", t.maximum},
          {"mean_s", t.mean},
          {"first_s", result.first_tick}};
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

std::vector<std::string> write_run(const PolishJob& job, const RunResult& result, int record_every,
                                   const fs::path& folder, PageWriter& pages) {
  if (record_every < 1)
    throw Error(fmt::format("record_every is {}; wanted is a positive number of plant steps",
                            record_every));
  make_folder(folder);
  std::vector<std::string> names{"trace.csv", "metrics.json", "task.yaml"};
  thinned(result.trace, record_every).write_csv(folder / "trace.csv");
  write_text(folder / "metrics.json", json_text(run_json(job, result)));
  write_task(job.spec.task, folder / "task.yaml");
  for (std::string& name : write_polish_plots(job, result, folder))
    names.push_back(std::move(name));
  std::error_code ignored;  // of a run before in the same folder
  for (const char* name : {"fault.txt", "last_second.csv"}) fs::remove(folder / name, ignored);
  if (result.fault.kind != FaultKind::None) {
    write_text(folder / "fault.txt", result.fault.text());
    result.fault.last_second.write_csv(folder / "last_second.csv");
    names.insert(names.end(), {"fault.txt", "last_second.csv"});
  }
  std::function<RunPage()> page;
  if (result.trace.rows() > 0) page = [&] { return make_run_page(job, result, record_every); };
  for (std::string& name : pages.write(folder, page)) names.push_back(std::move(name));
  return names;
}

}  // namespace burnish::polishing
