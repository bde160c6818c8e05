// Table of the figures (key numbers) of a run: names, units and meanings. Keys of files, columns,
// printed tables, pages, Python attributes and the table in the docs are derived from it.
#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/degrees.hpp"
#include "base/description.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/report/standing_figures.hpp"
#include "report/run_page.hpp"

namespace burnish {

/// Unit of a value, and unit in printed tables and pages.
struct FigureUnit {
  const char* unit;        ///< Unit of the value; "": a number, a fraction or a word
  const char* shown = "";  ///< Unit in printed tables and pages
  double factor = 1.0;     ///< Factor that converts a value in `unit` to `shown`
};
namespace figure_units {
inline constexpr FigureUnit none{""}, newton{"N", "N"}, metre{"m", "mm", 1e3},
    angle{"rad", "deg", degrees_per_radian}, joint{"rad", "rad"}, second{"s", "s"},
    computing{"s", "ms", 1e3}, share{"", "%", 100.0};
}  // namespace figure_units

/// Row of the table. The name is the member in C++ and Python and the column in tables. The key in
/// files is the name followed by the unit, for example `force_rmse_N` for `force_rmse`.
struct FigureEntry {
  const char* name;
  FigureUnit unit;
  /// Meaning; "force{mean}" stands for the force or, with averaging, for its moving mean.
  const char* meaning;
  /// Label on the page; "": the page does not show the figure
  const char* label = "";
  int digits = 3;  ///< Digits after the decimal point in tables and pages

  /// Key in files.
  std::string key() const { return *unit.unit ? std::string(name) + "_" + unit.unit : name; }
};

/// Returns the text of a figure for descriptions: unit in braces, and meaning.
std::string described_as(const FigureEntry& entry);

/// Returns the description of a struct of figures. `each(see)` must call see(entry, member) for
/// each figure; further arguments of see are ignored.
template <class Figures, class Each>
Describe<Figures> described_figures(const char* layer, const char* name, const char* meaning,
                                    const Each& each) {
  Describe<Figures> figures(layer, name, meaning);
  each([&](const FigureEntry& entry, auto member, auto...) {
    figures.field(entry.name, member, described_as(entry).c_str());
  });
  return figures;
}

/// Calls see(entry, member) for each figure of Metrics, in the order of files.
template <class See>
void each_metric(const See& see) {  // NOLINT(readability-function-size): a table
  using M = Metrics;
  using namespace figure_units;
  see(FigureEntry{"start", second, "time of the first row in the window"}, &M::start);
  see(FigureEntry{"end", second, "time of the last row in the window"}, &M::end);
  see(FigureEntry{"rows", none, "number of rows of the trace in the window"}, &M::rows);
  see(FigureEntry{"average", second,
                  "width of the force's moving mean, rounded to whole rows; 0: no mean"},
      &M::average);
  see(FigureEntry{"force_mean", newton, "mean normal force", "mean force"}, &M::force_mean);
  see(FigureEntry{"force_mae", newton, "mean absolute error of the force{mean}",
                  "force error, mean"},
      &M::force_mae);
  see(FigureEntry{"force_rmse", newton, "root mean square error of the force{mean}",
                  "force error, rms"},
      &M::force_rmse);
  see(FigureEntry{"force_peak", newton, "largest absolute error of the force{mean}",
                  "force error, peak", 2},
      &M::force_peak);
  see(FigureEntry{"force_rmse_raw", newton, "root mean square error of the force, without a mean",
                  "force error, rms, raw"},
      &M::force_rmse_raw);
  see(FigureEntry{"force_peak_raw", newton, "largest absolute error of the force, without a mean",
                  "force error, peak, raw", 2},
      &M::force_peak_raw);
  see(FigureEntry{"estimate_rmse", newton,
                  "root mean square error of the controller's estimate of the normal force",
                  "estimate error, rms"},
      &M::estimate_rmse);
  see(FigureEntry{"without_contact", share, "fraction of the time without contact",
                  "without contact", 2},
      &M::without_contact);
  see(FigureEntry{"impact_peak", newton,
                  "largest normal force in the first 50 ms of contact in the run", "impact", 1},
      &M::impact_peak);
  see(FigureEntry{"overshoot", newton,
                  "largest excess of the force{mean} over the target, between the end of the ramp "
                  "and the window; at least 0",
                  "overshoot", 2},
      &M::overshoot);
  see(FigureEntry{"position_mean", metre,
                  "mean distance to the target, perpendicular to the normal", "path error, mean"},
      &M::position_mean);
  see(FigureEntry{"position_rmse", metre,
                  "root mean square distance to the target, perpendicular to the normal",
                  "path error, rms"},
      &M::position_rmse);
  see(FigureEntry{"position_p95", metre,
                  "95th percentile of the distance to the target, perpendicular to the normal",
                  "path error, 95 %"},
      &M::position_p95);
  see(FigureEntry{"normal_error", angle,
                  "root mean square angle between the true normal at the tool and the controller's "
                  "estimate of the normal",
                  "normal error, rms", 2},
      &M::normal_error);
  see(FigureEntry{"orientation_drift", angle,
                  "largest rotation of the tool since the start of the window, about any axis",
                  "tool rotation", 1},
      &M::orientation_drift);
  see(FigureEntry{"tool_to_normal", angle,
                  "largest angle between the direction in which the tool presses and the reversed "
                  "normal",
                  "tool inclination", 1},
      &M::tool_to_normal);
  see(FigureEntry{"joint_margin", joint,
                  "smallest distance of a joint to its limit (m if prismatic)", "joint margin", 2},
      &M::joint_margin);
  see(FigureEntry{"tightest_joint", none,
                  "joint with the smallest distance to its limit; empty without limits"},
      &M::tightest_joint);
  see(FigureEntry{"torque_margin", share, "smallest unused fraction of a joint's effort limit",
                  "torque margin", 1},
      &M::torque_margin);
  see(
      FigureEntry{
          "tightest_torque", none,
          "joint with the smallest unused fraction of its effort limit; empty without limits"},
      &M::tightest_torque);
  see(FigureEntry{"limited_torque", share, "fraction of the time with a joint at its effort limit",
                  "time at torque limits", 2},
      &M::limited_torque);
}

/// Calls see(entry, member) for each figure of Metrics::solver. Full names begin with "solver.".
template <class See>
void each_solver_figure(const See& see) {
  using S = SolverFigures;
  using namespace figure_units;
  see(FigureEntry{"updates", none, "number of plans", "plans", 0}, &S::updates);
  see(FigureEntry{"median", computing, "median computing time of a plan", "plan, median"},
      &S::median);
  see(FigureEntry{"p99", computing, "99th percentile of the computing time of a plan",
                  "plan, 99 %"},
      &S::p99);
  see(FigureEntry{"maximum", computing, "longest computing time of a plan", "plan, longest"},
      &S::maximum);
  see(FigureEntry{"mean_iterations", none, "mean number of solver iterations per plan",
                  "iterations"},
      &S::mean_iterations);
  see(FigureEntry{"missed_deadlines", none, "number of plans that missed their deadline",
                  "missed deadlines", 0},
      &S::missed_deadlines);
  see(FigureEntry{"at_limits", none, "number of plans with active limits",
                  "plans with active limits", 0},
      &S::at_limits);
  see(FigureEntry{"infeasible", none, "number of plans that cannot satisfy all limits",
                  "infeasible plans", 0},
      &S::infeasible);
  see(
      FigureEntry{
          "violation_p99", share,
          "largest violation of a hard limit in a plan, as a fraction of the limit's scale: "
          "99th percentile over all plans"},
      &S::violation_p99);
  see(
      FigureEntry{
          "constraint_violation", share,
          "largest violation of a hard limit in any plan, as a fraction of the limit's scale",
          "limit violation of plans"},
      &S::constraint_violation);
  see(FigureEntry{"clipped", none,
                  "number of control ticks with a torque clipped to its permitted range",
                  "clipped torques", 0},
      &S::clipped);
}

/// Calls see(entry, member) for each figure of StandingFigures. Full names begin with "standing.".
template <class See>
void each_standing_figure(const See& see) {
  using S = StandingFigures;
  using namespace figure_units;
  see(
      FigureEntry{
          "friction_used", share,
          "largest ratio of a foot's tangential force to its friction limit, while the foot "
          "carries 20 N or more",
          "used friction of the feet", 1},
      &S::friction_used);
  see(
      FigureEntry{
          "pressure_margin", metre,
          "smallest distance from a foot's centre of pressure to the edge of its sole, while the "
          "foot carries 20 N or more",
          "distance of the pressure from the edge", 1},
      &S::pressure_margin);
  see(FigureEntry{"min_load", newton, "smallest normal force on a foot", "smallest load of a foot",
                  1},
      &S::min_load);
  see(FigureEntry{"slip", metre,
                  "largest displacement of a foot along the ground since the start; for a sole, of "
                  "its corners",
                  "slip of a foot", 2},
      &S::slip);
  see(FigureEntry{"base_tilt", angle, "largest tilt of the base since the start", "base tilt", 2},
      &S::base_tilt);
  see(FigureEntry{"com_moved", metre, "largest displacement of the centre of mass since the start",
                  "centre of mass displacement", 1},
      &S::com_moved);
}

/// Returns a figure as a number; NaN if it does not have a value.
template <class Value>
double figure_value(const Value& value) {
  if constexpr (std::convertible_to<Value, double>)
    return static_cast<double>(value);
  else
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// Figure of one run, for tables and pages.
struct ShownFigure {
  FigureEntry entry;
  std::string name;     ///< Full name
  std::string meaning;  ///< Meaning, with the averaging time or the name of a joint
  double value;         ///< Value in the unit of the entry; NaN: none

  bool of_solver() const { return name.starts_with("solver."); }
};
/// Returns the figures that have a label. Without metrics, their values are NaN.
std::vector<ShownFigure> shown_figures(const std::optional<Metrics>& metrics);
/// Returns the figures of a standing robot for the page.
std::vector<PageMetric> page_metrics(const StandingFigures& figures);
/// Figures of a standing robot, with the name of the run.
struct NamedStanding {
  std::string name;
  StandingFigures figures;
};
/// Returns a text table with a line per figure and a column per run; empty without runs.
std::string standing_table(const std::vector<NamedStanding>& runs);
/// Returns a figure for the page.
PageMetric page_metric(const ShownFigure& figure);

}  // namespace burnish
