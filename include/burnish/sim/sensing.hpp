// What a controller gets to see of a plant.
#pragma once

#include <memory>
#include <vector>

#include "burnish/mpc/controller.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/imu_sensor.hpp"
#include "burnish/sim/plant.hpp"

namespace burnish {

struct Tree;

/// The chain noise, encoder, differences, filters and delay. Called once per tick of the
/// controller; allocates nothing after construction and throws nothing.
class Sensing {
 public:
  /// `supports`: of the plant's scene, whose wrenches are measured. `period`: s between
  /// measurements, which their delay is rounded to. Throws Error as check_disturbances() does.
  Sensing(const Model& model, const Disturbances& disturbances, int supports = 0,
          double period = 1e-3);
  ~Sensing();

  /// From now on measurements have readings of an inertial measurement unit at a frame of the
  /// robot, empty: its first body. Throws Error as ImuSensor.
  void mount_imu(const Model& model, const std::string& frame);

  /// Forgets all measurements, with the same random numbers to come.
  void reset() noexcept;

  /// Reads the plant; `applied` (nv) is the motors' torque during the plant's last step. The first
  /// measurement after reset() starts the filters: differences begin at the true velocity, and what
  /// is on its way then says the same. With
  /// velocities by finite differences, entries of a floating base stay true.
  const Measurement& measure(const Plant& plant, const ConstVectorRef& applied) noexcept;

 private:
  struct Random;
  void measure_position(const Plant& plant) noexcept;
  void measure_velocity(const Plant& plant) noexcept;
  void measure_force(const Plant& plant) noexcept;
  void measure_supports(const Plant& plant) noexcept;
  const Measurement& delayed() noexcept;

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
  std::vector<Measurement> late_;  ///< a ring of what is on its way; empty without a delay
  std::size_t next_ = 0;           ///< the oldest of them
};

}  // namespace burnish
