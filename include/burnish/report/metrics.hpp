// Metrics of a polishing run, computed from the trace of the run. The metrics are used to compare
// controllers.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Settings of measure(): time window and directions for the metrics of a trace.
/// @described report
struct MetricsSpec {
  /// Start of the time window [s]
  double start = 0.0;
  /// End of the time window [s]
  double end = std::numeric_limits<double>::infinity();
  /// Surface normal towards the robot, in world axes (none: the true normal at the tool, in each
  /// row of the trace)
  /// @more Forces are measured along the normal, position errors perpendicular to the normal. The
  /// normal may have any length except zero
  std::optional<Eigen::Vector3d> normal_world = {};
  /// Width of the centred moving average of the force (0: no average) [s]
  double average = 0.010;
  /// Direction in which the tool presses, in the tool's frame (none: Metrics.tool_to_normal is not
  /// computed)
  /// @more The vector may have any length except zero
  std::optional<Eigen::Vector3d> tool_axis = {};
  /// Axes of the tool at the start of the trace, as columns in world axes
  Eigen::Matrix3d tool_start_world = Eigen::Matrix3d::Identity();
};

/// Statistics of the solver over the plans that were computed in the time window.
struct SolverFigures {
  /// Number of plans
  int updates = 0;
  /// Duration of the computation of a plan [s]: median, 99th percentile and maximum
  double median = 0.0, p99 = 0.0, maximum = 0.0;
  /// Mean number of solver iterations per plan
  double mean_iterations = 0.0;
  /// Number of plans that missed their deadline
  int missed_deadlines = 0;
  /// Number of plans with active constraints
  int at_limits = 0;
  /// Number of plans that cannot satisfy all constraints
  int infeasible = 0;
  /// Largest violation of a hard constraint in a plan, as a fraction of the constraint's scale:
  /// 99th percentile and maximum over all plans
  double violation_p99 = 0.0, constraint_violation = 0.0;
  int clipped = 0;  ///< Number of control ticks with a torque clipped to its permitted range
};

/// Metrics of a run, in SI units. They are computed from the plant's true forces and positions.
/// Unless stated otherwise, they cover the time window of MetricsSpec.
struct Metrics {
  /// Times of the first and the last row of the trace in the time window [s]
  double start = 0.0, end = 0.0;
  /// Number of rows of the trace in the window
  int rows = 0;
  /// Width of the moving average of the force, rounded to whole rows [s]; 0 if there is no average
  double average = 0.0;

  double force_mean = 0.0;  ///< Mean normal force [N]

  // Errors of the averaged force: differences from the target force.
  double force_mae = 0.0;   ///< Mean absolute error of the averaged force [N]
  double force_rmse = 0.0;  ///< Root mean square error of the averaged force [N]
  double force_peak = 0.0;  ///< Largest absolute error of the averaged force [N]

  // Errors of the force without averaging: differences from the target force.

  /// Root mean square error of the force without averaging [N]
  double force_rmse_raw = 0.0;
  /// Largest absolute error of the force without averaging [N]
  double force_peak_raw = 0.0;
  /// Root mean square error of the controller's estimate of the normal force [N]
  double estimate_rmse = 0.0;
  /// Fraction of the time window without contact
  double without_contact = 0.0;
  /// Largest normal force in the 50 ms after the first contact of the run [N]
  std::optional<double> impact_peak;
  /// Largest excess of the averaged force over the target force between the end of the force ramp
  /// and the start of the time window, at least 0 [N].
  std::optional<double> overshoot;

  /// Mean distance from the tool to its target, perpendicular to the normal [m]
  double position_mean = 0.0;
  /// Root mean square distance from the tool to its target, perpendicular to the normal [m]
  double position_rmse = 0.0;
  /// 95th percentile of the distance from the tool to its target, perpendicular to the normal [m]
  double position_p95 = 0.0;
  /// Root mean square angle between the true surface normal at the tool and the controller's
  /// estimate of the normal [rad]
  double normal_error = 0.0;
  /// Largest rotation angle of the tool since the start of the time window, about any axis [rad]
  double orientation_drift = 0.0;
  /// Largest angle between the direction in which the tool presses and the direction into the
  /// surface (opposite to the normal) [rad]
  std::optional<double> tool_to_normal;

  /// Smallest distance of a joint to its limit [rad, m if prismatic]
  double joint_margin = 0.0;
  /// Joint with the smallest distance to its limit; empty if there are no limits
  std::string tightest_joint;
  /// Smallest unused fraction of a joint's effort limit
  double torque_margin = 1.0;
  /// Joint with the smallest unused fraction of its effort limit; empty if there are no limits
  std::string tightest_torque;
  double limited_torque = 0.0;  ///< Fraction of the window with a joint at its effort limit

  /// Solver statistics; no value if the trace has no solve times
  std::optional<SolverFigures> solver;
};

/// Returns the metrics of a trace of ClosedLoop. Throws Error
/// - if a column is missing,
/// - if the normal or the tool axis of `spec` has length zero,
/// - if no row is in the time window.
Metrics measure(const Trace& trace, const Model& model, const MetricsSpec& spec = {});

/// Metrics of a run together with the run's name.
/// @described report @result
struct NamedMetrics {
  std::string name;
  Metrics metrics;
};

/// Returns the metrics of several runs as a text table: a line per metric and a column per run.
/// Units are N, mm, degrees, ms and %.
std::string metrics_table(const std::vector<NamedMetrics>& runs);
/// Returns the metrics of one run as text, with a line per metric: name, value, unit and meaning.
std::string metrics_text(const Metrics& metrics);

}  // namespace burnish
