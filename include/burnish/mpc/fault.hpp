// Faults of a control loop and their reports.
#pragma once

#include <string>
#include <string_view>

#include "burnish/base/trace.hpp"

namespace burnish {

/// Kinds of faults that can occur in a control loop.
/// @described mpc
enum class FaultKind {
  None,
  StaleMeasurement,  ///< No new measurement arrived for too long
  BadMeasurement,    ///< Measurements had NaN, infinity or a wrong size for too long
  OutOfRange,        ///< A joint exceeds its position limit by more than the margin
  SolverFailed,      ///< Too many solves in a row, or the first solve, gave no usable plan
  SolverLate,        ///< Too many solves in a row took longer than the deadline
  ContactLost,  ///< The contact force was missing for too long in a phase that requires contact
  NoContact,    ///< The tool moved too far without contact after contact was due
  ContactLate,  ///< Contact did not occur within the allowed time after it was due
  UnexpectedContact,  ///< A contact force acts while the tool should move in free space
  ForceLimit,         ///< The contact force at the tool is larger than allowed
  SpeedLimit,         ///< A joint or the tool moves faster than allowed
  SupportSlipped,     ///< A support of the robot, such as a foot, moved too far
  MotorLost,          ///< The measured torque of a joint deviates too much from the command
  Watched,   ///< A quantity that the task monitors (FaultReport.quantity) exceeds its limit
  BaseLost,  ///< A floating base had no position estimate for too long
};

/// Returns the name of a fault kind, such as "contact lost".
std::string_view name_of(FaultKind kind);

/// Report of the first fault of a run, with the ticks before the fault.
/// @described mpc
struct FaultReport {
  FaultKind kind = FaultKind::None;
  /// Time of the measurement that shows the fault [s]
  /// @more For a missing measurement, this is the time at which the measurement was due
  double time = 0.0;
  /// Index in v of the joint with the fault; -1: the fault concerns no joint
  int joint = -1;
  /// Measured value that violates the limit
  /// @more The unit depends on the kind of fault: s, number of updates, N, m or m/s. If the fault
  /// concerns a joint, the unit is rad, rad/s or Nm (prismatic joint: m, m/s or N)
  double value = 0.0;
  /// Limit that `value` violates, in the unit of `value`
  double limit = 0.0;
  /// Subject of the fault: a monitored quantity, a support, or a part of the robot; empty if there
  /// is none
  /// @more With FaultKind::Watched, this is name and unit of the quantity. With
  /// FaultKind::SupportSlipped, this is the name of the support. A part of the robot is named as in
  /// "hand 'left'"
  std::string quantity = {};
  /// Name of the joint with the fault; empty: the fault concerns no joint
  std::string joint_name = {};
  /// Unit of `value` and `limit` if the fault concerns a joint; empty: the kind of fault determines
  /// the unit
  std::string unit = {};
  /// Probable cause of the fault, such as "the largest force was 1.4 N; 2 N count as contact";
  /// empty if unknown
  std::string cause = {};
  /// Record of all ticks in the last second before the fault, oldest first; empty without a fault
  Trace last_second;

  /// Returns the fault as one sentence, such as "speed limit at 3.2140 s: joint 'wrist_3': 3.9
  /// rad/s, allowed 3.6 rad/s". Allocates.
  std::string text() const;
};

}  // namespace burnish
