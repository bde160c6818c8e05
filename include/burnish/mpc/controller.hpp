// What a controller is to the simulation: measurements in, a torque out.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/estimate/imu.hpp"

namespace burnish {

/// What the sensors say at a tick.
/// @described mpc
struct Measurement {
  double time = 0.0;  ///< [s]
  Eigen::VectorXd q;  ///< nq
  Eigen::VectorXd v;  ///< nv
  /// of the robot's inertial measurement unit, if it has one @after tool_force_world
  std::optional<ImuReading> imu = {};
  Eigen::VectorXd tau;  ///< nv, of the torque sensors between motor and link, Nm or N
  /// Of the force sensor: the surface's force on the tool, N, world axes.
  Eigen::Vector3d tool_force_world = Eigen::Vector3d::Zero();
  /// of the sensors in what the robot stands on: force and moment of the ground on each support, N
  /// and Nm, at the origin of its frame, in the frame's axes; 6 x supports, or empty: not measured
  Eigen::Matrix<double, 6, Eigen::Dynamic> support_wrenches = {};
  /// [s] since nothing tells where a floating base is, whose entries of q and v are old; 0: it is
  /// told
  double base_lost_for = 0.0;
  /// by an EstimatedBase, which knows nothing of payloads @undescribed
  bool base_is_estimated = false;
};

/// What a controller sends. Only `tau` reaches the plant; the rest says what the controller aims at
/// and how it fares, for the record.
/// @described mpc
struct Command {
  Eigen::VectorXd tau;  ///< nv, Nm or N; zero for a floating base
  int phase = 0;        ///< where the task stands: of an MpcController, its place in the schedule
  double target_force = 0.0;  ///< [N], how hard the surface shall push back along its normal
  /// [m], of the tip frame's origin; where a task presses, on the surface as it is known
  Eigen::Vector3d p_target_world = Eigen::Vector3d::Zero();
  /// What the controller believes the surface's normal at the tool to be, world axes.
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// What the controller believes the surface's force on the tool to be, N, world axes.
  Eigen::Vector3d force_estimate_world = Eigen::Vector3d::Zero();
  /// What it believes the coefficient of friction between tool and surface to be.
  double friction = 0.0;
  Status status = Status::Ok;
  double solve_time = 0.0;       ///< [s] of wall clock, where an optimal control problem was solved
  int iterations = 0;            ///< of its solver
  bool missed_deadline = false;  ///< its solution came later than it was due
  /// Of the last plan of a controller that keeps limits: the largest violation of a hard one along
  /// it, and what was left open when its budget was spent, as shares of a limit's scale.
  double limits_outside = 0.0;
  double limits_open = 0.0;
  int limits_pushing = 0;          ///< limits that push, over all knots
  bool limits_infeasible = false;  ///< they cannot all be kept from here on
  int clipped_torques = 0;  ///< joints whose torque was cut to what may be sent, at this tick
};

/// Runs at a fixed period. Ticks allocate nothing and throw nothing.
class Controller {
 public:
  virtual ~Controller() = default;
  virtual int nv() const = 0;
  /// Forgets all ticks before.
  virtual void reset() noexcept = 0;
  /// The command that follows a measurement, at once; valid until the next call. Numerical trouble
  /// shows in its status, and its torque is then one that can be applied.
  virtual const Command& tick(const Measurement& measurement) noexcept = 0;

  /// Whether the controller was given a payload that its model does not have.
  virtual bool carries_payload() const noexcept { return false; }
  /// Declares that an EstimatedBase makes the measurements. The controller rejects payloads from
  /// then on.
  virtual void expect_estimated_base() noexcept {}

 protected:
  Controller() = default;
  Controller(const Controller&) = default;
  Controller& operator=(const Controller&) = default;
};

}  // namespace burnish
