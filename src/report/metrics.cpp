#include "burnish/report/metrics.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/mpc/controller.hpp"
#include "report/moving_mean.hpp"

namespace burnish {
namespace {

/// Duration of the impact after the first contact, as documented for impact_peak [s].
constexpr double impact_time = 0.05;

/// Rows of a trace in a time window.
struct Window {
  int first, last;  ///< First row, and row after the last row
  int size() const { return last - first; }
};

Window window_of(const Trace::Column& time, double start, double end) {
  // Tolerance for rounding errors of times [s]: a window from 3 s must include the row at 3 s.
  constexpr double slack = 5e-10;
  Window result{0, static_cast<int>(time.size())};
  while (result.first < result.last && time[result.first] < start - slack) ++result.first;
  while (result.last > result.first && time[result.last - 1] > end + slack) --result.last;
  return result;
}

/// Three columns of a trace as one vector per row.
class Vectors {
 public:
  Vectors(const Trace& trace, const std::string& what, const std::string& frame)
      : Vectors(trace, what + "_x_" + frame, what + "_y_" + frame, what + "_z_" + frame) {}
  Vectors(const Trace& trace, const std::string& x, const std::string& y, const std::string& z)
      : x_(trace.column(x)), y_(trace.column(y)), z_(trace.column(z)) {}
  Eigen::Vector3d operator[](int row) const { return {x_[row], y_[row], z_[row]}; }

 private:
  Trace::Column x_, y_, z_;
};

double rms(const Eigen::VectorXd& x) {
  return std::sqrt(x.squaredNorm() / static_cast<double>(x.size()));
}

/// Returns the smallest entry that at least `fraction` of all entries do not exceed.
double percentile(std::vector<double> x, double fraction) {
  const auto rank = to_size(std::ceil(fraction * static_cast<double>(x.size())));
  const std::size_t at = std::min(std::max<std::size_t>(rank, 1), x.size()) - 1;
  std::nth_element(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(at), x.end());
  return x[at];
}
double percentile(const Eigen::VectorXd& x, double fraction) {
  return percentile(std::vector<double>(x.data(), x.data() + x.size()), fraction);
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& turned) {
  const double angle = turned.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turned / angle).toRotationMatrix();
}

/// Surface normal in every row: either one normal for all rows, or the columns of the trace.
class Normals {
 public:
  Normals(const Trace& trace, const std::optional<Eigen::Vector3d>& given) {
    if (given) {
      fixed_ = given->normalized();
    } else {
      rows_.emplace(trace, "surface_normal", "world");
    }
  }
  Eigen::Vector3d operator[](int row) const { return rows_ ? (*rows_)[row] : fixed_; }

 private:
  Eigen::Vector3d fixed_ = Eigen::Vector3d::UnitZ();
  std::optional<Vectors> rows_;
};

/// Returns the component of the vector `what` along the normal in every row.
Eigen::VectorXd along(const Trace& trace, const std::string& what, const Normals& normals) {
  const Vectors force(trace, what, "world");
  Eigen::VectorXd result(trace.rows());
  for (int row = 0; row < trace.rows(); ++row) result[row] = normals[row].dot(force[row]);
  return result;
}

void measure_force(const Trace& trace, const MetricsSpec& spec, const Window& window,
                   const Normals& normals, Metrics& metrics) {
  const Trace::Column time = trace.column("time");
  const Eigen::VectorXd target = trace.column("target_force");
  const Eigen::VectorXd force = along(trace, "tool_force", normals);
  const double dt = trace.rows() > 1 ? time[1] - time[0] : 1.0;
  const int width = samples_in(spec.average, dt);
  const Eigen::VectorXd smooth = moving_mean(force, width);
  metrics.average = width > 1 ? width * dt : 0.0;
  const int first = window.first, n = window.size();
  const Eigen::VectorXd error = (smooth - target).segment(first, n);
  const Eigen::VectorXd raw = (force - target).segment(first, n);
  metrics.force_mean = force.segment(first, n).mean();
  metrics.force_mae = error.cwiseAbs().mean();
  metrics.force_rmse = rms(error);
  metrics.force_peak = error.cwiseAbs().maxCoeff();
  metrics.force_rmse_raw = rms(raw);
  metrics.force_peak_raw = raw.cwiseAbs().maxCoeff();
  metrics.estimate_rmse = rms((along(trace, "estimated_force", normals) - force).segment(first, n));
  const Trace::Column in_contact = trace.column("in_contact");
  metrics.without_contact = 1.0 - in_contact.segment(first, n).mean();

  const Trace::Column phase = trace.column("phase");
  for (int row = 0, touched = -1; row < trace.rows(); ++row) {
    if (touched < 0 && in_contact[row] != 0.0) touched = row;
    if (touched >= 0 && time[row] <= time[touched] + impact_time)
      metrics.impact_peak = std::max(metrics.impact_peak.value_or(0.0), force[row]);
    if (row < first && phase[row] == phase[first])
      metrics.overshoot =
          std::max({metrics.overshoot.value_or(0.0), smooth[row] - target[row], 0.0});
  }
}

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

void measure_motion(const Trace& trace, const MetricsSpec& spec, const Window& window,
                    const Normals& normals, Metrics& metrics) {
  const Vectors tool(trace, "tool", "world"), target(trace, "target", "world");
  const Vectors turned(trace, "tool_rx_start", "tool_ry_start", "tool_rz_start");
  const Eigen::Matrix3d start = rotation_of(turned[window.first]);
  const Vectors estimated(trace, "estimated_normal", "world");
  Eigen::VectorXd error(window.size());
  double squares = 0.0;
  for (int row = window.first; row < window.last; ++row) {
    const Eigen::Vector3d off = tool[row] - target[row];
    const Eigen::Vector3d n = normals[row];
    error[row - window.first] = (off - n.dot(off) * n).norm();
    const double angle = angle_between(n, estimated[row]);
    squares += angle * angle;
    const Eigen::Matrix3d since_start = rotation_of(turned[row]);
    const Eigen::Matrix3d since = start.transpose() * since_start;
    metrics.orientation_drift =
        std::max(metrics.orientation_drift, std::abs(Eigen::AngleAxisd(since).angle()));
    if (!spec.tool_axis) continue;
    const Eigen::Vector3d axis = spec.tool_start_world * since_start * *spec.tool_axis;
    metrics.tool_to_normal =
        std::max(metrics.tool_to_normal.value_or(0.0), angle_between(axis, -n));
  }
  metrics.normal_error = std::sqrt(squares / window.size());
  metrics.position_mean = error.mean();
  metrics.position_rmse = rms(error);
  metrics.position_p95 = percentile(error, 0.95);
}

void measure_margins(const Trace& trace, const Model& model, const Window& window,
                     Metrics& metrics) {
  double joint_margin = std::numeric_limits<double>::infinity();
  for (int k = 0; k < model.nq; ++k) {
    const auto q = trace.column("q_" + model.q_name(k)).segment(window.first, window.size());
    const double margin =
        std::min(q.minCoeff() - model.q_lower[k], model.q_upper[k] - q.maxCoeff());
    if (!(margin < joint_margin)) continue;
    joint_margin = margin;
    metrics.tightest_joint = model.q_name(k);
  }
  metrics.joint_margin = joint_margin;
  for (int k = 0; k < model.nv; ++k) {
    if (!std::isfinite(model.effort_limit[k]) || model.effort_limit[k] <= 0.0) continue;
    const auto tau =
        trace.column("tau_applied_" + model.v_name(k)).segment(window.first, window.size());
    const double margin = 1.0 - tau.cwiseAbs().maxCoeff() / model.effort_limit[k];
    if (!metrics.tightest_torque.empty() && margin >= metrics.torque_margin) continue;
    metrics.torque_margin = margin;
    metrics.tightest_torque = model.v_name(k);
  }
  const auto limited = trace.column("limited_joints").segment(window.first, window.size());
  metrics.limited_torque = (limited.array() > 0.0).cast<double>().mean();
}

void measure_solver(const Trace& trace, const Window& window, Metrics& metrics) {
  const Trace::Column tick = trace.column("tick"), solve_time = trace.column("solve_time");
  const Trace::Column iterations = trace.column("iterations");
  const Trace::Column missed = trace.column("missed_deadline");
  const Trace::Column active = trace.column("active_constraints");
  const Trace::Column violation = trace.column("constraint_violation");
  const Trace::Column infeasible = trace.column("constraints_infeasible");
  const Trace::Column clipped = trace.column("clipped_torques");
  std::vector<double> times, violations;
  SolverFigures figures;
  for (int row = window.first; row < window.last; ++row) {
    figures.clipped += tick[row] != 0.0 && clipped[row] != 0.0 ? 1 : 0;
    if (tick[row] == 0.0 || solve_time[row] <= 0.0) continue;
    times.push_back(solve_time[row]);
    figures.mean_iterations += iterations[row];
    figures.missed_deadlines += missed[row] != 0.0 ? 1 : 0;
    figures.at_limits += active[row] != 0.0 ? 1 : 0;
    figures.infeasible += infeasible[row] != 0.0 ? 1 : 0;
    violations.push_back(violation[row]);
  }
  if (times.empty()) return;
  figures.updates = static_cast<int>(times.size());
  figures.mean_iterations /= static_cast<double>(times.size());
  figures.median = percentile(times, 0.5);
  figures.p99 = percentile(times, 0.99);
  figures.violation_p99 = percentile(violations, 0.99);
  figures.constraint_violation = *std::max_element(violations.begin(), violations.end());
  figures.maximum = *std::max_element(times.begin(), times.end());
  metrics.solver = figures;
}

}  // namespace

Metrics measure(const Trace& trace, const Model& model, const MetricsSpec& spec) {
  if (spec.normal_world && !(spec.normal_world->allFinite() && spec.normal_world->norm() > 1e-9))
    throw Error("the surface's normal has no direction; wanted a vector that is not zero");
  if (spec.tool_axis && !(spec.tool_axis->allFinite() && spec.tool_axis->norm() > 1e-9))
    throw Error("the tool's axis has no direction; wanted the direction in which it presses");
  const Trace::Column time = trace.column("time");
  const Window window = window_of(time, spec.start, spec.end);
  if (window.size() == 0)
    throw Error("no row of the trace is between " + number(spec.start) + " s and " +
                number(spec.end) + " s; wanted a window within the run");
  const Normals normals(trace, spec.normal_world);
  Metrics metrics;
  metrics.start = time[window.first];
  metrics.end = time[window.last - 1];
  metrics.rows = window.size();
  measure_force(trace, spec, window, normals, metrics);
  measure_motion(trace, spec, window, normals, metrics);
  measure_margins(trace, model, window, metrics);
  measure_solver(trace, window, metrics);
  return metrics;
}

}  // namespace burnish
