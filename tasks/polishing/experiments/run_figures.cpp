#include "polishing/experiments/run_figures.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/degrees.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/tasks/polishing/posture.hpp"

namespace burnish::polishing {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool all_finite(const Trace& trace) {
  const int columns = static_cast<int>(trace.columns().size());
  for (int column = 0; column < columns; ++column)
    if (!trace.column(column).allFinite()) return false;
  return true;
}

/// Largest share of an effort limit that a torque column takes.
double largest_share(const Trace& trace, const Model& model, const std::string& what) {
  double share = 0.0;
  for (int k = 0; k < model.nv; ++k)
    if (std::isfinite(model.effort_limit[k]) && model.effort_limit[k] > 0.0 && trace.rows() > 0)
      share = std::max(share, trace.column(what + "_" + model.v_name(k)).cwiseAbs().maxCoeff() /
                                  model.effort_limit[k]);
  return share;
}

/// Largest angle on the path.
double tool_to_normal(const Task& task, const RunResult& result) {
  const Trace& trace = result.trace;
  const Eigen::Isometry3d start =
      frame_placement(result.setting.robot.model, result.setting.q_start, task.tool);
  const Eigen::Vector3d into = -result.setting.scene.surface.normal;
  const Eigen::Vector3d press = pressing_direction(task, result.setting.robot.model);
  const auto x = trace.column("tool_rx_start"), y = trace.column("tool_ry_start"),
             z = trace.column("tool_rz_start"), phase = trace.column("phase");
  double largest = none;
  for (int row = 0; row < trace.rows(); ++row) {
    if (phase[row] != static_cast<double>(Phase::Track)) continue;
    const Eigen::Vector3d turned(x[row], y[row], z[row]);
    Eigen::Isometry3d now = start;
    const double angle = turned.norm();
    if (angle > 0.0) now.rotate(Eigen::AngleAxisd(angle, turned / angle));
    const Eigen::Vector3d axis = now.linear() * press;
    const double off = std::atan2(axis.cross(into).norm(), axis.dot(into));
    if (!(largest >= off)) largest = off;
  }
  return largest;
}

std::vector<double> finite_of(const std::vector<double>& values) {
  std::vector<double> result;
  std::copy_if(values.begin(), values.end(), std::back_inserter(result),
               [](double value) { return std::isfinite(value); });
  return result;
}

}  // namespace

RunFigures::RunFigures()
    : force_mean(none),
      force_rmse(none),
      force_peak(none),
      force_error_mean(none),
      position_rmse(none),
      position_p95(none),
      lost(none),
      impact(none),
      overshoot(none),
      turned(none),
      joint_margin(none),
      tool_to_normal(none) {}

RunFigures figures_of(const std::string& name, const Task& task, const RunResult& result) {
  RunFigures f;
  f.name = name;
  f.outcome = result.outcome;
  // How long it took to simulate is another number every time.
  if (const auto at = f.outcome.find(", simulated in"); at != std::string::npos)
    f.outcome.erase(at);
  f.polished = result.polished;
  f.fault = result.fault.kind;
  f.seed = task.disturbances.seed;
  f.finite = all_finite(result.trace);
  const Model& model = result.setting.robot.model;
  f.torque_margin = 1.0 - largest_share(result.trace, model, "tau_applied");
  f.largest_command = largest_share(result.trace, model, "tau_command");
  const auto limited = result.trace.column("limited_joints");
  if (limited.size() > 0) f.limited = (limited.array() > 0.0).cast<double>().mean();
  if (!result.metrics) return f;
  const Metrics& m = *result.metrics;
  f.reached_path = true;
  f.force_mean = m.force_mean;
  f.force_rmse = m.force_rmse;
  f.force_peak = m.force_peak;
  f.force_error_mean = m.force_mean - task.force;
  f.position_rmse = m.position_rmse;
  f.position_p95 = m.position_p95;
  f.lost = m.without_contact;
  f.impact = m.impact_peak.value_or(none);
  f.overshoot = m.overshoot.value_or(none);
  f.turned = m.orientation_drift;
  f.joint_margin = m.joint_margin;
  f.tool_to_normal = tool_to_normal(task, result);
  return f;
}

std::vector<ResultColumn> run_columns() {
  return {{"polished"},
          {"force mean", "N"},
          {"force rmse", "N"},
          {"force peak", "N", 2},
          {"position rmse", "mm"},
          {"position p95", "mm"},
          {"lost", "%", 2},
          {"impact", "N", 1},
          {"overshoot", "N", 2},
          {"turned", "deg", 1},
          {"joint margin", "rad", 2},
          {"torque margin", "%", 1},
          {"at torque limit", "%", 2},
          {"largest command", "% of limit", 1},
          {"tool to normal", "deg", 1},
          {"outcome"}};
}

std::vector<ResultCell> run_cells(const RunFigures& run) {
  return {std::string(run.polished ? "yes" : "no"),
          run.force_mean,
          run.force_rmse,
          run.force_peak,
          1e3 * run.position_rmse,
          1e3 * run.position_p95,
          100.0 * run.lost,
          run.impact,
          run.overshoot,
          degrees_per_radian * run.turned,
          run.joint_margin,
          100.0 * run.torque_margin,
          100.0 * run.limited,
          100.0 * run.largest_command,
          degrees_per_radian * run.tool_to_normal,
          run.outcome};
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

double quantile_of(std::vector<double> values, double share) {
  values = finite_of(values);
  if (values.empty()) return none;
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(share * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

std::vector<double> collect(const std::vector<RunFigures>& runs, double RunFigures::*figure) {
  std::vector<double> values;
  for (const RunFigures& run : runs) values.push_back(run.*figure);
  return values;
}

}  // namespace burnish::polishing
