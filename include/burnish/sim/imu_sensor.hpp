// An inertial measurement unit on a simulated robot.
#pragma once

#include <memory>
#include <string>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/imu.hpp"
#include "burnish/sim/disturbances.hpp"

namespace burnish {

/// What a unit at a frame reads: means over the time since the reading before, such that a state
/// carried on with them, held, has the true rotation and velocity at the end; then bias, noise, the
/// steps of its converter and its faults, as the disturbances say. Allocates nothing after
/// construction and throws nothing.
class ImuSensor {
 public:
  /// `frame`: empty for the body of the robot's first joint. Throws Error as check_disturbances()
  /// does, and for a frame that is unknown or fixed to the world.
  ImuSensor(const Model& model, const std::string& frame, const Disturbances& disturbances);
  ~ImuSensor();
  ImuSensor(ImuSensor&&) noexcept;
  ImuSensor& operator=(ImuSensor&&) noexcept;

  /// Forgets the reading before, with the same biases and random numbers to come.
  void reset() noexcept;

  /// Reads the true state, q (nq) and v (nv), `elapsed` s after the last reading, which is to be
  /// more than 0. The first reading after reset() takes the frame to be without acceleration then,
  /// its noise being that of a reading over `elapsed` all the same. `time`: s, that faults begin
  /// by.
  const ImuReading& measure(const ConstVectorRef& q, const ConstVectorRef& v, double elapsed,
                            double time = 0.0) noexcept;
  const ImuReading& reading() const;  ///< the last one
  bool is_silent() const;             ///< a fault keeps it back

  const Eigen::Vector3d& gyro_bias() const;           ///< rad/s, as it is now
  const Eigen::Vector3d& accelerometer_bias() const;  ///< m/s^2, as it is now

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
