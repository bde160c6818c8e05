// Figures (measured quantities) of a run that experiments keep.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/results_table.hpp"
#include "polishing/experiments/run_curves.hpp"
#include "report/figures.hpp"

namespace burnish::polishing {

/// Additional measurement of an experiment; NaN if the measurement does not exist.
struct MeasuredFigure {
  std::string test, figure;
  double value;
};

struct RunFigures {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::string name = {};
  std::string outcome = {};  ///< Outcome in one sentence.
  bool made = false;         ///< True unless the run was omitted or stopped from outside.
  bool refused = false;      ///< True if rejected before the simulation; `outcome` has the reason.
  bool late = false;         ///< True if the limit of the computing time ended the run.
  bool succeeded = false;
  FaultKind fault = FaultKind::None;
  std::uint64_t seed = 0;
  bool finite = true;                            ///< True if the trace has no NaN or infinity.
  std::optional<Metrics> metrics = {};           ///< Metrics over the path, if it was reached.
  std::optional<StandingFigures> standing = {};  ///< Figures of a standing robot.
  TickTimes ticks = {};
  // Figures listed by each_run_figure(); NaN if they do not exist.
  double force_error_mean = none;
  double run_torque_margin = none, run_limited_torque = none, largest_command = none;
  Eigen::VectorXd q_start = {};                        ///< Start posture; empty if rejected.
  Eigen::Vector3d p_center = Eigen::Vector3d::Zero();  ///< Origin of the path, Setting::p_center.
  std::optional<RunCurves> curves = {};                ///< Curves, if BatchRun::curves is set.
  std::vector<MeasuredFigure> measured = {};           ///< Results of BatchRun::measure.
  double computing = 0.0;                              ///< Computing time on one core [s].
  std::string kernels = {};                            ///< Kernels, see instruction_set().

  /// Returns a statistic by its full name, in its own unit. It may be a statistic of Metrics, of
  /// the solver, of standing, of the ticks, or of each_run_figure(). Returns NaN if the run lacks
  /// the statistic. Throws Error for an unknown name.
  double operator[](const std::string& figure) const;
};

/// Returns whether a standing robot fell; false for other robots.
bool fell(const RunFigures& run);

/// Returns whether the trace has no NaN or infinity.
bool all_finite(const Trace& trace);

RunFigures figures_of(const std::string& name, const Task& task, const RunResult& result);

/// Calls see(entry, member) for each statistic that covers the whole run. Metrics does not contain
/// these statistics.
template <class See>
void each_run_figure(const See& see) {
  using R = RunFigures;
  using namespace figure_units;
  see(FigureEntry{"force_error_mean", newton, "force_mean minus the target force"},
      &R::force_error_mean);
  see(FigureEntry{"run_torque_margin", share,
                  "torque_margin over the whole run, on and off the path", "", 1},
      &R::run_torque_margin);
  see(FigureEntry{"run_limited_torque", share, "limited_torque over the whole run", "", 2},
      &R::run_limited_torque);
  see(FigureEntry{"largest_command", share,
                  "largest commanded torque in the whole run, as a fraction of the effort limit",
                  "", 1},
      &R::largest_command);
}

/// Returns the table entry of a statistic: name, unit and description. Throws Error for an unknown
/// name.
FigureEntry figure_named(const std::string& name);
/// Converts a value of a statistic to its display unit.
double shown(const std::string& figure, double value);
/// Returns the table column of a statistic in its display unit. `title`: title of the column;
/// empty: name of the statistic.
ResultColumn figure_column(const std::string& figure, const std::string& title = "");

/// Columns that describe a run, from "polished" to "outcome", and the cells of its row.
std::vector<ResultColumn> run_columns();
std::vector<ResultCell> run_cells(const RunFigures& run);

/// Return the mean, maximum and minimum of the finite values; NaN if no value is finite.
double mean_of(const std::vector<double>& values);
double largest_of(const std::vector<double>& values);
double smallest_of(const std::vector<double>& values);
/// Returns the smallest value v for which at least `fraction` of the finite values are <= v.
double quantile_of(std::vector<double> values, double fraction);
/// Returns the largest value of a figure in its display unit, at least 0; NaN if a run lacks it.
double worst_shown(const std::vector<RunFigures>& runs, const std::string& figure);
/// Returns one statistic of several runs, in its own unit.
std::vector<double> collect(const std::vector<RunFigures>& runs, const std::string& figure);

/// Table column with a statistic of one figure over several runs, such as a mean.
struct SummaryColumn {
  const char* figure;
  double (*of)(const std::vector<double>& values);
  const char* title = "";  ///< Title; empty: name of the figure.
};
void add_columns(const std::vector<SummaryColumn>& summary, ResultTable& table);
void add_cells(const std::vector<SummaryColumn>& summary, const std::vector<RunFigures>& runs,
               std::vector<ResultCell>& row);

}  // namespace burnish::polishing
