// The one table of a run's figures: names, units and meanings, from which come the keys of files,
// columns, printed tables, the page, Python's attributes and the table of the docs.
#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/degrees.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/report/standing_figures.hpp"
#include "report/run_page.hpp"

namespace burnish {

/// What a value is in, and what people are shown it in.
struct FigureUnit {
  const char* unit;        ///< of the value; "": a number, a share or a word
  const char* shown = "";  ///< to people
  double factor = 1.0;     ///< from the one to the other
};
namespace figure_units {
inline constexpr FigureUnit none{""}, newton{"N", "N"}, metre{"m", "mm", 1e3},
    angle{"rad", "deg", degrees_per_radian}, joint{"rad", "rad"}, second{"s", "s"},
    computing{"s", "ms", 1e3}, share{"", "%", 100.0};
}  // namespace figure_units

/// A row. Its name is one everywhere: the member, in C++ and Python, the column, and with the unit
/// behind it the key in files (`force_rmse`, `force_rmse_N`).
struct FigureEntry {
  const char* name;
  FigureUnit unit;
  /// "{mean}" where it is of the force's moving average.
  const char* meaning;
  /// On the page; "": in files alone.
  const char* label = "";
  int digits = 3;  ///< behind the point, of what is shown

  std::string key() const { return *unit.unit ? std::string(name) + "_" + unit.unit : name; }
};

/// As descriptions have it: the unit in braces, and what it means of any run.
std::string described_as(const FigureEntry& entry);

/// Calls see(entry, member) for each figure of Metrics, in the order of files.
template <class See>
void each_metric(const See& see) {  // NOLINT(readability-function-size): a table
  using M = Metrics;
  using namespace figure_units;
  see(FigureEntry{"start", second, "of the first row within the window"}, &M::start);
  see(FigureEntry{"end", second, "of the last row within the window"}, &M::end);
  see(FigureEntry{"rows", none, "of the trace within the window"}, &M::rows);
  see(FigureEntry{"average", second,
                  "that averaged forces are means over, by whole rows; 0: of one row each"},
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
  see(FigureEntry{"force_rmse_raw", newton, "root mean square error of the force in every row",
                  "force error, rms, raw"},
      &M::force_rmse_raw);
  see(FigureEntry{"force_peak_raw", newton, "largest absolute error of the force in any row",
                  "force error, peak, raw", 2},
      &M::force_peak_raw);
  see(FigureEntry{"estimate_rmse", newton,
                  "root mean square error of what the controller believes the normal force to be",
                  "estimate error, rms"},
      &M::estimate_rmse);
  see(FigureEntry{"without_contact", share, "share of the time without contact", "without contact",
                  2},
      &M::without_contact);
  see(FigureEntry{"impact_peak", newton,
                  "largest normal force in the 50 ms from the first contact of the run on",
                  "impact", 1},
      &M::impact_peak);
  see(FigureEntry{"overshoot", newton,
                  "largest excess of the force{mean} over the target, from the end of the ramp to "
                  "the window; at least 0",
                  "overshoot", 2},
      &M::overshoot);
  see(FigureEntry{"position_mean", metre, "mean distance to the target across the normal",
                  "path error, mean"},
      &M::position_mean);
  see(FigureEntry{"position_rmse", metre,
                  "root mean square distance to the target across the normal", "path error, rms"},
      &M::position_rmse);
  see(FigureEntry{"position_p95", metre,
                  "distance to the target across the normal that is not exceeded 95 % of the time",
                  "path error, 95 %"},
      &M::position_p95);
  see(FigureEntry{"normal_error", angle,
                  "root mean square angle between the surface's normal at the tool and what the "
                  "controller believes it to be",
                  "normal error, rms", 2},
      &M::normal_error);
  see(FigureEntry{"orientation_drift", angle,
                  "largest rotation of the tool since the window began, about any axis",
                  "tool turned", 1},
      &M::orientation_drift);
  see(FigureEntry{"tool_to_normal", angle,
                  "largest angle between the axis that the tool presses along and the surface's "
                  "normal, reversed",
                  "tool leans", 1},
      &M::tool_to_normal);
  see(FigureEntry{"joint_margin", joint,
                  "smallest distance of a joint to its limit (m where it slides)", "joint margin",
                  2},
      &M::joint_margin);
  see(FigureEntry{"tightest_joint", none, "whose margin that is; empty without limits"},
      &M::tightest_joint);
  see(FigureEntry{"torque_margin", share,
                  "share of a joint's effort limit that was never used, smallest", "torque margin",
                  1},
      &M::torque_margin);
  see(FigureEntry{"tightest_torque", none, "whose margin that is; empty without limits"},
      &M::tightest_torque);
  see(FigureEntry{"limited_torque", share, "share of the time with a joint at its effort limit",
                  "torque limited", 2},
      &M::limited_torque);
}

/// The same of what Metrics::solver holds; their full names have "solver." in front.
template <class See>
void each_solver_figure(const See& see) {
  using S = SolverFigures;
  using namespace figure_units;
  see(FigureEntry{"updates", none, "plans that were made", "plans", 0}, &S::updates);
  see(FigureEntry{"median", computing, "median computing time of a plan", "plan, median"},
      &S::median);
  see(FigureEntry{"p99", computing, "computing time that 99 % of the plans stay below",
                  "plan, 99 %"},
      &S::p99);
  see(FigureEntry{"maximum", computing, "longest computing time of a plan", "plan, longest"},
      &S::maximum);
  see(FigureEntry{"mean_iterations", none, "solver iterations per plan, mean", "iterations"},
      &S::mean_iterations);
  see(FigureEntry{"missed_deadlines", none, "plans that came later than they were due",
                  "deadlines missed", 0},
      &S::missed_deadlines);
  see(FigureEntry{"at_limits", none, "plans with limits that push", "plans at limits", 0},
      &S::at_limits);
  see(FigureEntry{"infeasible", none, "plans that cannot keep all limits", "plans infeasible", 0},
      &S::infeasible);
  see(FigureEntry{"limits_p99", share,
                  "largest violation of a hard limit along a plan, of its scale, that 99 % of the "
                  "plans stay below"},
      &S::limits_p99);
  see(FigureEntry{"limits_outside", share,
                  "largest violation of a hard limit along any plan, of its scale",
                  "limits broken in plans"},
      &S::limits_outside);
  see(FigureEntry{"clipped", none, "ticks with a torque that was cut to what may be sent",
                  "torques cut", 0},
      &S::clipped);
}

/// The same of how a robot stood; their full names have "standing." in front.
template <class See>
void each_standing_figure(const See& see) {
  using S = StandingFigures;
  using namespace figure_units;
  see(FigureEntry{"friction_used", share,
                  "largest share of its friction cone that a foot used while it bore 20 N",
                  "friction of the feet used", 1},
      &S::friction_used);
  see(
      FigureEntry{
          "pressure_margin", metre,
          "least distance of a foot's centre of pressure from the edge of its sole while it "
          "bore 20 N",
          "pressure to the sole's edge", 1},
      &S::pressure_margin);
  see(FigureEntry{"least_load", newton, "least normal force on a foot", "least load of a foot", 1},
      &S::least_load);
  see(FigureEntry{"slip", metre,
                  "farthest that a foot, with a sole a corner of it, came along the ground from "
                  "where it was at first",
                  "slip of a foot", 2},
      &S::slip);
  see(FigureEntry{"base_tilt", angle,
                  "largest angle between the vertical and what was vertical in the base at first",
                  "base tilted", 2},
      &S::base_tilt);
  see(FigureEntry{"com_moved", metre,
                  "farthest that the centre of mass came from where it was at first",
                  "centre of mass moved", 1},
      &S::com_moved);
}

/// A figure as a number: NaN where there is none.
template <class Value>
double figure_value(const Value& value) {
  if constexpr (std::convertible_to<Value, double>)
    return static_cast<double>(value);
  else
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// A figure of one run, for people.
struct ShownFigure {
  FigureEntry entry;
  std::string name;     ///< in full
  std::string meaning;  ///< with what the mean is over, and whose the margin is
  double value;         ///< in the entry's unit; NaN: none

  bool of_solver() const { return name.starts_with("solver."); }
};
/// Those that have a label; all of them, with no values, without metrics.
std::vector<ShownFigure> shown_figures(const std::optional<Metrics>& metrics);
/// How a robot stood, as the page has it: those that have a label.
std::vector<PageMetric> page_metrics(const StandingFigures& figures);
struct NamedStanding {
  std::string name;
  StandingFigures figures;
};
/// A line per figure and a column per run, as metrics_table() has them; empty without runs.
std::string standing_table(const std::vector<NamedStanding>& runs);
/// As the page has it.
PageMetric page_metric(const ShownFigure& figure);

}  // namespace burnish
