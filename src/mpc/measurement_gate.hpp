// Check of measurements. The gate also advances the time while measurements are missing or invalid.
#pragma once

#include "burnish/mpc/mpc_spec.hpp"
#include "estimate/robot_state.hpp"
#include "mpc/fault_latch.hpp"

namespace burnish {

/// Settings of a MeasurementGate.
struct GateSpec {
  Model model;
  std::vector<ContactSpec> contacts;  ///< Contacts of MeasurementGate::state().
  std::vector<ToolFrames> tools;      ///< Tools of MeasurementGate::state().
  Eigen::VectorXd q_start;            ///< Configuration until the first valid measurement.
  std::vector<TouchSensor> touches;   ///< Columns of Measurement::wrenches.
  SafetyLimits limits;                ///< Only `bad` and `stale` are used.
  double tick_period;                 ///< Time between ticks [s].
};

/// Gate that checks measurements and keeps the last valid one. A measurement is invalid if it
/// contains a NaN, an infinity or a vector of wrong size, or if its time does not increase. NaN is
/// allowed only in components of wrenches that GateSpec::touches excludes, and in moments on tools.
/// While measurements are invalid, the time advances by one tick period per tick, until one of the
/// limits `bad` and `stale` is reached.
class MeasurementGate {
 public:
  explicit MeasurementGate(const GateSpec& spec);

  void reset() noexcept;
  /// Checks the measurement of a tick. After a fault, only position and velocity must be valid.
  /// Sets `status` to NotEvaluated if the time does not increase, and to NotFinite for any other
  /// invalid measurement. A valid measurement leaves `status` unchanged.
  void take(const Measurement& m, FaultLatch& latch, Status& status) noexcept;

  bool is_fresh() const { return fresh_; }  ///< True if the measurement of this tick is valid.
  bool is_first() const { return first_; }  ///< True if this measurement is the first valid one.
  double dt() const {
    return dt_;
  }  ///< Time since the previous valid measurement; 0 for first or invalid measurements [s].
  double now() const { return now_; }  ///< Time of this tick [s].
  const Measurement& last() const { return last_; }
  /// State of the robot at the last valid measurement, with the contacts of the specification.
  RobotState& state() { return state_; }
  const RigidBody& body() const { return state_.body(); }  ///< Kinematics of state().
  /// Returns the force of the surface on each tool at the last valid measurement, in world axes, 3
  /// x tools [N].
  const Eigen::Matrix3Xd& tool_forces_world() const { return tool_forces_world_; }
  /// Returns the wrenches at the last valid measurement: one column per touch with a sensor, such
  /// as a foot, except tools. A moment that is not measured is zero.
  const Wrenches& wrenches() const { return wrenches_; }
  /// Sets the forces at the tools of a robot without force sensors, in world axes, 3 x tools [N].
  void feel(const Eigen::Matrix3Xd& forces_world) noexcept { tool_forces_world_ = forces_world; }
  /// Multiplies the velocity of last() by `factor`, for ticks without a valid measurement.
  void fade_velocity(double factor) noexcept { last_.v *= factor; }

 private:
  bool accept(const Measurement& m, FaultLatch& latch, Status& status) noexcept;
  /// Sensor of a touch (tool or foot).
  struct Sensor {
    std::string frame;
    Eigen::Index column;  ///< Column of Measurement::wrenches.
    Eigen::Index rows;    ///< Number of measured components that are read: 3 (force) or 6.
    bool is_finite(const Measurement& m) const {
      return m.wrenches.col(column).head(rows).allFinite();
    }
  };
  bool has_wrenches(const Measurement& m) const noexcept;
  void take_wrenches(const Measurement& m) noexcept;
  void describe_defect(const Measurement& m) noexcept;
  void describe_wrenches(const Measurement& m) noexcept;
  template <class Entries>
  bool is_bad(const char* what, const Entries& entries,
              const std::vector<std::string>& names) noexcept;
  bool take_state(const Measurement& m) noexcept;
  void bridge(FaultLatch& latch, FaultKind kind, double limit) noexcept;

  SafetyLimits limits_;
  std::vector<std::string> q_names_, v_names_;
  char bad_[160] = "";  ///< Description of what was wrong with the last invalid measurement.
  double tick_period_;
  /// Force sensor at a tool.
  struct ToolSensor {
    Sensor sensor;
    int frame;          ///< Frame of the tool.
    Eigen::Index tool;  ///< Column of tool_forces_world_.
  };
  Eigen::Index touches_;  ///< Number of columns of Measurement::wrenches.
  std::vector<ToolSensor> tool_sensors_;
  std::vector<Sensor> sensors_;  ///< Sensors of all touches except tools.
  Eigen::VectorXd q_start_;
  RobotState state_;
  Measurement last_;  ///< Last valid measurement, with its own time.
  Eigen::Matrix3Xd tool_forces_world_;
  Wrenches wrenches_;
  double now_ = 0.0, dt_ = 0.0;
  bool started_ = false;  ///< True after the first valid measurement, unless a fault came before.
  bool fresh_ = false, first_ = false;
};

}  // namespace burnish
