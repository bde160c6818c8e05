// Reading of an inertial measurement unit (IMU).
#pragma once

#include <Eigen/Core>

namespace burnish {

/// Reading of an inertial measurement unit (IMU): mean values since the previous reading, in the
/// axes of the IMU frame.
/// @described estimate
struct ImuReading {
  Eigen::Vector3d gyro = Eigen::Vector3d::Zero();  ///< Angular velocity [rad/s]

  /// Specific force: acceleration minus gravity [m/s^2] @more At rest, this vector points up.
  Eigen::Vector3d accelerometer = Eigen::Vector3d::Zero();
};

}  // namespace burnish
