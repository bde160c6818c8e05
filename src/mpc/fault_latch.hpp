// Storage of the first fault of a run. Later faults are ignored.
#pragma once

#include <vector>

#include "base/to_size.hpp"
#include "burnish/model/model.hpp"
#include "burnish/mpc/fault.hpp"

namespace burnish {

class FaultLatch {
 public:
  FaultReport report;

  FaultLatch() = default;
  /// Creates a latch whose reports name the joints of `model`.
  explicit FaultLatch(const Model& model);
  /// Reserves memory for names of quantities with at most `max_length` characters.
  void make_room(std::size_t max_length) { report.quantity.reserve(max_length); }

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
  /// Stores a fault at the time `time` [s] and returns true. Returns false if an earlier fault is
  /// stored. `joint`: index in v; -1: no joint.
  bool raise(double time, FaultKind kind, double value, double limit, int joint = -1) noexcept;
  /// Appends a clause to the cause of the fault. Empty clauses, and clauses that exceed the
  /// reserved memory, are ignored.
  void explain(const char* clause) noexcept;
  /// Returns the name of the joint to which an entry of v belongs; empty if the latch has no model.
  const char* name_of_entry(int entry) const noexcept {
    return entries_.empty() ? "" : entries_[to_size(entry)].name.c_str();
  }

 private:
  /// Name of an entry of v, with the units of position, speed and torque.
  struct Entry {
    std::string name;
    const char *position, *speed, *torque;
  };
  std::vector<Entry> entries_;
};

}  // namespace burnish
