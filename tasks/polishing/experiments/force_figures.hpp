// Figures of force control from signals: what a controller makes of a force that steps, rises and
// swings, and of what disturbs it. Definitions: docs/force_test.md.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace burnish::polishing {

/// A force over time, in s and N. Times ascend.
struct ForceSignal {
  Eigen::VectorXd time;
  Eigen::VectorXd force;    ///< moving mean over 10 ms
  Eigen::VectorXd raw;      ///< of every row
  Eigen::VectorXd target;   ///< what was wanted
  Eigen::VectorXd touches;  ///< 1 where there was contact, 0 else

  /// First row at or after a time; the number of rows if there is none.
  Eigen::Index row(double at) const;
  /// Rows from a time to before another: first and number.
  std::pair<Eigen::Index, Eigen::Index> rows(double from, double until) const;
  /// What is off, force less target.
  Eigen::VectorXd error() const { return force - target; }
};

/// Of the force from one value to another; NaN what is not reached within the window.
struct StepFigures {
  double overshoot;      ///< share of the step, of the farthest beyond its end; at least 0
  double rise_time;      ///< s from the last time below 10 % of the step to the first above 90 %
  double delay;          ///< s from the step to half of it; below zero where it was foreseen
  double settling_time;  ///< s from the step until the force stays within the band
  double steady_error;   ///< N, mean error over the last `last` s
};

struct StepWindow {
  double at;           ///< s, of the step
  double until;        ///< s, where its window ends
  double lead = 0.5;   ///< s before the step, where its window begins
  double last = 0.3;   ///< s, of the mean of the steady error
  double band = 0.05;  ///< share of the step
};
StepFigures step_figures(const ForceSignal& signal, double from_force, double to_force,
                         const StepWindow& window);

/// s from `from` until the force's error stays within +- band N to the window's end; 0 where it
/// never leaves it, NaN where it is outside at the end.
double settling_time(const ForceSignal& signal, double from, double until, double band);

/// Root mean square and largest absolute error of the force in a window, N; NaN where it is empty.
double rms_error(const ForceSignal& signal, double from, double until);
double peak_error(const ForceSignal& signal, double from, double until);
double mean_error(const ForceSignal& signal, double from, double until);

/// Of the contact from `from` on: how often it was lost, and for how long in all, s.
struct ContactLosses {
  int count = 0;
  double time = 0.0;
};
ContactLosses contact_losses(const ForceSignal& signal, double from, double until);

/// f(t) = mean + amplitude sin(2 pi frequency t + phase), by least squares.
struct SineFit {
  double mean, amplitude;
  double phase;     ///< rad, from -pi to pi
  double residual;  ///< N, root mean square of what is no such sine
};
SineFit fit_sine(const Eigen::Ref<const Eigen::VectorXd>& time,
                 const Eigen::Ref<const Eigen::VectorXd>& values, double frequency);

/// A frequency, Hz, and whether it is one: the ends of the sweep are bounds.
struct Bandwidth {
  enum class Bound { None, Below, Above };  ///< below the lowest frequency, above the highest
  double frequency;
  Bound bound = Bound::None;
};
/// Where values, one for each of ascending frequencies, first fall below a level: between two of
/// them by a straight line over the logarithm of the frequency.
Bandwidth falls_below(const std::vector<double>& frequencies, const std::vector<double>& values,
                      double level);
/// Phases so that each is within pi of the one before; the first as it is.
std::vector<double> unwrapped(std::vector<double> phases);

}  // namespace burnish::polishing
