#include "mpc/fault_latch.hpp"

#include <algorithm>
#include <cstring>

#include "base/to_size.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {
constexpr std::size_t room_for_cause = 320;  // memory for the cause of a fault [characters]
}

FaultLatch::FaultLatch(const Model& model) {
  std::size_t max_length = 0;
  for (const Joint& joint : model.joints)
    for (int i = 0; i < joint.nv; ++i) {
      const bool slides = i < sliding_entries(joint.kind);
      entries_.push_back({model.v_name(joint.v_index + i), slides ? "m" : "rad",
                          slides ? "m/s" : "rad/s", slides ? "N" : "Nm"});
      max_length = std::max(max_length, entries_.back().name.size());
    }
  // Reserves memory, because raise() and explain() must not allocate.
  report.joint_name.reserve(max_length);
  report.cause.reserve(room_for_cause);
}

bool FaultLatch::raise(double time, FaultKind kind, double value, double limit,
                       int joint) noexcept {
  if (is_set()) return false;
  report.kind = kind;
  report.time = time;
  report.value = value;
  report.limit = limit;
  report.joint = joint;
  if (joint < 0 || entries_.empty()) return true;
  const Entry& entry = entries_[to_size(joint)];
  report.joint_name = entry.name;
  report.unit = kind == FaultKind::SpeedLimit  ? entry.speed
                : kind == FaultKind::MotorLost ? entry.torque
                                               : entry.position;
  return true;
}

void FaultLatch::explain(const char* clause) noexcept {
  const std::size_t length = std::strlen(clause);
  const std::size_t used = report.cause.size();
  if (length == 0 || used + length + 2 > report.cause.capacity()) return;
  if (used > 0) report.cause += "; ";
  report.cause += clause;
}

}  // namespace burnish
