// What every controller watches, whatever its task: the robot's own limits, and its plans.
#pragma once

#include "mpc/fault_latch.hpp"
#include "mpc/measurement_gate.hpp"
#include "mpc/torque_lag.hpp"

namespace burnish {

/// Joints beyond their limits of velocity and position, of the last good measurement.
void watch_joints(const Model& model, const SafetyLimits& limits, const MeasurementGate& gate,
                  FaultLatch& latch) noexcept;

/// A floating base that nothing tells of.
void watch_base(const SafetyLimits& limits, const MeasurementGate& gate,
                FaultLatch& latch) noexcept;

/// Updates in a row without a plan, or with a late one.
class PlanWatch {
 public:
  explicit PlanWatch(const SafetyLimits& limits) : limits_(limits) {}
  void reset() noexcept { failed_ = late_ = 0; }
  /// An update at `now` (s) that took `seconds` of wall clock. The first one may take longer, and
  /// may not fail. Whether it came later than it was due.
  bool judge(double now, bool usable, bool first, double seconds, FaultLatch& latch) noexcept;

 private:
  SafetyLimits limits_;
  int failed_ = 0, late_ = 0;
};

/// What motors give beside what they are told. Torques that come late are no motor that fails.
class MotorWatch {
 public:
  explicit MotorWatch(const MpcSpec& spec);
  void reset() noexcept {
    told_.setZero();
    lag_.reset();
    lost_ = -1;
  }
  /// After a good measurement, after a fault too; tau_before: nv, that was sent and should have
  /// acted when it was taken.
  void look(const MeasurementGate& gate, const ConstVectorRef& tau_before) noexcept;
  void watch(double now, FaultLatch& latch) const noexcept;
  int lost() const { return lost_; }  ///< entry of v, the first one found; -1: none
  /// s by which measured torques follow those that were sent, where that shows; else 0.
  double lag() const noexcept { return lag_.seconds(); }

 private:
  double allowed(int entry) const noexcept;

  std::vector<int> actuated_;
  double share_;  ///< SafetyLimits::torque_gap
  Eigen::VectorXd effort_;
  Eigen::VectorXd told_;  ///< nv, Nm (N), mean of what was sent
  TorqueLag lag_;
  int lost_ = -1;
};

}  // namespace burnish
