#include <cmath>
#include <cstdio>

#include "burnish/report/run_page.hpp"

namespace burnish {
namespace {

/// One figure: its words, and where it comes from. `text` has {mean} where it is of the force's
/// moving average.
struct PageFigure {
  const char *name, *label, *unit, *text;
  std::optional<double> (*of)(const Metrics&);
};

template <double Metrics::*member>
std::optional<double> plain(const Metrics& metrics) {
  return metrics.*member;
}
template <double Metrics::*member>
std::optional<double> percent(const Metrics& metrics) {
  return 100.0 * metrics.*member;
}
template <double SolverFigures::*member>
std::optional<double> of_solver(const Metrics& metrics) {
  if (!metrics.solver) return std::nullopt;
  return (*metrics.solver).*member;
}

constexpr PageFigure figures[] = {
    {"force_mean", "mean force", "N", "mean normal force", plain<&Metrics::force_mean>},
    {"force_mae", "force error, mean", "N", "mean absolute error of the force{mean}",
     plain<&Metrics::force_mae>},
    {"force_rmse", "force error, rms", "N", "root mean square error of the force{mean}",
     plain<&Metrics::force_rmse>},
    {"force_peak", "force error, peak", "N", "largest error of the force{mean}",
     plain<&Metrics::force_peak>},
    {"force_rmse_raw", "force error, rms, raw", "N", "root mean square error of every sample",
     plain<&Metrics::force_rmse_raw>},
    {"force_peak_raw", "force error, peak, raw", "N", "largest error of any sample",
     plain<&Metrics::force_peak_raw>},
    {"estimate_rmse", "estimate error, rms", "N",
     "root mean square error of what the controller believes the force to be",
     plain<&Metrics::estimate_rmse>},
    {"without_contact", "without contact", "%", "share of the time without contact",
     percent<&Metrics::without_contact>},
    {"impact_peak", "impact", "N", "largest force within 50 ms of the first contact",
     [](const Metrics& m) { return m.impact_peak; }},
    {"overshoot", "overshoot", "N", "largest force above the target from the ramp to the window",
     [](const Metrics& m) { return m.overshoot; }},
    {"position_mean", "path error, mean", "m", "mean distance to the path in the plane",
     plain<&Metrics::position_mean>},
    {"position_rmse", "path error, rms", "m", "root mean square distance to the path in the plane",
     plain<&Metrics::position_rmse>},
    {"position_p95", "path error, 95 %", "m", "distance that is not exceeded 95 % of the time",
     plain<&Metrics::position_p95>},
    {"orientation_drift", "tool turned", "rad",
     "largest rotation of the tool since the window began", plain<&Metrics::orientation_drift>},
    {"joint_margin", "joint margin", "rad", "smallest distance of a joint to its limit",
     plain<&Metrics::joint_margin>},
    {"torque_margin", "torque margin", "%",
     "part of a joint's torque limit that was never used, smallest",
     percent<&Metrics::torque_margin>},
    {"limited_torque", "torque limited", "%", "share of the time with a joint at its torque limit",
     percent<&Metrics::limited_torque>},
    {"solve_median", "plan, median", "s", "median computing time of a plan",
     of_solver<&SolverFigures::median>},
    {"solve_p99", "plan, 99 %", "s", "computing time that 99 % of the plans stay below",
     of_solver<&SolverFigures::p99>},
    {"solve_maximum", "plan, longest", "s", "longest computing time of a plan",
     of_solver<&SolverFigures::maximum>},
    {"mean_iterations", "iterations", "1", "solver iterations per plan, mean",
     of_solver<&SolverFigures::mean_iterations>},
    {"missed_deadlines", "deadlines missed", "1", "plans that came later than they were due",
     [](const Metrics& m) -> std::optional<double> {
       if (!m.solver) return std::nullopt;
       return m.solver->missed_deadlines;
     }}};

/// What a force's errors are of.
std::string mean_of(const Metrics& metrics) {
  if (metrics.average <= 0.0) return "";
  char text[48];
  std::snprintf(text, sizeof text, "'s mean over %.4g ms", 1e3 * metrics.average);
  return text;
}

}  // namespace

std::vector<PageMetric> page_metrics(const std::optional<Metrics>& metrics) {
  std::vector<PageMetric> result;
  for (const PageFigure& figure : figures) {
    std::optional<double> value;
    if (metrics) value = figure.of(*metrics);
    if (value && !std::isfinite(*value)) value.reset();
    std::string text = figure.text;
    if (const std::size_t at = text.find("{mean}"); at != std::string::npos)
      text.replace(at, 6, metrics ? mean_of(*metrics) : "");
    const auto add_whose = [&](const char* name, const std::string& whose) {
      if (std::string_view(figure.name) == name && !whose.empty()) text += ": " + whose;
    };
    if (metrics) {
      add_whose("joint_margin", metrics->tightest_joint);
      add_whose("torque_margin", metrics->tightest_torque);
    }
    result.push_back({figure.name, figure.label, value, figure.unit, std::move(text)});
  }
  return result;
}

}  // namespace burnish
