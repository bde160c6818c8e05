// Ankle torques that the soles of a standing robot bear without tipping.
#pragma once

#include <vector>

#include "burnish/mpc/mpc.hpp"

namespace burnish {

/// A foot that bears the load f_z on its sole tips as soon as the ankle's torque moves the centre
/// of pressure beyond an edge. Feet are light beside what they carry, so that a torque in the
/// metric of the whole robot exceeds that at small speeds already.
class SoleLimits {
 public:
  /// Soles are those of residual::CenterOfPressure in the first stage of the problem, for supports
  /// with force sensors; ankles are the joints next to them, at the start. Empty for point feet,
  /// for robots without such sensors and for those with loops.
  explicit SoleLimits(const MpcSpec& spec);

  /// Limits tau (nv, Nm) of the ankles to what the soles bear under the measured loads.
  /// `wrenches`: Measurement::support_wrenches.
  void keep(const Eigen::Matrix<double, 6, Eigen::Dynamic>& wrenches,
            Eigen::VectorXd& tau) const noexcept;

 private:
  struct Ankle {
    int entry;            ///< of v
    Eigen::Index sensor;  ///< column of the wrenches
    double least, most;   ///< torque per load [m]
    double hanging;       ///< torque that holds a foot that hangs [Nm]
  };
  std::vector<Ankle> ankles_;
};

}  // namespace burnish
