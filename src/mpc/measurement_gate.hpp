// Which measurements are states, and what time it is while there are none.
#pragma once

#include "burnish/derivatives/rigid_body.hpp"
#include "burnish/mpc/mpc.hpp"
#include "mpc/fault_latch.hpp"

namespace burnish {

/// Keeps the last good measurement. One that is none (NaN, wrong sizes, time that stands still) is
/// bridged: time goes on by ticks until the limits' `bad` or `stale` is over.
class MeasurementGate {
 public:
  explicit MeasurementGate(const MpcSpec& spec);

  void reset() noexcept;
  /// At each tick. While a fault is latched a position and a velocity will do. Status: NotEvaluated
  /// for time that stands still, NotFinite for what is no state, else as it was.
  void take(const Measurement& m, FaultLatch& latch, Status& status) noexcept;

  bool is_fresh() const { return fresh_; }  ///< this tick's is good
  bool is_first() const { return first_; }  ///< and no good one was before
  double dt() const { return dt_; }         ///< s from the good one before to this one
  double now() const { return now_; }       ///< s, of this tick
  const Measurement& last() const { return last_; }
  const RigidBody& body() const { return body_; }  ///< at last()
  /// RigidBody::set_payload.
  void set_payload(std::string_view frame, const InertiaSpec& payload) {
    (void)body_.set_payload(frame, payload);
  }
  /// The force at the tool in place of a sensor's, N, world axes.
  void feel(const Eigen::Vector3d& force_world) noexcept { last_.tool_force_world = force_world; }
  /// Of the velocity, what stays, where it is of long ago.
  void fade_velocity(double share) noexcept { last_.v *= share; }

 private:
  bool accept(const Measurement& m, FaultLatch& latch, Status& status) noexcept;
  void say_what_is_bad(const Measurement& m) noexcept;
  template <class Entries>
  bool is_bad(const char* what, const Entries& entries,
              const std::vector<std::string>& names) noexcept;
  bool take_state(const Measurement& m) noexcept;
  void bridge(FaultLatch& latch, FaultKind kind, double limit) noexcept;

  SafetyLimits limits_;
  std::vector<std::string> q_names_, v_names_, support_names_;
  char bad_[160] = "";  ///< what is wrong with the last measurement that was none
  double tick_period_;
  bool has_force_;
  Eigen::Index supports_;  ///< whose wrenches are measured
  Eigen::VectorXd q_start_;
  RigidBody body_;
  Measurement last_;  ///< its time is that of the last good one
  double now_ = 0.0, dt_ = 0.0;
  bool started_ = false;  ///< there was a good measurement before any fault
  bool fresh_ = false, first_ = false;
};

}  // namespace burnish
