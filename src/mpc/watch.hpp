// Monitors for all controllers, independent of their tasks: joints, base, plans and motors.
#pragma once

#include "estimate/support_grip.hpp"
#include "mpc/fault_latch.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/torque_lag.hpp"

namespace burnish {

/// Raises a fault if a joint exceeded its limit of velocity or position in the last valid
/// measurement.
void watch_joints(const Model& model, const SafetyLimits& limits, const MeasurementGate& gate,
                  FaultLatch& latch) noexcept;

/// Raises a fault if the estimate of a floating base has been missing for too long.
void watch_base(const SafetyLimits& limits, const MeasurementGate& gate,
                FaultLatch& latch) noexcept;

/// Raises a fault if a support slid farther than SafetyLimits::support_slip. Does not allocate if
/// the report has room for the support's name.
void watch_supports(const SupportGrip& grip, const SafetyLimits& limits, double now,
                    FaultLatch& latch) noexcept;

/// Monitor of solves, which counts successive updates that gave no plan or a late plan.
class PlanWatch {
 public:
  explicit PlanWatch(const SafetyLimits& limits) : limits_(limits) {}
  void reset() noexcept { failed_ = late_ = 0; }
  /// Records an update at the time `now` [s], whose solve took `seconds` of wall-clock time. The
  /// first update may be late but must give a plan. Returns true if the update missed its deadline.
  bool judge(double now, bool usable, bool first, double seconds, FaultLatch& latch) noexcept;

 private:
  SafetyLimits limits_;
  int failed_ = 0, late_ = 0;
};

/// Monitor of motors, which compares measured with commanded torques. A mere delay of the measured
/// torques does not count as a failure.
class MotorWatch {
 public:
  /// `tick_period`: time between ticks [s].
  MotorWatch(const Model& model, const SafetyLimits& limits, double tick_period);
  void reset() noexcept {
    commanded_.setZero();
    dead_for_.setZero();
    lag_.reset();
    lost_ = -1;
  }
  /// Updates the monitor after a valid measurement; call it after a fault too. `tau_before`:
  /// commanded torque that should have acted at the measurement (nv).
  void look(const MeasurementGate& gate, const ConstVectorRef& tau_before) noexcept;
  void watch(double now, FaultLatch& latch) const noexcept;
  /// Returns the entry of v of the first failed motor; -1: no failed motor.
  int lost() const { return lost_; }
  /// Returns the lag of measured behind commanded torques [s]; 0 if no lag is visible.
  double lag() const noexcept { return lag_.seconds(); }

 private:
  // Factors on SafetyLimits::torque_gap for a dead motor: `dead_factor` at once,
  // `long_dead_factor` after `long_dead` [s]; chosen by hand. The shipped tasks have a torque_gap
  // of 0.25, so that the lower limit is a tenth of the effort limit.
  static constexpr double dead_factor = 0.6, long_dead_factor = 0.4, long_dead = 0.1;

  bool is_dead(int entry) const noexcept;
  double max_gap(int entry) const noexcept;

  std::vector<int> actuated_;
  double gap_fraction_;  ///< SafetyLimits::torque_gap.
  Eigen::VectorXd effort_;
  Eigen::VectorXd commanded_;  ///< Mean commanded torque, nv [Nm or N].
  /// Time for which each motor has been dead with a torque gap above its lowest limit, nv [s].
  Eigen::VectorXd dead_for_;
  TorqueLag lag_;
  int lost_ = -1;
};

}  // namespace burnish
