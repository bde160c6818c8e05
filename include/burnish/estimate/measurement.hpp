// Values of a robot's sensors, which estimators and controllers read.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>

#include "burnish/base/views.hpp"
#include "burnish/estimate/imu.hpp"

namespace burnish {

/// Components of a wrench that a sensor measures, or that a controller reads.
/// @described mpc
enum class WrenchSensor {
  Automatic,  ///< Force of a tool, force and moment of a support
  None,       ///< No component
  Force,      ///< Force, but no moment
  Wrench,     ///< Force and moment
};

/// Wrench sensor at a touch of the robot (tool, foot or hand).
/// @described mpc
struct TouchSensor {
  /// Frame of the touch
  std::string frame = {};
  /// Components that the controller reads
  /// @more Automatic: force and moment of a support, only the force of a tool
  WrenchSensor sensor = WrenchSensor::Automatic;
};

/// Sensor values at one tick.
/// @described mpc
struct Measurement {
  /// Time of the measurement [s]
  double time = 0.0;
  /// Measured configuration, nq entries
  Eigen::VectorXd q;
  /// Measured velocity, nv entries
  Eigen::VectorXd v;
  /// Reading of the inertial measurement unit; empty if the robot has none
  /// @after wrenches
  std::optional<ImuReading> imu = {};
  /// Joint torques measured between motor and link, nv entries [Nm (N)]
  Eigen::VectorXd tau;
  /// Measured wrenches that surfaces exert on the robot, one column per entry of
  /// Controller.touches: force (N), then moment (Nm)
  /// @more Each entry names the frame of a tool, foot or hand. Moments are about the origin of this
  /// frame. Force and moment are in the axes of this frame and exclude the weight of the tool or
  /// foot. Components that no sensor measures are NaN
  Wrenches wrenches = {};
  /// Returns the force in a column of `wrenches`, in the axes of the frame of the tool or foot [N].
  /// Returns NaN if there is no such column.
  Eigen::Vector3d force_at(Eigen::Index column) const noexcept {
    if (column < 0 || column >= wrenches.cols())
      return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    return wrenches.col(column).head<3>();
  }
  /// Time since the last position estimate of a floating base [s]
  /// @more The value 0 means that the estimate is current. While the value is positive, the
  /// floating base's entries of q and v are outdated
  double base_lost_for = 0.0;
  /// True if the floating base's entries of q and v were computed by an EstimatedBase
  /// @undescribed
  bool base_is_estimated = false;
  /// Mass of all payloads of the EstimatedBase, if base_is_estimated is true [kg]
  /// @undescribed
  double base_payload = 0.0;
};

}  // namespace burnish
