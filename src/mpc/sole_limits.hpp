// Ankle torques that the soles of a standing robot bear without tipping.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// Limits of ankle torques. A foot tips as soon as the ankle torque moves the centre of pressure
/// beyond an edge of its sole. Gains that are scaled with the whole robot's inertia, as those of
/// Fallback, exceed this limit even at small speeds, because a foot is much lighter than the robot.
class SoleLimits {
 public:
  /// Soles are those of residual::CenterOfPressure in the first stage of the problem, for supports
  /// with force sensors; ankles are the joints next to them, at the start. Empty for point feet,
  /// for robots without such sensors and for those with loops.
  explicit SoleLimits(const MpcSpec& spec);

  /// Clamps the ankle entries of tau (nv) so that no sole tips under its measured load [Nm].
  /// `wrenches`: Measurement::support_wrenches.
  void keep(const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches,
            Eigen::VectorXd& tau) const noexcept;

 private:
  struct Ankle {
    int entry;            ///< of v
    Eigen::Index sensor;  ///< column of the wrenches
    double least, most;   ///< torque per load [m]
    double hanging;       ///< torque allowed beyond that, to hold a foot without load [Nm]
  };
  std::vector<Ankle> ankles_;
};

}  // namespace burnish
