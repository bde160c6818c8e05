// The first fault of a run.
#pragma once

#include "burnish/mpc/fault.hpp"

namespace burnish {

class FaultLatch {
 public:
  FaultReport report;

  bool is_set() const noexcept { return report.kind != FaultKind::None; }
  /// The fallback holds the robot: there was a fault, and plans do not go on without the task.
  bool holds() const noexcept { return is_set() && !goes_on_; }
  /// Plans go on for all that, until the next fault.
  void go_on() noexcept { goes_on_ = true; }
  void reset() noexcept {
    goes_on_ = false;
    report.kind = FaultKind::None;
    report.time = report.value = report.limit = 0.0;
    report.joint = -1;
    report.quantity.clear();
    report.last_second.clear();
  }
  /// At `time`, s. What follows the first one is not reported, and ends what goes on. False then.
  bool raise(double time, FaultKind kind, double value, double limit, int joint = -1) noexcept {
    if (is_set()) {
      goes_on_ = false;
      return false;
    }
    report.kind = kind;
    report.time = time;
    report.value = value;
    report.limit = limit;
    report.joint = joint;
    return true;
  }

 private:
  bool goes_on_ = false;
};

}  // namespace burnish
