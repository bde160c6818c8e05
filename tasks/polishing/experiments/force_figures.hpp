// Figures of force control (such as overshoot and bandwidth), computed from signals of the force:
// responses to steps, ramps, sines and disturbances. docs/force_test.md defines the figures.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace burnish::polishing {

/// Contact force over time [N]; `time` ascends [s].
struct ForceSignal {
  Eigen::VectorXd time;
  Eigen::VectorXd force;    ///< Moving mean over 10 ms.
  Eigen::VectorXd raw;      ///< Force of every row, not averaged.
  Eigen::VectorXd target;   ///< Target force.
  Eigen::VectorXd touches;  ///< 1 in contact, else 0.

  /// Returns the first row at or after a time; the number of rows if there is none.
  Eigen::Index row(double at) const;
  /// Returns the index of the first row at or after `from`, and the number of rows from there to
  /// `until`.
  std::pair<Eigen::Index, Eigen::Index> rows(double from, double until) const;
  /// Returns force minus target.
  Eigen::VectorXd error() const { return force - target; }
};

/// Statistics of the response to a step of the target force. Times are NaN for force levels that
/// are not reached within the window.
struct StepFigures {
  double overshoot;  ///< Largest overshoot, as a fraction of the step; at least 0.
  /// Time from the last force below 10 % of the step to the first above 90 % [s].
  double rise_time;
  /// Time from the step of the target until the force covers half of it; negative with preview [s].
  double delay;
  double settling_time;  ///< Time from the step until the force error stays within the band [s].
  /// Mean force error over the last StepWindow::last seconds of the window [N].
  double steady_error;
};

/// Window for the statistics of a step response.
struct StepWindow {
  double at;           ///< Time of the step [s].
  double until;        ///< End of the window [s].
  double lead = 0.5;   ///< Time from the start of the window to the step [s].
  double last = 0.3;   ///< Averaging time for the steady error, at the end of the window [s].
  double band = 0.05;  ///< Half width of the settling band, as a fraction of the step.
};
/// Returns the statistics of the response to a step from `from_force` to `to_force` [N].
StepFigures step_figures(const ForceSignal& signal, double from_force, double to_force,
                         const StepWindow& window);

/// Returns the settling time: the time after `from` at which the force error enters +- `band` [N]
/// for the rest of the window [s]. 0 if the error never leaves the band; NaN if the window ends
/// outside the band.
double settling_time(const ForceSignal& signal, double from, double until, double band);

/// Return the root mean square, the largest absolute value and the mean of the force error in a
/// window [N]; NaN for an empty window.
double rms_error(const ForceSignal& signal, double from, double until);
double peak_error(const ForceSignal& signal, double from, double until);
double mean_error(const ForceSignal& signal, double from, double until);

/// Losses of contact in a window.
struct ContactLosses {
  int count = 0;      ///< Number of losses.
  double time = 0.0;  ///< Total time without contact, not counting the first row [s].
};
ContactLosses contact_losses(const ForceSignal& signal, double from, double until);

/// Least-squares fit of f(t) = mean + amplitude sin(2 pi frequency t + phase).
struct SineFit {
  double mean, amplitude;
  double phase;     ///< Phase from -pi to pi [rad].
  double residual;  ///< Root mean square of the residual [N].
};
SineFit fit_sine(const Eigen::Ref<const Eigen::VectorXd>& time,
                 const Eigen::Ref<const Eigen::VectorXd>& values, double frequency);

/// Bandwidth [Hz]. If it lies outside the tested frequencies, `frequency` is only a bound.
struct Bandwidth {
  /// Below, Above: the bandwidth is below or above `frequency`. None: it equals `frequency`.
  enum class Bound { None, Below, Above };
  double frequency;
  Bound bound = Bound::None;
};
/// Returns the frequency at which `values` first fall below a level. It is interpolated linearly
/// over the logarithm of the frequency. `frequencies` must ascend.
Bandwidth falls_below(const std::vector<double>& frequencies, const std::vector<double>& values,
                      double level);
/// Returns the phases with multiples of 2 pi added, so that each is within pi of the previous one;
/// the first is unchanged.
std::vector<double> unwrapped(std::vector<double> phases);

}  // namespace burnish::polishing
