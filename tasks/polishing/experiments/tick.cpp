// Experiment tick: how long the computation of a plan takes, at several plan rates. Runs are made
// one after another.
#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "polishing/experiments/batch.hpp"

namespace burnish::polishing {
namespace {

/// Run that computes plans at one rate.
struct RateTimes {
  double rate;       ///< Rate of plans [Hz].
  double tick_rate;  ///< Rate of ticks [Hz].
  RunFigures run = {};

  SolverFigures plans() const {
    return run.metrics && run.metrics->solver ? *run.metrics->solver : SolverFigures{};
  }
  /// Returns whether the run polished, had 99 % of its plans in time, and has at most the force
  /// error of `slowest`, the run with the lowest rate of plans.
  bool holds(const RunFigures& slowest) const {
    return run.succeeded && plans().updates > 0 && plans().p99 < 1.0 / rate &&
           run["force_rmse"] <= slowest["force_rmse"] + 1e-9;
  }
};

std::vector<double> rates_of(bool quick) {
  if (quick) return {100.0, 500.0};
  return {100.0, 200.0, 500.0, 1000.0, 2000.0, 4000.0};
}

std::vector<RateTimes> perform_rates(const ExperimentSpec& spec, std::vector<RunFigures>& figures) {
  const std::string surface = spec.surfaces.empty() ? "table" : spec.surfaces.front();
  std::vector<RateTimes> timed;
  std::vector<BatchRun> runs;
  for (const double rate : rates_of(spec.quick)) {
    timed.push_back({rate, std::max(2000.0, rate)});
    BatchRun run;
    run.name = std::to_string(std::lround(rate)) + " Hz";
    run.spec.task = experiment_task(spec, surface, "mismatch", 60.0);
    run.spec.task.disturbances.seed = static_cast<std::uint64_t>(spec.first_seed);
    run.spec.task.update_rate = rate;
    run.spec.task.tick_rate = timed.back().tick_rate;
    run.spec.plant = spec.plant;
    runs.push_back(std::move(run));
  }
  ExperimentSpec alone = spec;
  alone.threads = 1;
  figures = run_batch(alone, runs);
  for (std::size_t i = 0; i < timed.size(); ++i) timed[i].run = figures[i];
  return timed;
}

ResultTable rates_table(const std::vector<RateTimes>& timed) {
  const char* const figures[] = {"ticks.median",  "ticks.p99",  "ticks.maximum",
                                 "solver.median", "solver.p99", "solver.maximum",
                                 "force_rmse",    "force_peak", "position_rmse"};
  ResultTable table{.name = "rates", .title = "Times and errors for every rate of plans"};
  table.columns = {{"plans", "Hz", 0}, {"ticks", "Hz", 0}};
  for (const char* figure : figures) table.columns.push_back(figure_column(figure));
  for (const ResultColumn& column :
       {ResultColumn{"late", "%", 2}, {"p99 of the period", "%", 0}, {"holds"}})
    table.columns.push_back(column);
  for (const RateTimes& each : timed) {
    std::vector<ResultCell> row{each.rate, each.tick_rate};
    for (const char* figure : figures) row.emplace_back(shown(figure, each.run[figure]));
    const TickTimes& t = each.run.ticks;
    row.emplace_back(t.count > 0 ? 100.0 * t.late / t.count : 0.0);
    row.emplace_back(100.0 * each.plans().p99 * each.rate);
    row.emplace_back(std::string(each.holds(timed.front().run) ? "yes" : "no"));
    table.add(std::move(row));
  }
  return table;
}

Figure rates_figure(const std::vector<RateTimes>& timed) {
  const auto size = static_cast<Eigen::Index>(timed.size());
  Eigen::VectorXd x(size);
  for (Eigen::Index i = 0; i < size; ++i) x[i] = std::log10(timed[to_size(i)].rate);
  const auto curve = [&](const char* name, const auto& value) {
    Curve result{.name = name, .x = x, .y = Eigen::VectorXd(size)};
    for (Eigen::Index i = 0; i < size; ++i) result.y[i] = value(timed[to_size(i)]);
    return result;
  };
  const char* axis = "plans per second [power of ten]";
  Panel times{.title = "Ticks with a plan", .x_label = axis, .y_label = "time [ms]", .log_y = true};
  times.curves = {curve("median", [&](const RateTimes& t) { return 1e3 * t.plans().median; }),
                  curve("p99", [&](const RateTimes& t) { return 1e3 * t.plans().p99; }),
                  curve("max", [&](const RateTimes& t) { return 1e3 * t.plans().maximum; }),
                  curve("between plans", [](const RateTimes& t) { return 1e3 / t.rate; })};
  times.curves.back().color = 6;
  times.curves.back().dashed = true;
  Panel force{.title = "Force", .x_label = axis, .y_label = "rms error [N]"};
  force.curves = {curve("", [](const RateTimes& t) { return t.run["force_rmse"]; })};
  Panel path{.title = "Path", .x_label = axis, .y_label = "rms error [mm]"};
  path.curves = {
      curve("", [](const RateTimes& t) { return shown("position_rmse", t.run["position_rmse"]); })};
  Figure figure{.name = "rates",
                .plot = {.title = "Computing times and errors over the rate of plans"}};
  figure.plot.panels = {times, force, path};
  return figure;
}

}  // namespace

ExperimentReport perform_tick(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "Computing times"};
  std::vector<RunFigures> figures;
  const std::vector<RateTimes> timed = perform_rates(spec, figures);
  report.tables = {rates_table(timed)};
  report.figures = {rates_figure(timed)};
  double highest = 0.0;
  for (const RateTimes& each : timed)
    if (each.holds(timed.front().run)) highest = std::max(highest, each.rate);
  const std::string slowest = std::to_string(std::lround(timed.front().rate));
  report.findings.push_back(
      highest > 0.0
          ? "The highest rate that works in real time is " + std::to_string(std::lround(highest)) +
                " Hz: 99 % of the plans take less than the time between two plans, and the force "
                "error is not larger than at " +
                slowest + " Hz."
          : "No rate works in real time: at every rate, more than 1 % of the plans take longer "
            "than the time between two plans, or the force error is larger than at " +
                slowest + " Hz.");
  report.findings.push_back(
      "Times depend on the machine and on its other load; the errors do not.");
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing
