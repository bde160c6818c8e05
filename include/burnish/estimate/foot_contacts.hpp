// Which feet stand, by the force on each.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Which feet stand, by the force on each. Shares are of the robot's weight.
/// @described estimate
struct FootContactOptions {
  double touch = 0.12;  ///< share of the weight on a foot above which it stands, > 0
  double lift = 0.05;  ///< share below which it is in the air; between them it stays as it was, > 0
  double smoothing = 5e-3;  ///< [s], of a first-order low-pass on forces; 0: none, >= 0
  /// [N/sqrt(Hz)], of the force sensors; behind the low-pass it is to be a quarter of what lies
  /// between `touch` and `lift` at most, >= 0
  double force_noise = 0.5;
  /// [rad/s], low-pass of forces that are told from torques (FootForces), > 0
  double bandwidth = 150.0;
};

/// A foot's normal force with hysteresis. Ticks allocate nothing and throw nothing.
class FootContacts {
 public:
  using Feet = std::uint32_t;  ///< bit k: foot k

  /// Throws Error for options out of range, for no or more than 32 feet, and for noise that would
  /// reach across the hysteresis.
  FootContacts(const Model& model, int feet, const FootContactOptions& options = {});

  /// Forgets all forces; these feet stand.
  void reset(Feet standing = 0) noexcept;
  /// Normal forces, N, one per foot, dt s after the last ones. WrongSize or NotFinite (also for a
  /// dt that is not positive), which change nothing, or Ok.
  Status update(const ConstVectorRef& normal_forces, double dt) noexcept;

  Feet standing() const { return standing_; }
  const Eigen::VectorXd& forces() const { return forces_; }  ///< N, behind the low-pass

 private:
  double touch_, lift_, smoothing_;  ///< N, N, s
  bool started_ = false;
  Feet standing_ = 0;
  Eigen::VectorXd forces_;
};

}  // namespace burnish
