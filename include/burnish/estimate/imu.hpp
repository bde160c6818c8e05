// What an inertial measurement unit says.
#pragma once

#include <Eigen/Core>

namespace burnish {

/// What an inertial measurement unit says, in the axes of the frame that it stands for: means over
/// the time since the reading before.
/// @described estimate
struct ImuReading {
  Eigen::Vector3d gyro = Eigen::Vector3d::Zero();  ///< [rad/s]
  /// [m/s^2], specific force: acceleration minus gravity, so that at rest it points up
  Eigen::Vector3d accelerometer = Eigen::Vector3d::Zero();
};

}  // namespace burnish
