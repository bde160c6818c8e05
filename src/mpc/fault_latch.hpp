// The first fault of a run.
#pragma once

#include "burnish/mpc/fault.hpp"

namespace burnish {

class FaultLatch {
 public:
  FaultReport report;

  bool is_set() const noexcept { return report.kind != FaultKind::None; }
  void reset() noexcept {
    report.kind = FaultKind::None;
    report.time = report.value = report.limit = 0.0;
    report.joint = -1;
    report.quantity.clear();
    report.last_second.clear();
  }
  /// At `time`, s. What follows the first one is not heard. False then.
  bool raise(double time, FaultKind kind, double value, double limit, int joint = -1) noexcept {
    if (is_set()) return false;
    report.kind = kind;
    report.time = time;
    report.value = value;
    report.limit = limit;
    report.joint = joint;
    return true;
  }
};

}  // namespace burnish
