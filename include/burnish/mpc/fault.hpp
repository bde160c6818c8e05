// What can go wrong in a control loop, and the record of it.
#pragma once

#include <string>
#include <string_view>

#include "burnish/base/trace.hpp"

namespace burnish {

/// What can go wrong in a control loop.
/// @described mpc
enum class FaultKind {
  None,
  StaleMeasurement,   ///< time does not go on
  BadMeasurement,     ///< NaN, infinite or of the wrong size, for too long
  OutOfRange,         ///< a joint is beyond its position limit
  SolverFailed,       ///< no usable plan for too many updates in a row, or at the first
  SolverLate,         ///< too many updates in a row took longer than their deadline
  ContactLost,        ///< no force for too long while it is wanted
  NoContact,          ///< the tool went on too far where the surface was expected
  ContactLate,        ///< the tool took too long to get to the surface
  UnexpectedContact,  ///< a force while the tool moves through free space
  ForceLimit,         ///< the tool is pushed harder than allowed
  SpeedLimit,         ///< a joint or the tool is faster than allowed
  SupportSlipped,     ///< what the robot stands on came away too far
  MotorLost,          ///< a joint's torque is not what was sent
  Watched,            ///< a quantity of the task, FaultReport.quantity, is beyond its limit
  BaseLost,           ///< nothing tells where a floating base is, for too long
};

/// Such as "contact lost".
std::string_view name_of(FaultKind kind);

/// The first fault of a run, and the ticks that led to it.
/// @described mpc
struct FaultReport {
  FaultKind kind = FaultKind::None;
  double time = 0.0;  ///< [s], of the measurement, or when it was due if there was none
  int joint = -1;     ///< entry of v that it is about, or -1
  /// What was measured: s, updates, N, m, m/s, or of a joint rad (m), rad/s and Nm (N).
  double value = 0.0;
  double limit = 0.0;  ///< what was allowed, in the same unit
  /// of FaultKind::Watched: its name and unit; of SupportSlipped: the support; else the part that
  /// it is about, such as "hand 'left'"; or empty
  std::string quantity = {};
  std::string joint_name = {};  ///< of that entry of v; empty: none
  std::string unit = {};        ///< of value and limit of a joint; empty: the kind has one
  /// What led to it, as far as measurements tell: clauses, such as "the force came to 1.4 N at
  /// most; 2 N count as contact"; or empty.
  std::string cause = {};
  Trace last_second;  ///< oldest row first, the fault's tick last; empty while there is no fault

  /// One sentence, such as "speed limit at 3.2140 s: joint 'wrist_3': 3.9 rad/s, allowed 3.6
  /// rad/s". Allocates.
  std::string text() const;
};

}  // namespace burnish
