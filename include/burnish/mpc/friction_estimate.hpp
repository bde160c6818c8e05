// The coefficient of friction between a tool and the surface that it slides on, estimated from the
// force across the surface's normal.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// How the coefficient of friction between a tool and the surface that it slides on is estimated:
/// deviations of what is believed at first, and of what is measured.
/// @described mpc
struct FrictionEstimateOptions {
  bool enabled = true;  ///< estimate it; else what is believed is what is known
  /// believed at first; plans know friction if that is above 0, or estimated, >= 0
  double coefficient = 0.0;
  double deviation = 0.3;  ///< of that, > 0
  double wander = 0.3;     ///< per square root of a metre of way, by which it changes, >= 0
  /// [N], of the force along the surface, independent every `noise_time`, > 0
  double force_noise = 0.3;
  double noise_time = 0.01;  ///< [s], >= 0
  double speed = 0.01;  ///< [m/s], below which what is felt may be stiction and tells little, > 0
};

/// v / sqrt(|v|^2 + speed^2), how SlidingFriction has the direction of sliding.
Eigen::Vector3d sliding_direction(const Eigen::Vector3d& v_across, double speed) noexcept;

/// A Kalman filter over the way that the tool slides. With f the normal force and s the direction
/// of sliding, that part of the force along the surface which is against s is Coulomb's mu f |s|.
/// A tool that does not slide tells nothing.
class FrictionEstimator {
 public:
  /// Throws Error for options that are out of range.
  explicit FrictionEstimator(const FrictionEstimateOptions& options);

  void reset() noexcept;
  /// A tick of dt s in which the tool slides at `v_across` (m/s) with this force of the surface on
  /// it, N: along the normal, and across it. No allocation.
  void update(double normal_force, const Eigen::Vector3d& force_across,
              const Eigen::Vector3d& v_across, double dt) noexcept;

  double coefficient() const { return mu_; }
  double deviation() const;

 private:
  FrictionEstimateOptions options_;
  double mu_, variance_;
};

}  // namespace burnish
