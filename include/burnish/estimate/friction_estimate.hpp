// Online estimate of the coefficient of friction between a tool and the surface on which the tool
// slides. The estimate uses the tangential force.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// Settings of the Kalman filter that estimates the coefficient of friction between tool and
/// surface: uncertainty of the initial coefficient, and noise.
/// @described mpc
struct FrictionEstimateOptions {
  /// Estimate the coefficient; if false, `coefficient` is used unchanged
  bool enabled = true;
  /// Initial coefficient of friction, >= 0
  /// @more Plans include friction if this initial value is positive or if `enabled` is true
  double coefficient = 0.0;
  /// Standard deviation of the initial coefficient, > 0
  double deviation = 0.3;
  /// Random-walk intensity of the coefficient over the sliding distance [1/sqrt(m)], >= 0
  double wander = 0.3;
  /// Standard deviation of the measured force along the surface [N], > 0
  /// @more The noise of two forces is independent if they are measured more than `noise_time` apart
  double force_noise = 0.3;
  /// Correlation time of the force noise [s], >= 0
  double noise_time = 0.01;
  /// Sliding speed below which forces get little weight, because they may be stiction [m/s], > 0
  double speed = 0.01;
};

/// Returns the smoothed sliding direction v_across / sqrt(|v_across|^2 + speed^2), as in
/// SlidingFriction. `v_across`: velocity of the tool along the surface [m/s]. `speed`: tool speed
/// [m/s] at which the result has the length 1 / sqrt(2).
Eigen::Vector3d sliding_direction(const Eigen::Vector3d& v_across, double speed) noexcept;

/// Kalman filter of the friction coefficient mu, which varies with the sliding distance of the
/// tool. The measurement model is Coulomb friction: -f_t . s = mu f |s|. Here f is the normal
/// force, f_t the tangential force and s the smoothed sliding direction. A tool at rest gives no
/// information.
class FrictionEstimator {
 public:
  /// Throws Error if an option is out of range.
  explicit FrictionEstimator(const FrictionEstimateOptions& options);

  void reset() noexcept;
  /// Updates the estimate after a tick of length `dt` [s]. `normal_force` and `force_across` are
  /// the normal and tangential parts of the surface's force on the tool [N]. `v_across` is the
  /// sliding velocity [m/s]. Does not allocate.
  void update(double normal_force, const Eigen::Vector3d& force_across,
              const Eigen::Vector3d& v_across, double dt) noexcept;

  double coefficient() const { return mu_; }
  double deviation() const;

 private:
  FrictionEstimateOptions options_;
  double mu_, variance_;
};

}  // namespace burnish
