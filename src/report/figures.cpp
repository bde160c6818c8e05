#include "report/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace burnish {
namespace {

std::string formatted(const char* format, double value) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// Returns the value of a figure in the unit for tables, as text.
std::string shown(const ShownFigure& figure) {
  if (!std::isfinite(figure.value)) return "-";
  const double value = figure.entry.unit.factor * figure.value, size = std::abs(value);
  if (figure.entry.digits == 0) return formatted("%.0f", value);
  const bool extreme = (size != 0.0 && size < 0.01) || size >= 1e6;
  return formatted(extreme ? "%.2e" : size < 10.0 ? "%.3f" : "%.2f", size == 0.0 ? 0.0 : value);
}

/// Returns the text that replaces "{mean}" in the meanings of figures: the averaging time, or
/// nothing without averaging.
std::string mean_of(const std::optional<Metrics>& metrics) {
  if (!metrics || metrics->average <= 0.0) return "";
  return formatted("'s mean over %.4g ms", 1e3 * metrics->average);
}

std::string padded(const std::string& word, std::size_t width, bool left) {
  const std::string blanks(width - std::min(width, word.size()), ' ');
  return left ? word + blanks : blanks + word;
}

std::size_t widest(const std::vector<std::string>& words) {
  std::size_t width = 0;
  for (const std::string& word : words) width = std::max(width, word.size());
  return width;
}

/// Returns lines with the columns side by side. The first `left` columns are aligned left, the
/// others right.
std::string side_by_side(const std::vector<std::vector<std::string>>& columns, std::size_t left) {
  std::string text;
  for (std::size_t line = 0; line < columns.front().size(); ++line) {
    for (std::size_t i = 0; i < columns.size(); ++i)
      text += (i == 0 ? "" : "  ") + padded(columns[i][line], widest(columns[i]), i < left);
    text += '\n';
  }
  return text;
}

}  // namespace

std::string described_as(const FigureEntry& entry) {
  std::string text = *entry.unit.unit ? "{" + std::string(entry.unit.unit) + "}, " : "";
  text += entry.meaning;
  if (const std::size_t at = text.find("{mean}"); at != std::string::npos)
    text.replace(at, 6, "'s moving mean");
  return text;
}

std::vector<ShownFigure> shown_figures(const std::optional<Metrics>& metrics) {
  const Metrics all = metrics.value_or(Metrics{});
  const std::optional<SolverFigures>& solver = all.solver;
  std::vector<ShownFigure> figures;
  const auto add = [&](const FigureEntry& entry, const std::string& name, double value) {
    std::string meaning = entry.meaning;
    if (const std::size_t at = meaning.find("{mean}"); at != std::string::npos)
      meaning.replace(at, 6, mean_of(metrics));
    if (*entry.label) figures.push_back({entry, name, std::move(meaning), value});
  };
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  each_metric([&](const FigureEntry& entry, auto member) {
    if constexpr (std::same_as<decltype(member), std::string Metrics::*>) {
      if (!(all.*member).empty()) figures.back().meaning += ": " + all.*member;
    } else {
      add(entry, entry.name, metrics ? figure_value(all.*member) : none);
    }
  });
  each_solver_figure([&](const FigureEntry& entry, auto member) {
    add(entry, std::string("solver.") + entry.name, solver ? figure_value(*solver.*member) : none);
  });
  return figures;
}

std::string metrics_table(const std::vector<NamedMetrics>& runs) {
  if (runs.empty()) return "";
  const bool any_solver = std::any_of(runs.begin(), runs.end(), [](const NamedMetrics& run) {
    return run.metrics.solver.has_value();
  });
  const auto listed = [&](const ShownFigure& figure) { return any_solver || !figure.of_solver(); };
  std::vector<std::vector<std::string>> columns{{"figure"}, {""}};
  for (const ShownFigure& figure : shown_figures({})) {
    if (!listed(figure)) continue;
    columns[0].push_back(figure.name);
    columns[1].emplace_back(figure.entry.unit.shown);
  }
  for (const NamedMetrics& run : runs) {
    columns.push_back({run.name});
    for (const ShownFigure& figure : shown_figures(run.metrics))
      if (listed(figure)) columns.back().push_back(shown(figure));
  }
  return side_by_side(columns, 2);
}

std::string metrics_text(const Metrics& metrics) {
  std::vector<std::vector<std::string>> columns(4);
  for (const ShownFigure& figure : shown_figures(metrics)) {
    if (!metrics.solver && figure.of_solver()) continue;
    columns[0].push_back(figure.name);
    columns[1].push_back(shown(figure));
    columns[2].emplace_back(figure.entry.unit.shown);
    columns[3].push_back(figure.meaning);
  }
  std::string text = "window " + formatted("%.3f", metrics.start) + " s to " +
                     formatted("%.3f", metrics.end) + " s, " + std::to_string(metrics.rows) +
                     " rows\n";
  for (std::size_t line = 0; line < columns[0].size(); ++line)
    text += padded(columns[0][line], widest(columns[0]), true) + "  " +
            padded(columns[1][line], widest(columns[1]), false) + " " +
            padded(columns[2][line], 4, true) + columns[3][line] + '\n';
  return text;
}

PageMetric page_metric(const ShownFigure& figure) {
  // The page itself chooses the unit prefixes of lengths and times, such as mm. It expects
  // fractions in percent and angles in degrees.
  const FigureUnit& unit = figure.entry.unit;
  const bool is_shown = (!*unit.unit && *unit.shown) || std::string_view(unit.shown) == "deg";
  std::optional<double> value;
  if (std::isfinite(figure.value)) value = is_shown ? unit.factor * figure.value : figure.value;
  return {figure.name, figure.entry.label, value,
          is_shown     ? unit.shown
          : *unit.unit ? unit.unit
                       : "1",
          figure.meaning};
}

std::vector<PageMetric> page_metrics(const std::optional<Metrics>& metrics) {
  std::vector<PageMetric> result;
  for (const ShownFigure& figure : shown_figures(metrics)) result.push_back(page_metric(figure));
  return result;
}

std::vector<PageMetric> page_metrics(const StandingFigures& figures) {
  std::vector<PageMetric> result;
  each_standing_figure([&](const FigureEntry& entry, auto member) {
    result.push_back(page_metric({entry, std::string("standing.") + entry.name, entry.meaning,
                                  figure_value(figures.*member)}));
  });
  return result;
}

std::string standing_table(const std::vector<NamedStanding>& runs) {
  if (runs.empty()) return "";
  std::vector<std::vector<std::string>> columns{{"figure"}, {""}};
  each_standing_figure([&](const FigureEntry& entry, auto) {
    columns[0].push_back(std::string("standing.") + entry.name);
    columns[1].emplace_back(entry.unit.shown);
  });
  for (const NamedStanding& run : runs) {
    columns.push_back({run.name});
    each_standing_figure([&](const FigureEntry& entry, auto member) {
      columns.back().push_back(
          shown({entry, entry.name, entry.meaning, figure_value(run.figures.*member)}));
    });
  }
  return side_by_side(columns, 2);
}

}  // namespace burnish
