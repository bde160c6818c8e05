// The first fault of a run.
#pragma once

#include <vector>

#include "burnish/model/model.hpp"
#include "burnish/mpc/fault.hpp"

namespace burnish {

class FaultLatch {
 public:
  FaultReport report;

  FaultLatch() = default;
  /// Reports name the joints of this model.
  explicit FaultLatch(const Model& model);
  /// Quantities have names of at most `longest` characters.
  void make_room(std::size_t longest) { report.quantity.reserve(longest); }

  bool is_set() const noexcept { return report.kind != FaultKind::None; }
  void reset() noexcept {
    report.kind = FaultKind::None;
    report.time = report.value = report.limit = 0.0;
    report.joint = -1;
    report.quantity.clear();
    report.joint_name.clear();
    report.unit.clear();
    report.cause.clear();
    report.last_second.clear();
  }
  /// At `time`, s. What follows the first one is not heard. False then. `joint`: entry of v.
  bool raise(double time, FaultKind kind, double value, double limit, int joint = -1) noexcept;
  /// Adds a clause to the cause of the fault; an empty one adds nothing. What there is no room for
  /// is left out.
  void explain(const char* clause) noexcept;
  /// Name of an entry of v; empty where no model was given.
  const char* name_of_entry(int entry) const noexcept {
    return entries_.empty() ? "" : entries_[static_cast<std::size_t>(entry)].name.c_str();
  }

 private:
  /// An entry of v, and the units of its position, speed and torque.
  struct Entry {
    std::string name;
    const char *position, *speed, *torque;
  };
  std::vector<Entry> entries_;
};

}  // namespace burnish
