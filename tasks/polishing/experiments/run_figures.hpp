// What experiments keep of a run.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/results_table.hpp"

namespace burnish::polishing {

struct RunFigures {
  std::string name;
  std::string outcome;  ///< one sentence
  bool made = false;    ///< it was not stopped from outside, before or on its way
  bool polished = false;
  FaultKind fault = FaultKind::None;
  std::uint64_t seed = 0;
  bool finite = true;         ///< no NaN or infinity in the trace
  bool reached_path = false;  ///< the figures below are there

  // Over the path, see Metrics; NaN where the path was not reached.
  double force_mean, force_rmse, force_peak;  ///< N
  double force_error_mean;                    ///< N, mean force minus mean target
  double position_rmse, position_p95;         ///< m
  double lost;                                ///< share of time
  double impact, overshoot;                   ///< N
  double turned;                              ///< rad
  double joint_margin;                        ///< rad (m)
  double tool_to_normal;  ///< rad, largest between pressing axis and the normal's opposite

  // Over the whole run, from first contact or not.
  double torque_margin = 0.0;    ///< smallest part of an effort limit that was never applied
  double limited = 0.0;          ///< share of time with a joint at its effort limit
  double largest_command = 0.0;  ///< of an effort limit, as commanded

  RunFigures();
};

RunFigures figures_of(const std::string& name, const Task& task, const RunResult& result);

/// Columns and cells of a row for a run, from "polished" to "outcome".
std::vector<ResultColumn> run_columns();
std::vector<ResultCell> run_cells(const RunFigures& run);

/// Of the values that are finite; NaN if there are none.
double mean_of(const std::vector<double>& values);
double largest_of(const std::vector<double>& values);
/// The smallest value that a share of all does not exceed.
double quantile_of(std::vector<double> values, double share);
/// One figure of several runs.
std::vector<double> collect(const std::vector<RunFigures>& runs, double RunFigures::*figure);

}  // namespace burnish::polishing
