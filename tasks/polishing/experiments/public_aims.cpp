#include "polishing/experiments/public_aims.hpp"

#include <algorithm>

namespace burnish::polishing {

void PublicAim::count(const std::string& robot, bool meets) {
  ++all;
  if (meets)
    ++met;
  else
    missed.push_back(robot);
}

PublicReport::PublicReport() {
  runs_.columns = {{"robot"},
                   {"where"},
                   {"run"},
                   {"mass", "kg", 1},
                   {"force", "N", 0},
                   {"rotors"},
                   {"predicted_delay", "ms", 1},
                   {"seed", "", 0}};
  for (const ResultColumn& column : run_columns()) runs_.columns.push_back(column);
}

void PublicReport::add_run(const std::string& robot, const std::string& where,
                           const std::string& run, const RunFigures& figures) {
  std::vector<ResultCell> row{robot,
                              where,
                              run,
                              measured(figures, public_figures::mass),
                              measured(figures, public_figures::force),
                              rotors_text(figures),
                              1e3 * measured(figures, public_figures::delay),
                              static_cast<double>(figures.seed)};
  for (ResultCell& cell : run_cells(figures)) row.push_back(std::move(cell));
  runs_.add(std::move(row));
}

void PublicReport::write(ExperimentReport& report) const {
  report.tables.insert(report.tables.begin(), runs_);
  ResultTable table{.name = "aims", .title = "Aims"};
  table.columns = {{"aim"}, {"where"}, {"met", "", 0}, {"of", "", 0}, {"missed by"}};
  int met = 0, all = 0;
  for (const PublicAim& aim : aims_) {
    if (aim.all == 0) continue;
    std::string missed;
    for (const std::string& robot : aim.missed) missed += (missed.empty() ? "" : "; ") + robot;
    table.add({aim.what, aim.where, static_cast<double>(aim.met), static_cast<double>(aim.all),
               missed.empty() ? std::string("-") : missed});
    ++all;
    met += aim.missed.empty() ? 1 : 0;
  }
  report.findings.push_back(std::to_string(met) + " of " + std::to_string(all) +
                            " aims are met by every robot.");
  report.tables.push_back(std::move(table));
  if (untried_.empty()) return;
  ResultTable others{.name = "others", .title = "Robots that cannot do the task, and why"};
  others.columns = {{"robot"}, {"where"}, {"reason"}};
  for (const UntriedRobot& each : untried_) {
    others.add({each.robot, each.where, each.reason});
    report.failures.push_back(each.robot + ", " + each.where + ": " + each.reason);
  }
  report.tables.push_back(std::move(others));
}

double measured(const RunFigures& run, const std::string& figure) {
  for (const MeasuredFigure& each : run.measured)
    if (each.figure == figure) return each.value;
  return RunFigures::none;
}

std::string rotors_text(const RunFigures& run) {
  if (measured(run, public_figures::rotors) > 0.0) return "assumed";
  return measured(run, public_figures::light) > 0.0 ? "missing" : "-";
}

std::vector<RunFigures> chosen(const std::vector<RunFigures>& runs,
                               const std::vector<std::size_t>& numbers) {
  std::vector<RunFigures> some;
  for (const std::size_t number : numbers) some.push_back(runs[number]);
  return some;
}

bool all_made(const std::vector<RunFigures>& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const RunFigures& run) { return run.made; });
}

int polished_of(const std::vector<RunFigures>& runs) {
  return static_cast<int>(
      std::count_if(runs.begin(), runs.end(), [](const RunFigures& run) { return run.succeeded; }));
}

std::string refusal_of(const std::vector<RunFigures>& runs) {
  return !runs.empty() && runs.front().refused ? runs.front().outcome : std::string();
}

}  // namespace burnish::polishing
