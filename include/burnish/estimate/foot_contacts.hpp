// Detection of standing feet from the force on each foot.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Options for detecting standing feet from the force on each foot. Force thresholds are fractions
/// of the robot's weight.
/// @described estimate
struct FootContactOptions {
  /// Force above which a foot counts as standing, as a fraction of the weight, > 0
  double touch = 0.12;
  /// Force below which a foot counts as in the air, as a fraction of the weight, > 0 @more Between
  /// `lift` and `touch`, the state of the foot does not change.
  double lift = 0.05;
  /// Time constant of the low-pass filter on the forces (0: no filter) [s], >= 0 @more The filter
  /// is of first order.
  double smoothing = 5e-3;
  /// Noise density of the force sensors [N/sqrt(Hz)], >= 0 @more The standard deviation of the
  /// filtered noise must be at most a quarter of the gap between the force thresholds `lift` and
  /// `touch`.
  double force_noise = 0.5;
  /// Bandwidth of the observer that estimates foot forces from joint torques [rad/s], > 0 @note The
  /// observer is FootForces.
  double bandwidth = 150.0;
};

/// Detector of standing feet. It compares the normal force on each foot with an upper and a lower
/// threshold (hysteresis). Updates allocate nothing and throw nothing.
class FootContacts {
 public:
  using Feet = std::uint32_t;  ///< Set of feet: bit k is foot k

  /// Creates a detector for `feet` feet, 1 to 32. Throws Error for another number of feet, or for
  /// options out of range. Also throws Error if the force noise is too large for the gap between
  /// the two thresholds.
  FootContacts(const Model& model, int feet, const FootContactOptions& options = {});

  /// Discards all forces and sets the standing feet to `standing`.
  void reset(Feet standing = 0) noexcept;
  /// Updates the standing feet from the normal force on each foot [N]. `dt` is the time since the
  /// last update [s]. Returns Ok. If the call returns WrongSize or NotFinite (also if dt is not
  /// positive), nothing has changed.
  Status update(const ConstVectorRef& normal_forces, double dt) noexcept;

  Feet standing() const { return standing_; }
  const Eigen::VectorXd& forces() const { return forces_; }  ///< Low-pass filtered forces [N]

 private:
  double touch_, lift_, smoothing_;  ///< Thresholds [N], and the time constant [s]
  bool started_ = false;
  Feet standing_ = 0;
  Eigen::VectorXd forces_;
};

}  // namespace burnish
