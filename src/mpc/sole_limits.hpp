// Limits of the ankle torques of a standing robot, which keep its planar feet (soles) from tipping.
#pragma once

#include <vector>

#include "burnish/mpc/mpc_spec.hpp"

namespace burnish {

/// Limits of ankle torques. A foot tips as soon as the ankle torque moves the centre of pressure
/// beyond an edge of the sole. The foot is much lighter than the robot. Gains scaled with the
/// inertia of the whole robot, such as those of Fallback, therefore tip a foot even at small
/// speeds.
class SoleLimits {
 public:
  /// Creates limits for supports with force sensors and a residual::CenterOfPressure in the first
  /// stage of the problem, which defines the sole. Ankles are the joints next to a sole in the
  /// initial configuration. There are no limits for point feet, for robots without force sensors,
  /// and for robots with loops.
  explicit SoleLimits(const MpcSpec& spec);

  /// Clamps the ankle entries of tau (nv) so that no sole tips under its measured load [Nm].
  /// `wrenches`: Measurement::support_wrenches.
  void keep(const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches,
            Eigen::VectorXd& tau) const noexcept;

 private:
  struct Ankle {
    int entry;            ///< Entry of v.
    Eigen::Index sensor;  ///< Column of the wrenches.
    double lower, upper;  ///< Limits of the torque per newton of load [m].
    double hanging;       ///< Additional torque allowance, to hold a foot without load [Nm].
  };
  std::vector<Ankle> ankles_;
};

}  // namespace burnish
