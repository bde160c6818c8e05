// Figures of force control, compared with the exact figures of first- and second-order lags.
#include "polishing/experiments/force_figures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

namespace burnish::testing {
namespace {

using namespace burnish::polishing;
constexpr double pi = std::numbers::pi;

/// Returns a signal from 0 to `end` [s], sampled every 0.5 ms.
ForceSignal signal_of(
    double end, const std::function<double(double)>& force,
    const std::function<double(double)>& target = [](double) { return 0.0; }) {
  const auto size = static_cast<Eigen::Index>(std::lround(end / 5e-4)) + 1;
  ForceSignal signal;
  signal.time = Eigen::VectorXd::LinSpaced(size, 0.0, end);
  signal.raw = signal.force = signal.time.unaryExpr(force);
  signal.target = signal.time.unaryExpr(target);
  signal.touches = Eigen::VectorXd::Ones(size);
  return signal;
}

/// Unit step response of a second-order lag with natural frequency `w` and damping ratio `zeta`.
double second_order_step(double t, double w, double zeta) {
  if (t <= 0.0) return 0.0;
  const double damped = w * std::sqrt(1.0 - zeta * zeta);
  return 1.0 - std::exp(-zeta * w * t) *
                   (std::cos(damped * t) + zeta * w / damped * std::sin(damped * t));
}

TEST(ForceFigures, FirstOrderStep_HasTheTimesOfItsTimeConstant) {
  constexpr double tau = 0.04;
  for (const double to : {30.0, 10.0}) {  // from 20 N, up and down
    const ForceSignal signal = signal_of(3.0, [&](double t) {
      return t < 1.0 ? 20.0 : to + (20.0 - to) * std::exp(-(t - 1.0) / tau);
    });
    const StepFigures step = step_figures(signal, 20.0, to, {.at = 1.0, .until = 2.5});
    EXPECT_EQ(step.overshoot, 0.0);
    EXPECT_NEAR(step.rise_time, tau * std::log(9.0), 1e-3);
    EXPECT_NEAR(step.delay, tau * std::log(2.0), 1e-3);
    EXPECT_NEAR(step.settling_time, tau * std::log(20.0), 1e-3);
    EXPECT_NEAR(step.steady_error, 0.0, 1e-9);
  }
}

TEST(ForceFigures, SecondOrderStep_OvershootsByItsDamping) {
  constexpr double w = 40.0;
  for (const double zeta : {0.2, 0.5, 0.7}) {
    const ForceSignal signal =
        signal_of(3.0, [&](double t) { return 15.0 + 15.0 * second_order_step(t - 1.0, w, zeta); });
    const StepFigures step = step_figures(signal, 15.0, 30.0, {.at = 1.0, .until = 2.5});
    const double root = std::sqrt(1.0 - zeta * zeta);
    EXPECT_NEAR(step.overshoot, std::exp(-pi * zeta / root), 1e-4);
    // The response leaves the 5 % band for the last time at most half a swing before its envelope.
    const double envelope = -std::log(0.05 * root) / (zeta * w);
    EXPECT_LE(step.settling_time, envelope + 1e-3);
    EXPECT_GE(step.settling_time, envelope - pi / (w * root));
    EXPECT_NEAR(std::abs(second_order_step(step.settling_time, w, zeta) - 1.0), 0.05, 3e-3);
  }
}

TEST(ForceFigures, EarlyOrUnreachedStep_HasNegativeDelayOrNoRiseTime) {
  const ForceSignal early =
      signal_of(3.0, [](double t) { return 15.0 + 15.0 * std::clamp((t - 0.9) / 0.1, 0.0, 1.0); });
  const StepFigures step = step_figures(early, 15.0, 30.0, {.at = 1.0, .until = 2.5});
  EXPECT_NEAR(step.delay, -0.05, 1e-3);
  EXPECT_NEAR(step.rise_time, 0.08, 2e-3);
  EXPECT_EQ(step.settling_time, 0.0);
  const ForceSignal half = signal_of(3.0, [](double t) { return t < 1.0 ? 15.0 : 27.0; });
  const StepFigures never = step_figures(half, 15.0, 30.0, {.at = 1.0, .until = 2.5});
  EXPECT_TRUE(std::isnan(never.rise_time));
  EXPECT_TRUE(std::isnan(never.settling_time));
  EXPECT_NEAR(never.steady_error, -3.0, 1e-9);
  EXPECT_NEAR(never.delay, 0.0, 1e-3);
  const StepFigures without = step_figures(half, 15.0, 30.0, {.at = 8.0, .until = 9.0});
  EXPECT_TRUE(std::isnan(without.overshoot));
}

TEST(ForceFigures, LaggingForce_GivesItsErrorsAndSettlingTime) {
  // A lag of 30 ms behind a ramp of 10 N/s is an error of 0.3 N.
  const ForceSignal lag = signal_of(
      2.0, [](double t) { return 10.0 * (t - 0.03); }, [](double t) { return 10.0 * t; });
  EXPECT_NEAR(mean_error(lag, 0.5, 1.5), -0.3, 1e-12);
  EXPECT_NEAR(rms_error(lag, 0.5, 1.5), 0.3, 1e-12);
  EXPECT_NEAR(peak_error(lag, 0.5, 1.5), 0.3, 1e-12);
  EXPECT_TRUE(std::isnan(rms_error(lag, 5.0, 6.0)));
  const ForceSignal pushed =
      signal_of(3.0, [](double t) { return t < 1.0 ? 0.0 : 8.0 * std::exp(-(t - 1.0) / 0.1); });
  EXPECT_NEAR(settling_time(pushed, 1.0, 2.5, 1.0), 0.1 * std::log(8.0), 1e-3);
  EXPECT_TRUE(std::isnan(settling_time(pushed, 1.0, 1.1, 1.0)));
  EXPECT_EQ(settling_time(pushed, 2.0, 3.0, 1.0), 0.0);
}

TEST(ForceFigures, ContactLosses_AreCounted) {
  ForceSignal signal = signal_of(1.0, [](double) { return 5.0; });
  for (Eigen::Index i = 0; i < signal.time.size(); ++i)
    if ((i >= 200 && i < 220) || (i >= 400 && i < 410)) signal.touches[i] = 0.0;
  const ContactLosses losses = contact_losses(signal, 0.0, 1.0);
  EXPECT_EQ(losses.count, 2);
  EXPECT_NEAR(losses.time, 30 * 5e-4, 1e-9);
  EXPECT_EQ(contact_losses(signal, 0.5, 1.0).count, 0);
}

TEST(ForceFigures, SineAmongOthers_IsFitted) {
  for (const double frequency : {0.5, 7.0, 48.0}) {
    const ForceSignal signal = signal_of(4.0, [&](double t) {
      return 30.0 + 4.0 * std::sin(2.0 * pi * frequency * t - 1.2) +
             0.5 * std::sin(2.0 * pi * 3.0 * frequency * t);
    });
    const SineFit fit = fit_sine(signal.time.head(8000), signal.raw.head(8000), frequency);
    EXPECT_NEAR(fit.mean, 30.0, 1e-6);
    EXPECT_NEAR(fit.amplitude, 4.0, 1e-6);
    EXPECT_NEAR(fit.phase, -1.2, 1e-6);
    EXPECT_NEAR(fit.residual, 0.5 / std::numbers::sqrt2, 1e-3);
  }
}

TEST(ForceFigures, SecondOrderLag_GivesItsBandwidths) {
  const std::vector<double> frequencies{0.5, 1.0, 2.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0};
  constexpr double w = 2.0 * pi * 7.0, zeta = 0.6;
  std::vector<double> gains, phases;
  for (const double frequency : frequencies) {
    const std::complex<double> s(0.0, 2.0 * pi * frequency);
    const std::complex<double> response = w * w / (s * s + 2.0 * zeta * w * s + w * w);
    gains.push_back(20.0 * std::log10(std::abs(response)));
    phases.push_back(std::arg(response));
  }
  phases = unwrapped(phases);
  for (double& phase : phases) phase *= 180.0 / pi;
  const double damping_term = 1.0 - 2.0 * zeta * zeta;
  const double exact = 7.0 * std::sqrt(damping_term + std::sqrt(damping_term * damping_term + 1.0));
  const Bandwidth gain = falls_below(frequencies, gains, 20.0 * std::log10(std::sqrt(0.5)));
  EXPECT_EQ(gain.bound, Bandwidth::Bound::None);
  EXPECT_NEAR(gain.frequency, exact, 0.03 * exact);
  EXPECT_NEAR(falls_below(frequencies, phases, -90.0).frequency, 7.0, 0.1);
  // A bandwidth beyond the sweep is a bound: the first or last frequency.
  const Bandwidth above = falls_below(frequencies, gains, -100.0);
  EXPECT_EQ(above.bound, Bandwidth::Bound::Above);
  EXPECT_EQ(above.frequency, 32.0);
  EXPECT_EQ(falls_below(frequencies, gains, 1.0).bound, Bandwidth::Bound::Below);
}

TEST(ForceFigures, UnwrappedPhasesOfADelay_KeepFalling) {
  std::vector<double> phases;
  for (int k = 1; k < 30; ++k) phases.push_back(std::remainder(-0.4 * k, 2.0 * pi));
  phases = unwrapped(phases);
  for (int k = 1; k < 30; ++k)
    EXPECT_NEAR(phases[static_cast<std::size_t>(k - 1)], -0.4 * k, 1e-12);
}

}  // namespace
}  // namespace burnish::testing
