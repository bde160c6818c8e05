// How well a run polished, from its trace: the measures by which controllers are compared.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// What of a trace is measured.
/// @described report
struct MetricsSpec {
  double start = 0.0;                                    ///< [s], of the window
  double end = std::numeric_limits<double>::infinity();  ///< [s], of the window
  /// Along which the force is measured and across which the position, towards the robot, any length
  /// but zero; none: the normal of the surface at the tool, as it is in each row.
  std::optional<Eigen::Vector3d> normal_world = {};
  double average = 0.010;  ///< [s], of the moving average of the force, centred; 0: none
  /// that the tool presses along, in its frame, any length but zero; none: tool_to_normal is not
  /// measured
  std::optional<Eigen::Vector3d> tool_axis = {};
  /// columns: the tool's axes where the trace begins, world
  Eigen::Matrix3d tool_start_world = Eigen::Matrix3d::Identity();
};

/// Over the control ticks of the window that solved something.
struct SolverFigures {
  int updates = 0;                                ///< plans that were made
  double median = 0.0, p99 = 0.0, maximum = 0.0;  ///< s
  double mean_iterations = 0.0;                   ///< solver iterations per plan, mean
  int missed_deadlines = 0;                       ///< plans that came later than they were due
  int at_limits = 0;                              ///< plans with limits that push
  int infeasible = 0;                             ///< plans that cannot keep all limits
  /// largest violation of a hard limit along a plan, as a share of its scale: of 99 of 100 plans,
  /// and of all
  double limits_p99 = 0.0, limits_outside = 0.0;
  int clipped = 0;  ///< ticks with a torque that was cut to what may be sent
};

/// All of the window unless it says otherwise, on true forces and positions, SI units.
struct Metrics {
  double start = 0.0, end = 0.0;  ///< s, of the rows found
  int rows = 0;                   ///< of the trace within the window
  /// s, that averaged forces are means over, by whole rows; 0: of one row each
  double average = 0.0;

  double force_mean = 0.0;  ///< N, mean normal force
  // Error of the averaged force against the target.
  double force_mae = 0.0;   ///< N, mean absolute error of the force's moving mean
  double force_rmse = 0.0;  ///< N, root mean square error of the force's moving mean
  double force_peak = 0.0;  ///< N, largest absolute error of the force's moving mean
  // The same of the force in every row.
  double force_rmse_raw = 0.0;  ///< N, root mean square error of the force in every row
  double force_peak_raw = 0.0;  ///< N, largest absolute error of the force in any row
  /// N, root mean square error of what the controller believes the normal force to be
  double estimate_rmse = 0.0;
  double without_contact = 0.0;  ///< share of the time without contact
  /// N, largest normal force in the 50 ms from the first contact of the run on
  std::optional<double> impact_peak;
  /// N, largest excess of the force's moving mean over the target, from the end of the ramp to the
  /// window; at least 0
  std::optional<double> overshoot;

  double position_mean = 0.0;  ///< m, mean distance to the target across the normal
  double position_rmse = 0.0;  ///< m, root mean square distance to the target across the normal
  /// m, distance to the target across the normal that is not exceeded 95 % of the time
  double position_p95 = 0.0;
  /// rad, root mean square angle between the surface's normal at the tool and what the controller
  /// believes it to be
  double normal_error = 0.0;
  /// rad, largest rotation of the tool since the window began, about any axis
  double orientation_drift = 0.0;
  /// rad, largest angle between the axis that the tool presses along and the surface's normal,
  /// reversed
  std::optional<double> tool_to_normal;

  /// rad, smallest distance of a joint to its limit (m where it slides)
  double joint_margin = 0.0;
  std::string tightest_joint;   ///< whose margin that is; empty without limits
  double torque_margin = 1.0;   ///< share of a joint's effort limit that was never used, smallest
  std::string tightest_torque;  ///< whose margin that is; empty without limits
  double limited_torque = 0.0;  ///< share of the time with a joint at its effort limit

  std::optional<SolverFigures> solver;  ///< where a controller reports solve times
};

/// From a trace of ClosedLoop. Throws Error for a missing column, a zero normal, and a window
/// without rows.
Metrics measure(const Trace& trace, const Model& model, const MetricsSpec& spec = {});

/// Metrics of a run, and what it is called.
/// @described report @result
struct NamedMetrics {
  std::string name;
  Metrics metrics;
};

/// One line per figure, under its name in files, and a column per run: N, mm, degrees, ms, %.
std::string metrics_table(const std::vector<NamedMetrics>& runs);
/// All figures of one run, one per line: name, value, unit, what it means.
std::string metrics_text(const Metrics& metrics);

}  // namespace burnish
