// A simulated inertial measurement unit on a robot.
#pragma once

#include <memory>
#include <string>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/imu.hpp"
#include "burnish/sim/disturbances.hpp"

namespace burnish {

/// Simulates an inertial measurement unit at a frame of the robot. A reading is a mean over the
/// time since the previous reading. If the readings have no errors, their integral with zero-order
/// hold is the true rotation and velocity.
///
/// Bias, noise, quantization and faults are set in Disturbances. After construction nothing is
/// allocated or thrown.
class ImuSensor {
 public:
  /// Mounts the unit at `frame` (empty: the body of the robot's first joint). Throws Error in the
  /// same cases as check_disturbances(), and for a frame that is unknown or fixed to the world.
  ImuSensor(const Model& model, const std::string& frame, const Disturbances& disturbances);
  ~ImuSensor();
  ImuSensor(ImuSensor&&) noexcept;
  ImuSensor& operator=(ImuSensor&&) noexcept;

  /// Restarts the sensor: discards the previous reading, and restarts the sequence of random
  /// numbers with the same initial biases as before.
  void reset() noexcept;

  /// Returns the reading at the robot's true configuration q (nq entries) and velocity v (nv
  /// entries). `elapsed` is the time since the previous reading [s], > 0. `time` is the present
  /// time [s], which determines the active faults.
  ///
  /// For the first reading after reset(), the frame is assumed not to accelerate. The noise of the
  /// first reading is computed for a mean over `elapsed`.
  const ImuReading& measure(const ConstVectorRef& q, const ConstVectorRef& v, double elapsed,
                            double time = 0.0) noexcept;
  const ImuReading& reading() const;  ///< The last reading
  bool is_silent() const;             ///< Whether a fault suppressed the last reading

  const Eigen::Vector3d& gyro_bias() const;           ///< Present bias of the gyroscope [rad/s]
  const Eigen::Vector3d& accelerometer_bias() const;  ///< Present bias of the accelerometer [m/s^2]

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
