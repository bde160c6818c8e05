// Page of a planned motion: its replay, the followed signals, the constraint rows and their
// multipliers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text_file.hpp"
#include "base/to_size.hpp"
#include "record/run_files.hpp"
#include "record/solution.hpp"

namespace burnish {
namespace {

/// Maximum number of constraint rows on a page. The rows with the largest multipliers are kept.
/// Chosen by hand.
constexpr std::size_t max_rows = 40;

void add_columns(RunPage& page, const Trace& trace) {
  for (const TraceColumn& column : trace.columns())
    if (column.name != "time" && column.name != "stage")
      page.columns.push_back({column.name, column.unit, trace.column(column.name)});
  const double start = trace.rows() > 0 ? trace.column("time")[0] : 0.0;
  page.time = trace.column("time").array() - start;
  page.duration = trace.rows() > 0 ? page.time[page.time.size() - 1] : 0.0;
}

void add_stages(RunPage& page, const Problem& problem) {
  const std::vector<std::string> names = problem.stage_names();
  const double start = problem.time_of(0);
  for (int k = 0; k < problem.knots(); ++k) {
    const std::string& name = names.at(to_size(problem.stage_of(k)));
    const double from = problem.time_of(k) - start, to = problem.time_of(k + 1) - start;
    if (!page.phases.empty() && page.phases.back().name == name)
      page.phases.back().end = to;
    else
      page.phases.push_back({name, from, to});
  }
}

/// Adds the constraint rows by name, rows with the largest multipliers first.
void add_limits(RunPage& page, Problem& problem, const DdpSolver& solver,
                const CostReport& report) {
  std::vector<CostReport::Row> order = report.active_constraints();
  const auto has = [&](const std::string& name) {
    return std::any_of(order.begin(), order.end(),
                       [&](const auto& row) { return row.name == name; });
  };
  for (const CostReport::Row& row : report.rows)
    if (!has(row.name)) order.push_back(row);
  if (order.size() > max_rows) order.resize(max_rows);
  const int knots = problem.knots();
  const Eigen::VectorXd none =
      Eigen::VectorXd::Constant(knots + 1, std::numeric_limits<double>::quiet_NaN());
  std::map<std::string, PageLimit*> by_name;
  page.plan->limits.reserve(order.size());
  for (const CostReport::Row& row : order) {
    page.plan->limits.push_back({row.name, none, none});
    by_name[row.name] = &page.plan->limits.back();
  }
  const RowMatrix xs = solver.xs(), us = solver.us();
  for (int k = 0; k <= knots; ++k) {
    if (problem.rows(k) == 0) continue;
    const std::vector<std::string> names = problem.row_names(k);
    const Eigen::VectorXd x = xs.row(k), u = us.row(std::min(k, knots - 1));
    const std::vector<double> values =
        problem.row_values(k, x.data(), k < knots ? u.data() : nullptr);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto found = by_name.find(names[i]);
      if (found == by_name.end()) continue;
      const double scale = problem.row_scale(k)[i];
      const double inside =
          std::min(values[i] - problem.row_lower(k)[i], problem.row_upper(k)[i] - values[i]);
      found->second->margin[k] = inside / scale;
      found->second->multiplier[k] = solver.multipliers(k)[static_cast<Eigen::Index>(i)] * scale;
    }
  }
}

void add_figures(RunPage& page, const Problem& problem, const DdpSolver& solver,
                 const StepReport& steps, const Trace& trace) {
  const DdpSummary& summary = solver.summary();
  const auto add = [&](const char* name, const char* label, double value, std::string unit,
                       const char* text) {
    page.metrics.push_back({name, label, value, std::move(unit), text});
  };
  add("cost", "cost", summary.cost, "1", "Sum of all costs over the horizon");
  add("iterations", "iterations", summary.iterations, "1", "Iterations of the solver");
  add("seconds", "time to solve", summary.seconds.total, "s", "Computing time of the solver");
  add("violation", "constraint violation", summary.violation, "1",
      "Largest constraint violation, divided by the scale of its row");
  add("largest_gap", "largest gap", summary.largest_gap, "1",
      "Largest difference between the end of a step and the next state");
  for (const auto& [name, label, error] :
       {std::tuple{"step_position", "error of a step, position", steps.position},
        std::tuple{"step_velocity", "error of a step, velocity", steps.velocity}})
    add(name, label, error.error, error.unit, "Difference from an integration with small steps");
  for (const std::string& frame : followed(problem.spec()).frames) {
    const Eigen::VectorXd distance = trace.column(frame + "_distance_from_target");
    const double last = distance.size() > 0 ? distance[distance.size() - 1] : 0.0;
    if (std::isfinite(last))
      page.metrics.push_back(
          {frame + "_distance", frame + ", at the end", last, "m",
           "Distance of the frame from its target, along the axes with a weight"});
  }
}

}  // namespace

RunPage solution_page(const SolvedFile& solved, Problem& problem, const DdpSolver& solver,
                      const StepReport& steps) {
  const std::filesystem::path file = solved.file;
  const DdpSummary& summary = solver.summary();
  const Trace trace = solution_trace(problem, solver.xs(), solver.us());
  RunPage page{.name = file.stem().string(),
               .facts = {{"problem", file.filename().string()},
                         {"robot", problem.model().name},
                         {"knots", std::to_string(problem.knots())}},
               .command = "burnish solve " + solved.file,
               .outcome = solver.text(),
               .succeeded = summary.reason == StopReason::Converged,
               .task_file = read_text(file, "problem file"),
               .robot = drawing_of(solved.problem.robot, solved.problem.robot_name,
                                   problem.spec().initial_state.head(problem.model().nq))};
  const PlotSignals follows = followed(problem.spec());
  page.plan = PagePlan{.frames = follows.frames, .forces = follows.forces};
  if (!follows.frames.empty()) {
    page.tool_frame = follows.frames.front();
    for (int i = 0; i < 3 && trace.rows() > 0; ++i)
      page.path_origin_world[i] =
          trace.at(0, trace.index(page.tool_frame + "_" + "xyz"[i] + "_world"));
  }
  page.path_u = page.path_w = Eigen::VectorXd::Zero(2);
  add_columns(page, trace);
  add_stages(page, problem);
  add_limits(page, problem, solver, solver.cost_report());
  add_figures(page, problem, solver, steps, trace);
  return page;
}

}  // namespace burnish
