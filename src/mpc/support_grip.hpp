// Grip of the supports that are in contact in every stage: detection of slip, and the coefficient
// of friction that plans use.
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
  /// Updates the estimates after a valid measurement.
  void update(const MeasurementGate& gate) noexcept;
  /// Raises a fault if a support slid farther than SafetyLimits::support_slip.
  void watch(double now, FaultLatch& latch) const noexcept;

  /// Returns the coefficient of friction that plans use, per support; infinite if the support has
  /// no friction cone.
  const Eigen::VectorXd& friction() const { return friction_; }
  /// Returns the length of the longest name of a support, to reserve memory in a fault report.
  std::size_t longest_name() const;

 private:
  struct Support {
    std::string name;
    int frame;
    int sensor;             ///< Column of Measurement::support_wrenches; -1: no sensor.
    double cone;            ///< Friction in the specification; infinite: no cone.
    double half_x, half_y;  ///< Half sides of the sole in plans [m]; 0: point foot.
    Eigen::Vector3d slid;   ///< Recent displacement along the ground, in world axes [m].
    double speed;           ///< Sliding speed along the ground [m/s].
    double distance;        ///< Length of `slid` [m].
  };
  void follow(Support& support, const MeasurementGate& gate) const noexcept;
  double required_friction(const Support& support, const Eigen::Matrix<double, 6, 1>& wrench,
                           const Eigen::Matrix3d& R, double load) const noexcept;
  void update_friction(const Support& support, const MeasurementGate& gate,
                       double& friction) const noexcept;

  SlipOptions options_;
  double allowed_;  ///< SafetyLimits::support_slip [m].
  Eigen::Vector3d up_;
  std::vector<Support> supports_;
  Eigen::VectorXd friction_;
};

}  // namespace burnish
