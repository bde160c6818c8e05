// Limits of the ankle torques of a standing robot, which keep its planar feet (soles) from tipping.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Limits of ankle torques. A foot tips as soon as the ankle torque moves the centre of pressure
/// beyond an edge of the sole. The foot is much lighter than the robot. Gains scaled with the
/// inertia of the whole robot, such as those of Fallback, therefore tip a foot even at small
/// speeds.
class SoleLimits {
 public:
  /// Sole of a support with a force sensor.
  struct Sole {
    std::string frame;      ///< Frame of the robot at the middle of the sole.
    int sensor;             ///< Column of MeasurementGate::wrenches().
    double half_x, half_y;  ///< Half sides of the sole [m].
  };
  /// Creates limits for the ankles, which are the joints next to a sole in the configuration `q`.
  /// There are no limits for robots with loops. `stiffness`: Fallback::stiffness.
  SoleLimits(const Model& model, const Eigen::VectorXd& q, const std::vector<Sole>& soles,
             double stiffness);

  /// Clamps the ankle entries of tau (nv) so that no sole tips under its measured load [Nm].
  /// `wrenches`: MeasurementGate::wrenches().
  void keep(const Wrenches& wrenches, Eigen::VectorXd& tau) const noexcept;

 private:
  struct Ankle {
    int entry;            ///< Entry of v.
    Eigen::Index sensor;  ///< Column of MeasurementGate::wrenches().
    double lower, upper;  ///< Limits of the torque per newton of load [m].
    double hanging;       ///< Additional torque allowance, to hold a foot without load [Nm].
  };
  std::vector<Ankle> ankles_;
};

}  // namespace burnish
