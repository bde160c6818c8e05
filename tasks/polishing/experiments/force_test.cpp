// Experiment force_test: tests of force control for several controllers; see docs/force_test.md.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "polishing/experiments/batch.hpp"
#include "polishing/experiments/force_catalogue.hpp"
#include "polishing/experiments/force_figures.hpp"
#include "polishing/experiments/found_posture.hpp"
#include "report/trace_curves.hpp"

namespace burnish::polishing {
namespace {

/// Controller under test.
struct Contender {
  std::string name;
  ControllerKind controller;
  bool preview = true;  ///< True if the controller uses the target force of future times.
};

/// Returns the controllers under test. To test another controller, add a line here.
std::vector<Contender> contenders() {
  return {{"mpc", ControllerKind::Mpc},
          {"mpc without preview", ControllerKind::Mpc, false},
          {"baseline", ControllerKind::Baseline}};
}

/// Robot at a surface, with the tests that it runs there.
struct TestPlace {
  std::string robot, surface;
  std::vector<ForceTest> tests;
  std::optional<Robot> loaded = {};
};

/// Row of results: one statistic of one contender in one test, with a value for each seed and a
/// note on failures.
struct FigureRow {
  std::size_t place;
  std::string test, figure;
  std::size_t contender;
  std::vector<double> values;  ///< Value of each seed; NaN if the figure does not exist.
  std::string note = {};

  bool complete() const {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  }
};

const ForceFigure& force_figure(const std::string& name) {
  for (const ForceFigure& figure : force_figures())
    if (figure.name == name) return figure;
  throw Error("the force test measures no figure '" + name + "'");
}

/// Returns the worst value over the seeds; NaN if a seed has no value.
double worst_of(const FigureRow& row) {
  if (!row.complete() || row.values.empty()) return RunFigures::none;
  const bool larger = force_figure(row.figure).larger_is_better;
  return *std::max_element(row.values.begin(), row.values.end(), [&](double a, double b) {
    return larger ? a > b : std::abs(a) < std::abs(b);
  });
}

/// Returns a robot at a surface, with a start posture and the tests.
TestPlace place_of(const ExperimentSpec& spec, const std::string& robot, const std::string& tool,
                   const std::string& surface) {
  Task task = experiment_task(spec, surface, "mismatch", 1.0);
  if (!robot.empty()) {
    task.robot = robot;
    task.tool = tool;
  }
  // Disables the verdict, because force-control figures are evaluated instead.
  task.verdict = {.contact_share = 0.0,
                  .force_rmse = std::numeric_limits<double>::infinity(),
                  .path_share = 0.0};
  Robot loaded = load_task_robot(task);
  const Setting setting = make_setting(task, loaded);
  if (searches_posture(task, loaded)) start_from(setting.q_start, loaded, task);
  return {task.robot, surface, force_catalogue(task, setting, spec.quick), std::move(loaded)};
}

std::vector<TestPlace> places_of(const ExperimentSpec& spec) {
  const std::vector<std::string> surfaces =
      spec.surfaces.empty() ? std::vector<std::string>{"table"} : spec.surfaces;
  const std::vector<std::string> robots =
      spec.robots.empty() ? std::vector<std::string>{""} : spec.robots;
  std::vector<TestPlace> places;
  for (std::size_t r = 0; r < robots.size(); ++r)
    for (const std::string& surface : surfaces)
      places.push_back(
          place_of(spec, robots[r], r < spec.tools.size() ? spec.tools[r] : "tool", surface));
  return places;
}

/// Run of one contender in one test: indices of place, test and contender, and the seed.
struct ForceRun {
  std::size_t place, test, contender;
  int seed;
};

std::vector<ForceRun> entries_of(const std::vector<TestPlace>& places, int seeds) {
  const std::vector<Contender> all = contenders();
  std::vector<ForceRun> entries;
  for (std::size_t p = 0; p < places.size(); ++p)
    for (std::size_t t = 0; t < places[p].tests.size(); ++t)
      for (std::size_t c = 0; c < all.size(); ++c) {
        // Skips contenders without preview if the force is constant, because preview then has no
        // effect.
        if (!all[c].preview && places[p].tests[t].task.force_profile.is_constant()) continue;
        for (int seed = 0; seed < seeds; ++seed) entries.push_back({p, t, c, seed});
      }
  return entries;
}

BatchRun run_of(const ExperimentSpec& spec, const TestPlace& place, const ForceRun& entry) {
  const Contender contender = contenders()[entry.contender];
  const ForceTest& test = place.tests[entry.test];
  const int seed = spec.first_seed + entry.seed;
  BatchRun run;
  run.name = place.robot + ", " + place.surface + ", " + test.name + ", " + contender.name +
             ", seed " + std::to_string(seed);
  run.spec.task = test.task;
  run.spec.task.force_profile.preview = contender.preview;
  run.spec.task.disturbances.seed = static_cast<std::uint64_t>(seed);
  run.spec.robot = place.loaded;
  run.spec.controller = contender.controller;
  run.spec.plant = spec.plant;
  run.spec.plan_rate = 0.0;
  run.measure = test.measure;
  if (test.has_curve && entry.seed == 0) run.curves = contender.name;
  return run;
}

std::vector<FigureRow> rows_of(const std::vector<TestPlace>& places,
                               const std::vector<ForceRun>& entries,
                               const std::vector<RunFigures>& runs, int seeds) {
  std::vector<FigureRow> rows;
  const auto row_of = [&](const ForceRun& entry, const std::string& test,
                          const std::string& figure) -> FigureRow& {
    for (FigureRow& row : rows)
      if (row.place == entry.place && row.contender == entry.contender && row.test == test &&
          row.figure == figure)
        return row;
    rows.push_back({entry.place, test, figure, entry.contender,
                    std::vector<double>(to_size(seeds), RunFigures::none)});
    return rows.back();
  };
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ForceRun& entry = entries[i];
    for (const MeasuredFigure& figure : runs[i].measured)
      row_of(entry, figure.test, figure.figure).values[to_size(entry.seed)] = figure.value;
    if (!runs[i].made || !runs[i].measured.empty()) continue;
    FigureRow& row = row_of(entry, places[entry.place].tests[entry.test].name, "");
    if (row.note.empty())
      row.note = "seed " + std::to_string(runs[i].seed) + ": " + runs[i].outcome;
  }
  return rows;
}

const FigureRow* find_row(const std::vector<FigureRow>& rows, std::size_t place,
                          std::size_t contender, const std::string& test,
                          const std::string& figure) {
  for (const FigureRow& row : rows)
    if (row.place == place && row.contender == contender && row.test == test &&
        row.figure == figure)
      return &row;
  return nullptr;
}

/// Sine sweep of one place: names and frequencies of its tests.
struct SineSweep {
  std::vector<std::string> names;
  std::vector<double> frequencies;
};
SineSweep sweep_of(const TestPlace& place) {
  SineSweep sweep;
  for (const ForceTest& test : place.tests)
    if (test.frequency > 0.0) {
      sweep.names.push_back(test.name);
      sweep.frequencies.push_back(test.frequency);
    }
  return sweep;
}

/// Returns the values of a statistic at the frequencies of a sweep, for one seed.
std::vector<double> swept(const std::vector<FigureRow>& rows, const SineSweep& sweep,
                          std::size_t place, std::size_t contender, const std::string& figure,
                          std::size_t seed) {
  std::vector<double> values;
  for (const std::string& name : sweep.names) {
    const FigureRow* row = find_row(rows, place, contender, name, figure);
    values.push_back(row != nullptr ? row->values[seed] : RunFigures::none);
  }
  return values;
}

std::vector<double> phases_of(const std::vector<FigureRow>& rows, const SineSweep& sweep,
                              std::size_t place, std::size_t contender, std::size_t seed) {
  constexpr double one_degree = std::numbers::pi / 180.0;
  std::vector<double> phases = swept(rows, sweep, place, contender, "phase", seed);
  for (double& phase : phases) phase *= one_degree;
  phases = unwrapped(std::move(phases));
  for (double& phase : phases) phase /= one_degree;
  return phases;
}

/// Adds rows with the bandwidths of the contenders: the frequencies at which the gain falls below
/// -3 dB, and the phase below -90 degrees.
void add_bandwidths(const std::vector<TestPlace>& places, int seeds, std::vector<FigureRow>& rows) {
  const std::size_t count = contenders().size();
  for (std::size_t p = 0; p < places.size(); ++p) {
    const SineSweep sweep = sweep_of(places[p]);
    for (std::size_t c = 0; c < count; ++c) {
      FigureRow gain{p, "sine sweep", "bandwidth_3db", c, {}},
          phase{p, "sine sweep", "bandwidth_90deg", c, {}};
      const auto note = [&](FigureRow& row, const Bandwidth& found) {
        row.values.push_back(found.frequency);
        if (found.bound != Bandwidth::Bound::None)
          row.note = found.bound == Bandwidth::Bound::Above
                         ? "or above; this is the highest frequency of the sweep"
                         : "or below; this is the lowest frequency of the sweep";
      };
      for (std::size_t seed = 0; seed < to_size(seeds); ++seed) {
        note(gain, falls_below(sweep.frequencies, swept(rows, sweep, p, c, "gain", seed),
                               20.0 * std::log10(std::numbers::sqrt2 / 2.0)));
        note(phase, falls_below(sweep.frequencies, phases_of(rows, sweep, p, c, seed), -90.0));
      }
      rows.push_back(std::move(gain));
      rows.push_back(std::move(phase));
    }
  }
}

/// Returns a table with a row for every statistic and contender. The table allows comparisons with
/// other controllers.
ResultTable figures_table(const ExperimentSpec& spec, const std::vector<TestPlace>& places,
                          const std::vector<FigureRow>& rows, int seeds) {
  ResultTable table{.name = "figures", .title = "Every figure", .for_people = false};
  table.columns = {{"robot"}, {"surface"}, {"test"}, {"figure"}, {"unit"}, {"controller"}};
  for (int seed = 0; seed < seeds; ++seed)
    table.columns.push_back({"seed " + std::to_string(spec.first_seed + seed)});
  for (const char* name : {"mean", "worst"}) table.columns.push_back({name});
  table.columns.push_back({"note"});
  const std::vector<Contender> all = contenders();
  for (const FigureRow& row : rows) {
    const std::string unit = row.figure.empty() ? "" : force_figure(row.figure).unit;
    std::vector<ResultCell> cells{
        places[row.place].robot, places[row.place].surface, row.test, row.figure, unit,
        all[row.contender].name};
    for (const double value : row.values) cells.emplace_back(value);
    cells.emplace_back(mean_of(row.values));
    cells.emplace_back(row.figure.empty() ? RunFigures::none : worst_of(row));
    cells.emplace_back(row.note);
    table.add(std::move(cells));
  }
  return table;
}

/// Returns a table with a row for every statistic; each contender has columns for mean and worst
/// value.
ResultTable summary_table(const std::vector<TestPlace>& places, const std::vector<FigureRow>& rows,
                          std::size_t place) {
  const std::vector<Contender> all = contenders();
  const bool several = places.size() > 1;
  ResultTable table{.name = several ? "summary_" + std::to_string(place + 1) : "summary",
                    .title = "Mean and worst over the runs: " + places[place].robot + ", " +
                             places[place].surface};
  table.columns = {{"test"}, {"figure"}, {"unit"}};
  for (const Contender& contender : all) {
    table.columns.push_back({contender.name, "", 2});
    table.columns.push_back({"worst", "", 2});
  }
  std::vector<std::pair<std::string, std::string>> seen;
  for (const FigureRow& row : rows) {
    if (row.place != place || row.figure.empty()) continue;
    const std::pair<std::string, std::string> key{row.test, row.figure};
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) continue;
    seen.push_back(key);
    std::vector<ResultCell> cells{row.test, row.figure, force_figure(row.figure).unit};
    for (std::size_t c = 0; c < all.size(); ++c) {
      const FigureRow* of = find_row(rows, place, c, row.test, row.figure);
      cells.emplace_back(of != nullptr ? mean_of(of->values) : RunFigures::none);
      cells.emplace_back(of != nullptr ? worst_of(*of) : RunFigures::none);
    }
    table.add(std::move(cells));
  }
  return table;
}

ResultTable tests_table(const TestPlace& place) {
  ResultTable table{.name = "tests", .title = "Tests"};
  table.columns = {{"test"}, {"what is done"}};
  for (const ForceTest& test : place.tests)
    if (!test.meaning.empty())
      table.add({test.frequency > 0.0 ? std::string("sine sweep") : test.name, test.meaning});
  return table;
}

ResultTable meanings_table() {
  ResultTable table{.name = "meanings", .title = "Figures"};
  table.columns = {{"figure"}, {"unit"}, {"meaning"}};
  for (const ForceFigure& figure : force_figures())
    table.add({figure.name, figure.unit, figure.meaning});
  return table;
}

/// Returns the plot of force responses in some tests, for the first seed.
Figure responses(const std::vector<TestPlace>& places, const std::vector<ForceRun>& entries,
                 const std::vector<RunFigures>& runs) {
  Figure figure{.name = "responses", .plot = {.title = "Force, first seed", .columns = 2}};
  figure.plot.panel_width = 560;
  for (std::size_t t = 0; t < places[0].tests.size(); ++t) {
    const ForceTest& test = places[0].tests[t];
    if (!test.has_curve) continue;
    Panel panel{.title = test.name,
                .x_label = "time since the start of the path [s]",
                .y_label = "force, mean over 10 ms [N]"};
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (entries[i].place != 0 || entries[i].test != t || !runs[i].curves) continue;
      const Curve& kept = runs[i].curves->force;
      Curve curve = extremes(kept.x, kept.y, 250);
      curve.name = kept.name;
      curve.color = static_cast<int>(entries[i].contender);
      panel.curves.push_back(std::move(curve));
    }
    const int points = test.task.force_profile.is_constant() ? 2 : 400;
    Curve wanted{.name = "target", .x = {}, .y = {}, .color = 6, .dashed = true};
    wanted.x = Eigen::VectorXd::LinSpaced(points, 0.0, test.task.polish_duration);
    wanted.y = wanted.x.unaryExpr(
        [&](double time) { return test.task.force_profile.at(test.task.force, time); });
    panel.curves.push_back(std::move(wanted));
    figure.plot.panels.push_back(std::move(panel));
  }
  return figure;
}

/// Returns the plot of gain and phase over frequency, for the first place and seed.
Figure frequency_response(const std::vector<TestPlace>& places,
                          const std::vector<FigureRow>& rows) {
  Figure figure{.name = "frequency_response",
                .plot = {.title = "Force relative to its target, first seed", .columns = 2}};
  figure.plot.panel_width = 560;
  const SineSweep sweep = sweep_of(places[0]);
  const auto size = static_cast<Eigen::Index>(sweep.frequencies.size());
  Panel gain{.title = "Gain", .x_label = "log10 of the frequency in Hz", .y_label = "gain [dB]"};
  Panel phase{.title = "Phase", .x_label = gain.x_label, .y_label = "phase [deg]"};
  const std::vector<Contender> all = contenders();
  for (std::size_t c = 0; c < all.size(); ++c) {
    const std::vector<double> gains = swept(rows, sweep, 0, c, "gain", 0),
                              phases = phases_of(rows, sweep, 0, c, 0);
    for (auto& [panel, values] : {std::pair(&gain, gains), std::pair(&phase, phases)}) {
      Curve curve{.name = all[c].name, .x = {}, .y = {}, .color = static_cast<int>(c)};
      curve.x = Eigen::Map<const Eigen::VectorXd>(sweep.frequencies.data(), size).array().log10();
      curve.y = Eigen::Map<const Eigen::VectorXd>(values.data(), size);
      panel->curves.push_back(std::move(curve));
    }
  }
  figure.plot.panels = {std::move(gain), std::move(phase)};
  return figure;
}

/// Adds findings about runs that did not complete, and about statistics that some runs lack.
void note_rows(const std::vector<FigureRow>& rows, ExperimentReport& report) {
  const std::vector<Contender> all = contenders();
  for (const FigureRow& row : rows) {
    const std::string who = all[row.contender].name + ", " + row.test;
    if (row.figure.empty())
      report.findings.push_back(who + ": no figures; " + row.note + ".");
    else if (!row.note.empty())
      report.findings.push_back(who + ", " + row.figure + ": " + row.note + ".");
    const auto lacking = std::count_if(row.values.begin(), row.values.end(),
                                       [](double value) { return !std::isfinite(value); });
    if (!row.figure.empty() && lacking > 0)
      report.findings.push_back(who + ", " + row.figure + ": not reached in " +
                                std::to_string(lacking) + " of " +
                                std::to_string(row.values.size()) + " runs.");
  }
}

}  // namespace

ExperimentReport perform_force_test(const ExperimentSpec& spec) {
  ExperimentReport report{.title = "Tests of force control"};
  const int seeds = seeds_of(spec, spec.quick ? 1 : 5);
  const std::vector<TestPlace> places = places_of(spec);
  const std::vector<ForceRun> entries = entries_of(places, seeds);
  std::vector<BatchRun> runs;
  for (const ForceRun& entry : entries) runs.push_back(run_of(spec, places[entry.place], entry));
  const std::vector<RunFigures> figures = run_batch(spec, runs);
  if (!spec.reports()) return report;
  std::vector<FigureRow> rows = rows_of(places, entries, figures, seeds);
  add_bandwidths(places, seeds, rows);
  report.tables = {figures_table(spec, places, rows, seeds)};
  for (std::size_t place = 0; place < places.size(); ++place)
    report.tables.push_back(summary_table(places, rows, place));
  report.tables.push_back(tests_table(places[0]));
  report.tables.push_back(meanings_table());
  report.figures = {responses(places, entries, figures), frequency_response(places, rows)};
  note_rows(rows, report);
  note_failures(spec, figures, report);
  return report;
}

}  // namespace burnish::polishing
