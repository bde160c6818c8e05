// What a controller gets to see of a plant.
#pragma once

#include <memory>

#include "burnish/mpc/controller.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/imu_sensor.hpp"
#include "burnish/sim/plant.hpp"

namespace burnish {

struct Tree;

/// The chain noise, encoder, differences and filters. Called once per tick of the controller;
/// allocates nothing after construction and throws nothing.
class Sensing {
 public:
  /// `supports`: of the plant's scene, whose wrenches are measured. Throws Error as
  /// check_disturbances() does.
  Sensing(const Model& model, const Disturbances& disturbances, int supports = 0);
  ~Sensing();

  /// From now on measurements have readings of an inertial measurement unit at a frame of the
  /// robot, empty: its first body. Throws Error as ImuSensor.
  void mount_imu(const Model& model, const std::string& frame);

  /// Forgets all measurements, with the same random numbers to come.
  void reset() noexcept;

  /// Reads the plant; `applied` (nv) is the motors' torque during the plant's last step. The first
  /// measurement after reset() starts the filters: differences begin at the true velocity. With
  /// velocities by finite differences, entries of a floating base stay true.
  const Measurement& measure(const Plant& plant, const ConstVectorRef& applied) noexcept;

 private:
  struct Random;
  void measure_position(const Plant& plant) noexcept;
  void measure_velocity(const Plant& plant) noexcept;
  void measure_force(const Plant& plant) noexcept;
  void measure_supports(const Plant& plant) noexcept;

  Disturbances disturbances_;
  std::vector<Joint> joints_;
  std::unique_ptr<const Tree> tree_;
  std::unique_ptr<Random> random_;
  bool started_ = false;
  double elapsed_ = 0.0;         ///< s since the last measurement
  Eigen::VectorXd q_before_;     ///< nq, as measured
  Eigen::VectorXd differences_;  ///< nv, filtered
  Eigen::VectorXd work_;         ///< nv
  std::optional<ImuSensor> imu_;
  Measurement measurement_;
};

}  // namespace burnish
