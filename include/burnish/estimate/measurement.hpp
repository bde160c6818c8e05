// Values of a robot's sensors, which estimators and controllers read.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "burnish/base/views.hpp"
#include "burnish/estimate/imu.hpp"

namespace burnish {

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
  /// @after tool_wrench
  std::optional<ImuReading> imu = {};
  /// Joint torques measured between motor and link, nv entries [Nm (N)]
  Eigen::VectorXd tau;
  /// Measured wrench of the surface on the tool: force (N), then moment (Nm)
  /// @more Moments are about the origin of the tool's frame. Force and moment are in the axes of
  /// this frame and exclude the weight of the tool. Components that no sensor measures are NaN.
  /// Controllers use only the force
  Vector6 tool_wrench = Vector6::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Measured wrench of the ground on each support, one column per support: force (N), then moment
  /// (Nm)
  /// @more Moments are about the origin of the support's frame. Force and moment are in the axes of
  /// this frame. Empty if wrenches are not measured
  Eigen::Matrix<double, 6, Eigen::Dynamic> support_wrenches = {};
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
