// Simulated sensors, which compute a controller's measurement from the state of a plant.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/estimate/measurement.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/imu_sensor.hpp"
#include "burnish/sim/plant.hpp"

namespace burnish {

struct Tree;

/// Simulates the sensors: noise, encoders, finite differences, low-pass filters and delay. Call
/// measure() once per tick of the controller. After construction nothing is allocated or thrown.
class Sensing {
 public:
  /// Creates the sensors of a plant with scene `scene`. `touches`: frames of the columns of
  /// Measurement::wrenches. `period` is the time between measurements [s]. The measurement delay is
  /// rounded to a multiple of `period`. Throws Error in the same cases as check_disturbances(), and
  /// for a frame without a touch in the scene.
  Sensing(const Model& model, const Disturbances& disturbances, const SceneSpec& scene,
          const std::vector<std::string>& touches, double period = 1e-3);
  ~Sensing();

  /// Adds readings of an inertial measurement unit to all later measurements. The unit is mounted
  /// at `frame` (empty: the robot's first body). Throws Error in the same cases as ImuSensor.
  void mount_imu(const Model& model, const std::string& frame);

  /// Discards all measurements and restarts the sequence of random numbers.
  void reset() noexcept;

  /// Returns the measurement of the plant's present state. `applied` (nv entries) are the torques
  /// of the motors during the plant's last step [Nm or N].
  ///
  /// The first measurement after reset() initializes the filters, and is returned until the
  /// measurement delay has passed. Finite-difference velocities start at the true velocity. For a
  /// floating base, the true velocity is measured instead of finite differences.
  const Measurement& measure(const Plant& plant, const ConstVectorRef& applied) noexcept;

 private:
  struct Random;
  void measure_position(const Plant& plant) noexcept;
  void measure_velocity(const Plant& plant) noexcept;
  void measure_wrenches(const Plant& plant) noexcept;
  const Measurement& delayed() noexcept;

  Disturbances disturbances_;
  std::vector<Joint> joints_;
  std::unique_ptr<const Tree> tree_;
  std::unique_ptr<Random> random_;
  bool started_ = false;
  double elapsed_ = 0.0;         ///< Time since the previous measurement [s]
  Eigen::VectorXd q_before_;     ///< Previous measured positions, nq entries
  Eigen::VectorXd differences_;  ///< Filtered finite-difference velocities, nv entries
  Eigen::VectorXd work_;         ///< Scratch vector, nv entries
  std::optional<ImuSensor> imu_;
  struct TouchSensor {
    Eigen::Index touch;  ///< Index of the touch in the scene.
    WrenchSensor components;
  };
  std::vector<TouchSensor> sensors_;  ///< One per column of Measurement::wrenches.
  Measurement measurement_;
  std::vector<Measurement> late_;  ///< Ring buffer of delayed measurements; empty without a delay
  std::size_t next_ = 0;           ///< Index of the oldest measurement in late_
};

}  // namespace burnish
