// What can go wrong in a control loop, and the record of it.
#pragma once

#include <string>
#include <string_view>

#include "burnish/base/trace.hpp"

namespace burnish {

enum class FaultKind {
  None,
  StaleMeasurement,   ///< time does not go on
  BadMeasurement,     ///< NaN, infinite or of the wrong size, for too long
  OutOfRange,         ///< a joint is beyond its position limit
  SolverFailed,       ///< no usable plan for too many updates
  SolverLate,         ///< too many updates in a row took longer than their deadline
  ContactLost,        ///< no force for too long while it is wanted
  UnexpectedContact,  ///< a force while none is wanted
  ForceLimit,         ///< the tool is pushed harder than allowed
  SpeedLimit,         ///< a joint or the tool is faster than allowed
};

/// Such as "contact lost".
std::string_view name_of(FaultKind kind);

/// The first fault of a run, and the ticks that led to it.
struct FaultReport {
  FaultKind kind = FaultKind::None;
  double time = 0.0;   ///< s, of the measurement
  int joint = -1;      ///< entry of v that it is about, or -1
  double value = 0.0;  ///< what was measured
  double limit = 0.0;  ///< what was allowed
  Trace last_second;   ///< oldest row first; empty while there is no fault

  /// One sentence, such as "contact lost at 3.214 s: 0.1 N for 0.1 s; wanted more than 1 N".
  /// Allocates.
  std::string text() const;
};

}  // namespace burnish
