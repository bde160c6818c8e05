// Plots of a run: force over time, path along the surface, torques, solver.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "burnish/report/svg_plot.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "pressing/record.hpp"
#include "report/moving_mean.hpp"
#include "report/trace_curves.hpp"

namespace burnish::pressing {
namespace {

constexpr const char* time_axis = "time [s]";
constexpr int black = 6;

/// Returns the curve reduced to at most 3000 points.
Curve thinned(Curve curve) {
  constexpr Eigen::Index max_points = 3000;
  if (curve.x.size() <= max_points) return curve;
  Curve few = extremes(curve.x, curve.y, max_points / 2);
  curve.x = std::move(few.x);
  curve.y = std::move(few.y);
  return curve;
}

PlotSpec force_plot(const PlottedRun& run) {
  Trace storage;
  const Trace& trace = seen_from_surface(run.run.trace, storage);
  const Eigen::VectorXd time = trace.column("time"), force = along_normal(trace, "tool_force");
  const Eigen::VectorXd target = trace.column("target_force");
  const double dt = trace.rows() > 1 ? time[1] - time[0] : 1.0;
  const int width = samples_in(MetricsSpec{}.average, dt);
  const Eigen::VectorXd smooth = moving_mean(force, width);
  const std::string mean = width > 1 ? fmt::format("mean over {:g} ms", 1e3 * width * dt) : "true";
  const Eigen::VectorXd estimated = along_normal(trace, "estimated_force");
  PlotSpec plot{.title = "Normal force, " + run.name};
  plot.panel_width = 900;
  const auto panel = [&](const std::string& title, Eigen::Index first, Eigen::Index last,
                         bool with_raw) {
    Panel result_panel{.title = title, .x_label = time_axis, .y_label = "force [N]"};
    const auto add = [&](const std::string& name, const Eigen::VectorXd& y, int color,
                         bool dashed) {
      const Eigen::Index size = last - first;
      result_panel.curves.push_back(thinned({.name = name,
                                             .x = time.segment(first, size),
                                             .y = y.segment(first, size),
                                             .color = color,
                                             .dashed = dashed}));
    };
    if (with_raw && width > 1) add("true", force, 5, false);
    if (run.has_estimate) add("estimated", estimated, 4, false);
    add(mean, smooth, 0, false);
    add("target", target, black, true);
    plot.panels.push_back(std::move(result_panel));
  };
  panel("whole run", 0, time.size(), true);
  const auto [first, last] = rows_of_phase(trace, static_cast<double>(run.phase));
  // Excludes the last rows of the phase, because their moving mean contains rows of the retreat.
  const Eigen::Index inside = last - std::lround(0.01 / dt);
  if (inside - first > 1) panel(run.phase_title, first, inside, false);
  return plot;
}

PlotSpec path_plot(const PlottedRun& run) {
  Trace storage;
  const Trace& trace = seen_from_surface(run.run.trace, storage);
  const auto [first, last] = rows_of_phase(trace, static_cast<double>(run.phase));
  PlotSpec plot{.title = "Path of the tool in the surface, " + run.name, .columns = 2};
  plot.panel_width = 560;
  plot.panel_height = 480;
  if (last - first < 2) return plot;
  const Eigen::Index from = first, size = last - first;
  const auto coordinate = [&](const std::string& what, int tangent) {
    const Eigen::Vector3d t = run.surface_axes.col(tangent);
    const Eigen::VectorXd all = along(trace, what, t);
    return Eigen::VectorXd((all.segment(from, size).array() - t.dot(run.origin_world)) * 1e3);
  };
  const auto axis = [&](int tangent) {
    const Eigen::Vector3d t = run.surface_axes.col(tangent);
    return fmt::format("along ({:.2g}, {:.2g}, {:.2g}) [mm]", t.x(), t.y(), t.z());
  };
  Panel panel{.x_label = axis(0), .y_label = axis(1), .equal_aspect = true};
  const Eigen::Index every = std::max<Eigen::Index>(1, size / 4000);
  const auto some = [&](const Eigen::VectorXd& all) {
    return Eigen::VectorXd(all(Eigen::seq(0, Eigen::last, every)));
  };
  const Eigen::VectorXd u = coordinate("tool", 0), w = coordinate("tool", 1);
  const Eigen::VectorXd u_target = coordinate("target", 0), w_target = coordinate("target", 1);
  panel.curves.push_back({.name = "tool", .x = some(u), .y = some(w)});
  panel.curves.push_back(
      {.name = "target", .x = some(u_target), .y = some(w_target), .color = black, .dashed = true});
  plot.panels.push_back(std::move(panel));
  Panel off{.title = "distance from the target", .x_label = time_axis, .y_label = "[mm]"};
  off.curves.push_back(thinned({.x = trace.column("time").segment(from, size),
                                .y = 1e3 * off_target(trace).segment(from, size)}));
  plot.panels.push_back(std::move(off));
  return plot;
}

PlotSpec torque_plot(const PlottedRun& run) {
  const Trace& trace = run.run.trace;
  const Model& model = run.model;
  PlotSpec plot{.title = "Joint torques and their limits, " + run.name, .columns = 2};
  plot.panel_width = 460;
  plot.panel_height = 190;
  const Eigen::VectorXd time = trace.column("time");
  for (int k = 0; k < model.nv; ++k) {
    const std::string name = model.v_name(k);
    const Eigen::VectorXd tau = trace.column("tau_applied_" + name);
    const double limit = model.effort_limit[k], largest = tau.cwiseAbs().maxCoeff();
    Panel panel{.title = name, .x_label = time_axis, .y_label = "torque [Nm]"};
    panel.curves.push_back(thinned({.x = time, .y = tau}));
    if (std::isfinite(limit) && limit > 0.0) {
      panel.title += fmt::format(": at most {:.0f} % of {:g} Nm", 100.0 * largest / limit, limit);
      for (const double side : {-limit, limit})
        panel.curves.push_back({.x = Eigen::Vector2d(time[0], time[time.size() - 1]),
                                .y = Eigen::Vector2d(side, side),
                                .color = black,
                                .dashed = true});
    }
    plot.panels.push_back(std::move(panel));
  }
  return plot;
}

PlotSpec solver_plot(const PlottedRun& run) {
  const Trace& trace = run.run.trace;
  PlotSpec plot{.title = "Computing time per plan, " + run.name};
  plot.panel_width = 900;
  std::vector<double> x, y;
  const auto time = trace.column("time"), tick = trace.column("tick");
  const auto solve_time = trace.column("solve_time");
  for (Eigen::Index row = 0; row < time.size(); ++row) {
    if (tick[row] == 0.0 || solve_time[row] <= 0.0) continue;
    x.push_back(time[row]);
    y.push_back(1e3 * solve_time[row]);
  }
  if (x.empty()) return plot;
  const auto size = static_cast<Eigen::Index>(x.size());
  Panel panel{.title = "the first plan, at rest, is solved to convergence",
              .x_label = time_axis,
              .y_label = "time [ms]",
              .log_y = true};
  panel.curves.push_back(thinned({.name = "plan",
                                  .x = Eigen::Map<Eigen::VectorXd>(x.data(), size),
                                  .y = Eigen::Map<Eigen::VectorXd>(y.data(), size)}));
  const double period = 1e3 * run.update_period;
  panel.curves.push_back({.name = "time between two plans",
                          .x = Eigen::Vector2d(x.front(), x.back()),
                          .y = Eigen::Vector2d(period, period),
                          .color = black,
                          .dashed = true});
  plot.panels.push_back(std::move(panel));
  return plot;
}

}  // namespace

std::vector<PlotFile> run_plots(const PlottedRun& run) {
  const auto made_by = [&](PlotSpec (*plot)(const PlottedRun&)) {
    return [plot, run] { return plot(run); };
  };
  std::vector<PlotFile> plots;
  if (run.run.trace.has("tool_force_x_world"))
    plots = {{"force.svg", made_by(force_plot)}, {"path.svg", made_by(path_plot)}};
  plots.push_back({"torques.svg", made_by(torque_plot)});
  plots.push_back({"solver.svg", made_by(solver_plot)});
  return plots;
}

}  // namespace burnish::pressing
