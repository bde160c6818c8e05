// What experiments keep of a run.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/results_table.hpp"
#include "polishing/experiments/run_curves.hpp"
#include "report/figures.hpp"

namespace burnish::polishing {

/// A figure that an experiment measures of a run besides, NaN where there is none.
struct MeasuredFigure {
  std::string test, figure;
  double value;
};

struct RunFigures {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::string name = {};
  std::string outcome = {};  ///< one sentence
  bool made = false;         ///< it was not stopped from outside, before or on its way
  bool refused = false;      ///< before anything moved; `outcome` says why
  bool late = false;         ///< it was ended by its time limit
  bool polished = false;
  FaultKind fault = FaultKind::None;
  std::uint64_t seed = 0;
  bool finite = true;                            ///< no NaN or infinity in the trace
  std::optional<Metrics> metrics = {};           ///< over the path; none where it was not reached
  std::optional<StandingFigures> standing = {};  ///< of a robot that stands
  TickTimes ticks = {};
  // See each_run_figure(); NaN where there is none.
  double force_error_mean = none;
  double run_torque_margin = none, run_limited_torque = none, largest_command = none;
  Eigen::VectorXd q_start = {};                        ///< nq; empty where it was refused
  Eigen::Vector3d p_center = Eigen::Vector3d::Zero();  ///< see Setting::p_center
  std::optional<RunCurves> curves = {};                ///< where they were asked for
  std::vector<MeasuredFigure> measured = {};           ///< see BatchRun::measure
  double computing = 0.0;                              ///< s of a core
  std::string kernels = {};                            ///< see instruction_set()

  /// A figure by its full name, in its unit: of Metrics, the solver, standing, the ticks,
  /// each_run_figure(); NaN where there is none. Throws Error for a name that there is not.
  double operator[](const std::string& figure) const;
};

/// Whether a robot that stands fell. False for one that does not stand.
bool fell(const RunFigures& run);

/// No NaN or infinity in it.
bool all_finite(const Trace& trace);

RunFigures figures_of(const std::string& name, const Task& task, const RunResult& result);

/// Calls see(entry, member) for each figure that is the run's and not of Metrics.
template <class See>
void each_run_figure(const See& see) {
  using R = RunFigures;
  using namespace figure_units;
  see(FigureEntry{"force_error_mean", newton, "force_mean less the force that is asked for"},
      &R::force_error_mean);
  see(FigureEntry{"run_torque_margin", share,
                  "torque_margin over the whole run, with path or without", "", 1},
      &R::run_torque_margin);
  see(FigureEntry{"run_limited_torque", share, "limited_torque over the whole run", "", 2},
      &R::run_limited_torque);
  see(FigureEntry{"largest_command", share,
                  "largest share of a joint's effort limit that was commanded in the whole run", "",
                  1},
      &R::largest_command);
}

/// What a figure is. Throws Error for a name that there is not.
FigureEntry figure_named(const std::string& name);
/// A value of a figure in the unit that people are shown.
double shown(const std::string& figure, double value);
/// A column of a figure in that unit, under its name or another.
ResultColumn figure_column(const std::string& figure, const std::string& title = "");

/// Columns and cells of a row for a run, from "polished" to "outcome".
std::vector<ResultColumn> run_columns();
std::vector<ResultCell> run_cells(const RunFigures& run);

/// Of the values that are finite; NaN if there are none.
double mean_of(const std::vector<double>& values);
double largest_of(const std::vector<double>& values);
double smallest_of(const std::vector<double>& values);
/// The smallest value that a share of all does not exceed.
double quantile_of(std::vector<double> values, double share);
/// One figure of several runs, in its unit.
std::vector<double> collect(const std::vector<RunFigures>& runs, const std::string& figure);

/// A column of what a figure was in several runs.
struct SummaryColumn {
  const char* figure;
  double (*of)(const std::vector<double>& values);
  const char* title = "";  ///< empty: the figure's name
};
void add_columns(const std::vector<SummaryColumn>& summary, ResultTable& table);
void add_cells(const std::vector<SummaryColumn>& summary, const std::vector<RunFigures>& runs,
               std::vector<ResultCell>& row);

}  // namespace burnish::polishing
