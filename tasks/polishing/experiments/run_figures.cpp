#include "polishing/experiments/run_figures.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "polishing/figures.hpp"

namespace burnish::polishing {
namespace {

constexpr double none = RunFigures::none;

/// Returns the largest torque in the trace columns called `what`_JOINT, as a fraction of the effort
/// limit of the joint.
double largest_effort_ratio(const Trace& trace, const Model& model, const std::string& what) {
  double ratio = 0.0;
  for (int k = 0; k < model.nv; ++k)
    if (std::isfinite(model.effort_limit[k]) && model.effort_limit[k] > 0.0 && trace.rows() > 0)
      ratio = std::max(ratio, trace.column(what + "_" + model.v_name(k)).cwiseAbs().maxCoeff() /
                                  model.effort_limit[k]);
  return ratio;
}

std::vector<double> finite_of(const std::vector<double>& values) {
  std::vector<double> result;
  std::copy_if(values.begin(), values.end(), std::back_inserter(result),
               [](double value) { return std::isfinite(value); });
  return result;
}

/// Calls see(full name, table entry, value) for each statistic of a run.
template <class See>
void each_value(const RunFigures& run, const See& see) {
  const Metrics metrics = run.metrics.value_or(Metrics{});
  each_metric([&](const FigureEntry& entry, auto member) {
    if constexpr (!std::same_as<decltype(member), std::string Metrics::*>)
      see(entry.name, entry, run.metrics ? figure_value(metrics.*member) : none);
  });
  each_solver_figure([&](const FigureEntry& entry, auto member) {
    see(std::string("solver.") + entry.name, entry,
        metrics.solver ? figure_value(*metrics.solver.*member) : none);
  });
  each_standing_figure([&](const FigureEntry& entry, auto member) {
    see(std::string("standing.") + entry.name, entry,
        run.standing ? figure_value(*run.standing.*member) : none);
  });
  each_tick_figure([&](const FigureEntry& entry, auto member) {
    see(std::string("ticks.") + entry.name, entry, figure_value(run.ticks.*member));
  });
  each_run_figure(
      [&](const FigureEntry& entry, auto member) { see(entry.name, entry, run.*member); });
}

constexpr const char* figures_of_a_row[] = {
    "force_mean",        "force_rmse",      "force_peak",        "position_rmse",
    "position_p95",      "without_contact", "impact_peak",       "overshoot",
    "orientation_drift", "joint_margin",    "run_torque_margin", "run_limited_torque",
    "largest_command",   "tool_to_normal"};

}  // namespace

bool all_finite(const Trace& trace) {
  const int columns = static_cast<int>(trace.columns().size());
  for (int column = 0; column < columns; ++column)
    if (!trace.column(column).allFinite()) return false;
  return true;
}

double RunFigures::operator[](const std::string& figure) const {
  figure_named(figure);
  double value = none;
  each_value(*this, [&](const std::string& full_name, const FigureEntry&, double of_run) {
    if (full_name == figure) value = of_run;
  });
  return value;
}

FigureEntry figure_named(const std::string& name) {
  std::optional<FigureEntry> found;
  std::vector<std::string> names;
  each_value({}, [&](const std::string& full_name, const FigureEntry& entry, double) {
    names.push_back(full_name);
    if (name == full_name) found = entry;
  });
  if (!found) throw Error("unknown figure " + in_quotes(name) + did_you_mean(name, names));
  return *found;
}

double shown(const std::string& figure, double value) {
  return figure_named(figure).unit.factor * value;
}

ResultColumn figure_column(const std::string& figure, const std::string& title) {
  const FigureEntry entry = figure_named(figure);
  return {title.empty() ? figure : title, entry.unit.shown, entry.digits};
}

bool fell(const RunFigures& run) { return run.standing && fell(*run.standing); }

RunFigures figures_of(const std::string& name, const Task& task, const RunResult& result) {
  RunFigures f;
  f.name = name;
  f.outcome = result.outcome;
  // Removes the computing time from the text, because it differs between runs.
  if (const auto at = f.outcome.find(", simulated in"); at != std::string::npos)
    f.outcome.erase(at);
  f.succeeded = result.succeeded;
  f.fault = result.fault.kind;
  f.seed = task.disturbances.seed;
  f.finite = all_finite(result.trace);
  const Model& model = result.setting.robot.model;
  f.run_torque_margin = 1.0 - largest_effort_ratio(result.trace, model, "tau_applied");
  f.largest_command = largest_effort_ratio(result.trace, model, "tau_command");
  const auto limited = result.trace.column("limited_joints");
  if (limited.size() > 0) f.run_limited_torque = (limited.array() > 0.0).cast<double>().mean();
  f.q_start = result.setting.q_start;
  f.p_center = result.setting.p_center;
  f.ticks = result.ticks;
  f.standing = result.standing;
  f.metrics = result.metrics;
  if (!result.metrics) return f;
  if (task.force_profile.is_constant())
    f.force_error_mean = result.metrics->force_mean - task.force;
  return f;
}

std::vector<ResultColumn> run_columns() {
  std::vector<ResultColumn> columns{{"polished"}};
  for (const char* figure : figures_of_a_row) columns.push_back(figure_column(figure));
  columns.push_back({"outcome"});
  return columns;
}

std::vector<ResultCell> run_cells(const RunFigures& run) {
  std::vector<ResultCell> cells{std::string(run.succeeded ? "yes" : "no")};
  for (const char* figure : figures_of_a_row) cells.emplace_back(shown(figure, run[figure]));
  cells.emplace_back(run.outcome);
  return cells;
}

double mean_of(const std::vector<double>& values) {
  const std::vector<double> finite = finite_of(values);
  double sum = 0.0;
  for (const double value : finite) sum += value;
  return finite.empty() ? none : sum / static_cast<double>(finite.size());
}

double largest_of(const std::vector<double>& values) {
  const std::vector<double> finite = finite_of(values);
  return finite.empty() ? none : *std::max_element(finite.begin(), finite.end());
}

double worst_shown(const std::vector<RunFigures>& runs, const std::string& figure) {
  double worst = 0.0;
  for (const RunFigures& run : runs) {
    const double value = shown(figure, run[figure]);
    if (std::isnan(value)) return value;
    worst = std::max(worst, value);
  }
  return worst;
}

double smallest_of(const std::vector<double>& values) {
  const std::vector<double> finite = finite_of(values);
  return finite.empty() ? none : *std::min_element(finite.begin(), finite.end());
}

double quantile_of(std::vector<double> values, double fraction) {
  values = finite_of(values);
  if (values.empty()) return none;
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(fraction * static_cast<double>(values.size()));
  return values[to_size(std::max(1.0, rank)) - 1];
}

std::vector<double> collect(const std::vector<RunFigures>& runs, const std::string& figure) {
  std::vector<double> values;
  for (const RunFigures& run : runs) values.push_back(run[figure]);
  return values;
}

void add_columns(const std::vector<SummaryColumn>& summary, ResultTable& table) {
  for (const SummaryColumn& column : summary)
    table.columns.push_back(figure_column(column.figure, column.title));
}

void add_cells(const std::vector<SummaryColumn>& summary, const std::vector<RunFigures>& runs,
               std::vector<ResultCell>& row) {
  for (const SummaryColumn& column : summary)
    row.emplace_back(shown(column.figure, column.of(collect(runs, column.figure))));
}

}  // namespace burnish::polishing
