// Torques that brake and hold the robot after a fault, by a spring and a damper (see Fallback).
#pragma once

#include <Eigen/Cholesky>

#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/mpc/mpc_spec.hpp"
#include "dynamics/tree.hpp"
#include "mpc/sole_limits.hpp"

namespace burnish {

/// Settings of a Holding.
struct HoldingSpec {
  Model model;
  Eigen::VectorXd q_start;  ///< Configuration until the first valid measurement.
  Fallback fallback;
  double tick_period;  ///< Time between ticks [s].
  double bad;          ///< Longest time with invalid measurements (SafetyLimits::bad) [s].
  std::vector<ContactSpec>
      supports;              ///< Contacts that hold the robot in every stage, except loops.
  std::vector<int> sensors;  ///< Column of each support in wrenches of torque(); -1: no sensor.
  std::vector<SoleLimits::Sole> soles;  ///< Soles of the supports with sensors.
};

class Holding {
 public:
  Holding(const HoldingSpec& spec, std::vector<int> actuated);

  void reset() noexcept;
  /// Sets the payload at a frame, see ContactDynamics::set_payload(). `loaded`: body that carries
  /// the frame, including the payload; LoadedBody::status must be Ok.
  void set_payload(std::string_view frame, const InertiaSpec& payload, const LoadedBody& loaded);
  /// Marks a motor as failed until reset(). `entry`: entry of v that the motor drives; -1: no
  /// failed motor.
  void set_failed_motor(int entry) noexcept { failed_ = entry; }
  /// Releases the spring. Its new rest configuration is the measured configuration at the next call
  /// of torque().
  void release() noexcept { holding_ = false; }
  /// Sets `tau` (nv) [Nm or N] to the holding torque at q and v, or to zero if the dynamics cannot
  /// be evaluated. `fresh`: true if q and v were measured at this tick. `wrenches`:
  /// MeasurementGate::wrenches().
  void torque(const Eigen::VectorXd& q, const Eigen::VectorXd& v, bool fresh,
              const Wrenches& wrenches, Eigen::VectorXd& tau) noexcept;
  /// Returns the torques that hold the robot still (nv) [Nm or N]: the gravity torques b(q, 0) for
  /// the actuated entries, zero for the other entries. On a robot with loops or supports, the
  /// torques also carry the load of the unactuated joints. Returns null if the dynamics cannot be
  /// evaluated.
  const Eigen::VectorXd* at_rest(const Eigen::VectorXd& q) noexcept;
  /// Returns the limits of ankle torques, which commands of plans must satisfy too.
  const SoleLimits& soles() const noexcept { return soles_; }

 private:
  bool update_spring(const Eigen::VectorXd& q, bool fresh) noexcept;
  bool compute_free_inertia(const Eigen::VectorXd& q) noexcept;
  void remove_failed_motor() noexcept;
  void blend_with_hanging(const Eigen::VectorXd& q, const Wrenches& wrenches) noexcept;
  bool compute_closed_inertia(const Eigen::VectorXd& q) noexcept;

  Fallback fallback_;
  double tick_period_;
  /// Longest time without valid measurements for which the spring stays on [s].
  double bridged_;
  std::vector<int> actuated_;
  Eigen::VectorXd effort_;
  Tree tree_;
  bool is_closed_;
  int failed_ = -1;       ///< Entry of v whose motor has failed; -1: no failed motor.
  ContactDynamics free_;  ///< Dynamics with the supports and loops as the only contacts.
  /// Foot with a force sensor. While the sensor measures no load, the leg of the foot is controlled
  /// as a hanging leg.
  struct Foot {
    Eigen::Index sensor;  ///< Column of the foot's sensor in the wrenches.
    /// Per entry of v: 1 if the entry is between this foot and the base.
    std::vector<char> carries;
  };
  std::vector<Foot> feet_;
  SoleLimits soles_;
  ContactDynamics open_;  ///< Dynamics of the robot in the air, without supports.
  /// Load fraction of each entry of v: 1 for joints of loaded legs, 0 for joints of hanging legs.
  Eigen::VectorXd load_fraction_;
  double gravity_;          ///< Gravitational acceleration [m/s^2].
  double weight_per_foot_;  ///< Weight of robot and payload, divided by the number of feet with
                            ///< sensors [N].
  /// Results of the last at_rest(): holding torques weight_, and inertia mass_ of the actuated
  /// entries (nv x nv).
  Eigen::VectorXd weight_;
  Eigen::MatrixXd mass_;
  /// Matrices for the actuated entries alone; used for a robot with loops or supports.
  Eigen::MatrixXd mobility_, square_, inertia_;
  Eigen::VectorXd fall_, scale_;
  Eigen::LLT<Eigen::MatrixXd> factor_;
  Eigen::VectorXd zero_, q_hold_, error_, stretch_, pull_;  ///< Sizes nv, nq, nv, nv, nv.
  double blind_for_ = 0.0;  ///< Time without a valid measurement [s].
  bool holding_ = false;    ///< True if the spring is on; q_hold_ is its rest configuration.
};

}  // namespace burnish
