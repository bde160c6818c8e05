#include "polishing/experiments/force_figures.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace burnish::polishing {
namespace {

constexpr double no_figure = std::numeric_limits<double>::quiet_NaN();
constexpr double tick_rounding = 1e-9;  // tolerance in comparisons of times [s]

}  // namespace

Eigen::Index ForceSignal::row(double at) const {
  const double* const begin = time.data();
  return std::lower_bound(begin, begin + time.size(), at - tick_rounding) - begin;
}

std::pair<Eigen::Index, Eigen::Index> ForceSignal::rows(double from, double until) const {
  const Eigen::Index first = row(from);
  return {first, std::max<Eigen::Index>(0, row(until) - first)};
}

StepFigures step_figures(const ForceSignal& signal, double from_force, double to_force,
                         const StepWindow& window) {
  StepFigures figures{no_figure, no_figure, no_figure, no_figure, no_figure};
  // No structured binding here, because clang 14 cannot capture it in a lambda.
  const std::pair<Eigen::Index, Eigen::Index> window_rows =
      signal.rows(window.at - window.lead, window.until);
  const Eigen::Index first = window_rows.first, count = window_rows.second;
  if (count == 0) return figures;
  const double step = to_force - from_force;
  const auto time = signal.time.segment(first, count);
  // Response to the step, scaled to 0 before the step and 1 at the final target.
  const Eigen::VectorXd response = (signal.force.segment(first, count).array() - from_force) / step;
  const auto first_above = [&](double level) {
    Eigen::Index i = 0;
    while (i < count && !(response[i] >= level)) ++i;
    return i;
  };
  figures.overshoot = std::max(0.0, response.maxCoeff() - 1.0);
  const Eigen::Index high = first_above(0.9), half = first_above(0.5);
  if (half < count) figures.delay = time[half] - window.at;
  if (high < count) {
    Eigen::Index low = high;
    while (low > 0 && response[low] >= 0.1) --low;
    figures.rise_time = time[high] - time[low];
  }
  Eigen::Index settled = count;
  while (settled > 0 && std::abs(response[settled - 1] - 1.0) <= window.band) --settled;
  if (settled < count) figures.settling_time = std::max(0.0, time[settled] - window.at);
  const auto [tail, rest] = signal.rows(window.until - window.last, window.until);
  if (rest > 0) figures.steady_error = signal.force.segment(tail, rest).mean() - to_force;
  return figures;
}

double settling_time(const ForceSignal& signal, double from, double until, double band) {
  const auto [first, count] = signal.rows(from, until);
  if (count == 0) return no_figure;
  Eigen::Index settled = count;
  while (settled > 0 &&
         std::abs(signal.force[first + settled - 1] - signal.target[first + settled - 1]) <= band)
    --settled;
  if (settled == count) return no_figure;
  return settled == 0 ? 0.0 : signal.time[first + settled] - from;
}

double rms_error(const ForceSignal& signal, double from, double until) {
  const auto [first, count] = signal.rows(from, until);
  if (count == 0) return no_figure;
  return std::sqrt((signal.force - signal.target).segment(first, count).array().square().mean());
}

double peak_error(const ForceSignal& signal, double from, double until) {
  const auto [first, count] = signal.rows(from, until);
  if (count == 0) return no_figure;
  return (signal.force - signal.target).segment(first, count).cwiseAbs().maxCoeff();
}

double mean_error(const ForceSignal& signal, double from, double until) {
  const auto [first, count] = signal.rows(from, until);
  if (count == 0) return no_figure;
  return (signal.force - signal.target).segment(first, count).mean();
}

ContactLosses contact_losses(const ForceSignal& signal, double from, double until) {
  ContactLosses losses;
  const auto [first, count] = signal.rows(from, until);
  for (Eigen::Index i = first + 1; i < first + count; ++i) {
    if (signal.touches[i] != 0.0) continue;
    losses.count += signal.touches[i - 1] != 0.0 ? 1 : 0;
    losses.time += signal.time[i] - signal.time[i - 1];
  }
  return losses;
}

SineFit fit_sine(const Eigen::Ref<const Eigen::VectorXd>& time,
                 const Eigen::Ref<const Eigen::VectorXd>& values, double frequency) {
  if (time.size() < 3) return {no_figure, no_figure, no_figure, no_figure};
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double rate = 2.0 * std::numbers::pi * frequency;
  const auto terms = [&](Eigen::Index i) {
    return Eigen::Vector3d(1.0, std::sin(rate * time[i]), std::cos(rate * time[i]));
  };
  for (Eigen::Index i = 0; i < time.size(); ++i) {
    normal += terms(i) * terms(i).transpose();
    right += values[i] * terms(i);
  }
  const Eigen::Vector3d x = normal.ldlt().solve(right);
  double squares = 0.0;
  for (Eigen::Index i = 0; i < time.size(); ++i)
    squares += std::pow(values[i] - x.dot(terms(i)), 2.0);
  return {x[0], std::hypot(x[1], x[2]), std::atan2(x[2], x[1]),
          std::sqrt(squares / static_cast<double>(time.size()))};
}

Bandwidth falls_below(const std::vector<double>& frequencies, const std::vector<double>& values,
                      double level) {
  const std::size_t count = std::min(frequencies.size(), values.size());
  if (count == 0 || !std::isfinite(values[0])) return {no_figure};
  if (values[0] < level) return {frequencies[0], Bandwidth::Bound::Below};
  for (std::size_t i = 1; i < count; ++i) {
    if (!std::isfinite(values[i])) return {frequencies[i - 1], Bandwidth::Bound::Above};
    if (!(values[i] < level)) continue;
    const double fraction = (values[i - 1] - level) / (values[i - 1] - values[i]);
    return {frequencies[i - 1] * std::pow(frequencies[i] / frequencies[i - 1], fraction)};
  }
  return {frequencies[count - 1], Bandwidth::Bound::Above};
}

std::vector<double> unwrapped(std::vector<double> phases) {
  constexpr double turn = 2.0 * std::numbers::pi;
  for (std::size_t i = 1; i < phases.size(); ++i)
    phases[i] -= turn * std::round((phases[i] - phases[i - 1]) / turn);
  return phases;
}

}  // namespace burnish::polishing
