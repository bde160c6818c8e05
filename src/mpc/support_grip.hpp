// Supports that hold always: whether they do, and what friction plans may reckon with.
#pragma once

#include <limits>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "mpc/fault_latch.hpp"
#include "mpc/measurement_gate.hpp"

namespace burnish {

class SupportGrip {
 public:
  explicit SupportGrip(const MpcSpec& spec);

  void reset() noexcept;
  /// After a good measurement.
  void update(const MeasurementGate& gate) noexcept;
  /// SafetyLimits::support_way.
  void watch(double now, FaultLatch& latch) const noexcept;

  /// Of each: the coefficient of friction that plans reckon with; infinite without a cone.
  const Eigen::VectorXd& friction() const { return friction_; }
  /// Longest name of a support, that a fault's report has room for.
  std::size_t longest_name() const;

 private:
  struct Support {
    std::string name;
    int frame;
    int sensor;             ///< column of Measurement::support_wrenches; -1: none
    double cone;            ///< friction that plans reckon with at first; infinite: no cone
    double half_x, half_y;  ///< m, of the sole in plans; 0: a ball
    Eigen::Vector3d slid;   ///< m, world, along the ground, what is longer ago forgotten
    double speed, way;      ///< m/s along the ground, and how far it has slid, m
  };
  void follow(Support& support, const MeasurementGate& gate) const noexcept;
  double felt(const Support& support, const Eigen::Matrix<double, 6, 1>& wrench,
              const Eigen::Matrix3d& R, double load) const noexcept;
  void judge(const Support& support, const MeasurementGate& gate, double& friction) const noexcept;

  SlipOptions options_;
  double allowed_;  ///< m, SafetyLimits::support_way
  Eigen::Vector3d up_;
  std::vector<Support> supports_;
  Eigen::VectorXd friction_;
};

}  // namespace burnish
