#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"
#include "burnish/report/svg_plot.hpp"
#include "record/solution.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* time_axis = "time [s]";

Curve curve(const Trace& trace, const std::string& column, const std::string& name) {
  return {.name = name, .x = trace.column("time"), .y = trace.column(column)};
}

bool has_values(const Eigen::VectorXd& values) {
  return std::any_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

/// Groups the columns that begin with `prefix` into panels of at most seven curves, the number of
/// colors that a palette distinguishes.
std::vector<Panel> grouped(const Trace& trace, const std::string& prefix, const std::string& unit,
                           const std::string& title, const std::string& label) {
  constexpr std::size_t max_curves = 7;
  std::vector<std::string> columns;
  for (const TraceColumn& column : trace.columns())
    if (column.name.rfind(prefix, 0) == 0 && column.unit == unit) columns.push_back(column.name);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i % max_curves == 0)
      panels.push_back({.title = i == 0 ? title : "", .x_label = time_axis, .y_label = label});
    panels.back().curves.push_back(curve(trace, columns[i], columns[i].substr(prefix.size())));
  }
  return panels;
}

PlotSpec states(const Trace& trace) {
  PlotSpec plot{.title = "States"};
  const auto add = [&](const char* prefix, const char* unit, const char* title) {
    for (Panel& panel : grouped(trace, prefix, unit, title, fmt::format("[{}]", unit)))
      plot.panels.push_back(std::move(panel));
  };
  add("q_", "m", "position");
  add("q_", "rad", "joint angle");
  add("q_", "-", "cosine and sine, or quaternion");
  add("v_", "m/s", "velocity");
  add("v_", "rad/s", "angular velocity");
  return plot;
}

/// Plots the torques, one panel per joint. Limits are drawn if the torque exceeds half of a limit.
PlotSpec torques(const Problem& problem, const Trace& trace) {
  PlotSpec plot{.title = "Torques (dashed: control, where it differs)", .columns = 2};
  plot.panel_width = 460;
  plot.panel_height = 190;
  const Model& model = problem.model();
  const double* bounds[] = {problem.control_lower(0), problem.control_upper(0)};
  int control = -1;
  for (const int k : problem.layout().actuated) {
    ++control;
    const std::string name = model.v_name(k);
    const TraceColumn& column = trace.columns()[to_size(trace.index("tau_" + name))];
    Panel panel{.x_label = time_axis, .y_label = fmt::format("[{}]", column.unit)};
    panel.curves.push_back(curve(trace, "tau_" + name, ""));
    double largest = 0.0;
    for (const double tau : panel.curves[0].y)
      if (std::isfinite(tau)) largest = std::max(largest, std::abs(tau));
    if (problem.layout().filtered > 0) {
      panel.curves.push_back(curve(trace, "u_" + name, ""));
      panel.curves.back().dashed = true;
    }
    double limit = model.effort_limit[k];
    for (const double* bound : bounds)
      if (bound != nullptr) limit = std::min(limit, std::abs(bound[control]));
    panel.title = name;
    if (std::isfinite(limit) && limit > 0.0) {
      panel.title +=
          fmt::format(": at most {:.0f} % of {:g} {}", 100.0 * largest / limit, limit, column.unit);
      for (const double side : {-limit, limit})
        if (largest > 0.5 * limit)
          panel.curves.push_back({.x = panel.curves[0].x,
                                  .y = Eigen::VectorXd::Constant(panel.curves[0].x.size(), side),
                                  .color = 6,
                                  .dashed = true});
    }
    plot.panels.push_back(std::move(panel));
  }
  return plot;
}

PlotSpec forces(const Problem& problem, const Trace& trace) {
  PlotSpec plot{.title = "Contact forces on the robot (dashed: targets)"};
  const PlotSignals wanted = followed(problem.spec());
  for (const ContactSpec& contact : problem.spec().contacts) {
    const std::string name = contact.name.empty() ? contact.tool : contact.name;
    for (const bool moment : {false, true}) {
      const std::string prefix = name + (moment ? "_moment_" : "_force_");
      Panel panel{.title = fmt::format("{}, {} axes", name, contact.reference.name()),
                  .x_label = time_axis,
                  .y_label = moment ? "moment [Nm]" : "force [N]"};
      int color = 0;
      for (const std::string& column : wanted.forces) {
        if (column.rfind(prefix, 0) != 0) continue;
        panel.curves.push_back(curve(trace, column, column.substr(prefix.size(), 1)));
        panel.curves.back().color = color;
        Curve target = curve(trace, column + "_target", "");
        target.color = color++;
        target.dashed = true;
        if (has_values(target.y)) panel.curves.push_back(std::move(target));
      }
      if (!panel.curves.empty()) plot.panels.push_back(std::move(panel));
    }
  }
  return plot;
}

PlotSpec paths(const Problem& problem, const Trace& trace) {
  PlotSpec plot{.title = "Paths of frames, world (dashed: targets)", .columns = 2};
  plot.panel_width = 460;
  plot.panel_height = 340;
  for (const std::string& frame : followed(problem.spec()).frames) {
    const auto column = [&](char axis, const char* more) {
      return fmt::format("{}_{}_world{}", frame, axis, more);
    };
    for (const auto& [a, b] : {std::pair{'x', 'y'}, {'x', 'z'}}) {
      Panel panel{.title = fmt::format("{}, {} and {}", frame, a, b),
                  .x_label = fmt::format("{} [m]", a),
                  .y_label = fmt::format("{} [m]", b),
                  .equal_aspect = true};
      for (const char* more : {"", "_target"})
        panel.curves.push_back({.x = trace.column(column(a, more)),
                                .y = trace.column(column(b, more)),
                                .dashed = *more != '\0'});
      plot.panels.push_back(std::move(panel));
    }
    Panel over_time{.title = frame, .x_label = time_axis, .y_label = "position [m]"};
    Panel error{.title = frame + ", distance from the target along weighted axes",
                .x_label = time_axis,
                .y_label = "[mm]"};
    int color = 0;
    for (const char axis : {'x', 'y', 'z'}) {
      over_time.curves.push_back(curve(trace, column(axis, ""), std::string(1, axis)));
      over_time.curves.back().color = color;
      over_time.curves.push_back(curve(trace, column(axis, "_target"), ""));
      over_time.curves.back().color = color++;
      over_time.curves.back().dashed = true;
    }
    error.curves.push_back(
        {.x = trace.column("time"), .y = 1e3 * trace.column(frame + "_distance_from_target")});
    plot.panels.push_back(std::move(over_time));
    if (has_values(error.curves[0].y)) plot.panels.push_back(std::move(error));
  }
  return plot;
}

/// Plots the rows with the largest multipliers over time. Each multiplier is multiplied by the
/// scale of its row, so that all curves have the unit of cost.
PlotSpec limits(const Problem& problem, const CostReport& report) {
  constexpr std::size_t most = 7;
  std::vector<CostReport::Row> rows = report.active_constraints();
  if (rows.empty()) return {};
  Panel panel{.x_label = time_axis, .y_label = "cost"};
  if (rows.size() > most) {
    panel.title =
        fmt::format("{} rows; the rows with the largest multipliers are shown", rows.size());
    rows.resize(most);
  }
  const int knots = problem.knots();
  for (const CostReport::Row& row : rows) {
    Curve row_curve{
        .name = row.name, .x = Eigen::VectorXd(knots + 1), .y = Eigen::VectorXd::Zero(knots + 1)};
    for (int k = 0; k <= knots; ++k) row_curve.x[k] = problem.time_of(k);
    for (const CostReport::ActiveLimit& limit : report.limits)
      if (limit.row == row.name) row_curve.y[limit.knot] = limit.multiplier * row.scale;
    panel.curves.push_back(std::move(row_curve));
  }
  return {.title = "Active constraints (multiplier of the row times its scale)", .panels = {panel}};
}

PlotSpec costs(const DdpSummary& summary) {
  PlotSpec plot{.title = "Iterations"};
  Curve cost, expected, gap;
  const auto size = static_cast<Eigen::Index>(summary.log.size());
  for (Curve* each : {&cost, &expected, &gap}) {
    each->x = Eigen::VectorXd::LinSpaced(size, 1.0, static_cast<double>(size));
    each->y.resize(size);
  }
  bool positive = true;
  for (Eigen::Index i = 0; i < size; ++i) {
    const DdpProgress& at = summary.log[to_size(i)];
    cost.y[i] = at.cost;
    expected.y[i] = at.expected_improvement;
    gap.y[i] = at.largest_gap;
    positive = positive && at.cost > 0.0;
  }
  const auto panel = [&](const char* title, const Curve& line, bool log) {
    plot.panels.push_back({.title = title, .x_label = "iteration", .curves = {line}, .log_y = log});
  };
  panel("cost", cost, positive);
  panel("expected improvement of the cost", expected, true);
  panel("largest gap", gap, true);
  return plot;
}

}  // namespace

std::vector<std::string> write_plots(const Problem& problem, const Trace& trace,
                                     const DdpSummary& summary, const CostReport& report,
                                     const fs::path& folder) {
  std::vector<std::string> names;
  const auto write = [&](const char* name, const PlotSpec& plot) {
    if (plot.panels.empty()) return;
    write_svg_plot(plot, folder / name);
    names.emplace_back(name);
  };
  write("states.svg", states(trace));
  write("torques.svg", torques(problem, trace));
  write("forces.svg", forces(problem, trace));
  write("path.svg", paths(problem, trace));
  write("limits.svg", limits(problem, report));
  write("cost.svg", costs(summary));
  return names;
}

}  // namespace burnish
