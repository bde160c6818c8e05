#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/degrees.hpp"
#include "burnish/report/metrics.hpp"

namespace burnish {
namespace {

struct Figure {
  std::string name, value, unit, meaning;
};

std::string text(double value) {
  char buffer[32];
  const double size = std::abs(value);
  const bool extreme = (size != 0.0 && size < 0.01) || size >= 1e6;
  const char* format = extreme ? "%.2e" : size < 10.0 ? "%.3f" : "%.2f";
  std::snprintf(buffer, sizeof buffer, format, size == 0.0 ? 0.0 : value);
  return buffer;
}
std::string text(const std::optional<double>& value) { return value ? text(*value) : "-"; }

std::string milliseconds(double time) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g ms", 1e3 * time);
  return buffer;
}

std::vector<Figure> figures_of(const Metrics& m) {
  const std::string force =
      m.average > 0.0 ? "force, mean over " + milliseconds(m.average) : std::string("force");
  std::vector<Figure> figures{
      {"force_mean", text(m.force_mean), "N", "mean normal force"},
      {"force_mae", text(m.force_mae), "N", "mean absolute error, " + force},
      {"force_rmse", text(m.force_rmse), "N", "root mean square error, " + force},
      {"force_peak", text(m.force_peak), "N", "largest error, " + force},
      {"rmse_raw", text(m.force_rmse_raw), "N", "root mean square error of every sample"},
      {"peak_raw", text(m.force_peak_raw), "N", "largest error of every sample"},
      {"estimate", text(m.estimate_rmse), "N", "root mean square error of the force estimate"},
      {"lost", text(100.0 * m.without_contact), "%", "time without contact"},
      {"impact", text(m.impact_peak), "N", "largest force within 50 ms of the first contact"},
      {"overshoot", text(m.overshoot), "N", "above the target, from ramp to window"},
      {"pos_mean", text(1e3 * m.position_mean), "mm", "mean distance to the path in the plane"},
      {"pos_rmse", text(1e3 * m.position_rmse), "mm", "root mean square distance"},
      {"pos_p95", text(1e3 * m.position_p95), "mm", "distance not exceeded 95 % of the time"},
      {"turned", text(degrees_per_radian * m.orientation_drift), "deg",
       "largest rotation of the tool"},
      {"joint", text(m.joint_margin), "rad", "smallest margin to a limit: " + m.tightest_joint},
      {"torque", text(100.0 * m.torque_margin), "%", "smallest margin: " + m.tightest_torque},
      {"limited", text(100.0 * m.limited_torque), "%", "time with a joint at its torque limit"}};
  if (!m.solver) return figures;
  const SolverFigures& s = *m.solver;
  figures.push_back({"solve_med", text(1e3 * s.median), "ms", "median time of a solve"});
  figures.push_back({"solve_p99", text(1e3 * s.p99), "ms", "99th percentile"});
  figures.push_back({"solve_max", text(1e3 * s.maximum), "ms", "longest"});
  figures.push_back({"iterations", text(s.mean_iterations), "-", "mean per solve"});
  figures.push_back({"missed", std::to_string(s.missed_deadlines), "-", "deadlines missed"});
  return figures;
}

std::string padded(const std::string& word, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, word.size()), ' ');
  return left ? word + blanks : blanks + word;
}

}  // namespace

std::string metrics_table(const std::vector<NamedMetrics>& runs) {
  std::vector<std::vector<Figure>> rows;
  std::size_t name_width = 4;
  const std::vector<Figure>* widest = nullptr;
  for (const NamedMetrics& run : runs) rows.push_back(figures_of(run.metrics));
  for (const std::vector<Figure>& row : rows)
    if (widest == nullptr || row.size() > widest->size()) widest = &row;
  if (widest == nullptr) return "";
  for (const NamedMetrics& run : runs) name_width = std::max(name_width, run.name.size());

  std::vector<std::string> lines(rows.size() + 2);
  lines[0] = padded("run", name_width, true);
  lines[1] = padded("", name_width, true);
  for (std::size_t r = 0; r < rows.size(); ++r)
    lines[r + 2] = padded(runs[r].name, name_width, true);
  for (std::size_t c = 0; c < widest->size(); ++c) {
    std::size_t width = (*widest)[c].name.size();
    for (const std::vector<Figure>& row : rows)
      if (c < row.size()) width = std::max(width, row[c].value.size());
    lines[0] += "  " + padded((*widest)[c].name, width, false);
    lines[1] += "  " + padded((*widest)[c].unit, width, false);
    for (std::size_t r = 0; r < rows.size(); ++r)
      lines[r + 2] += "  " + padded(c < rows[r].size() ? rows[r][c].value : "-", width, false);
  }
  std::string result;
  for (const std::string& line : lines) result += line + '\n';
  return result;
}

std::string metrics_text(const Metrics& metrics) {
  std::string result = "window " + text(metrics.start) + " s to " + text(metrics.end) + " s, " +
                       std::to_string(metrics.rows) + " rows\n";
  for (const Figure& figure : figures_of(metrics))
    result += padded(figure.name, 10, true) + padded(figure.value, 11, false) + " " +
              padded(figure.unit, 4, true) + figure.meaning + '\n';
  return result;
}

}  // namespace burnish
