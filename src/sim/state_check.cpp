#include "sim/state_check.hpp"

#include <cmath>

namespace burnish {
namespace {

constexpr double tolerance = 2e-6;  // on squared lengths, as in the contact kernels

bool is_unit(const ConstVectorRef& q, int first, int size) {
  return std::abs(q.segment(first, size).squaredNorm() - 1.0) < tolerance;
}

}  // namespace

Status check_state(const Model& model, const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  if (q.size() != model.nq || v.size() != model.nv) return Status::WrongSize;
  if (!q.allFinite() || !v.allFinite()) return Status::NotFinite;
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    const bool quaternion = joint.kind == JointKind::FreeFlyer;
    const bool angle = joint.kind == JointKind::Continuous || joint.kind == JointKind::Planar;
    if (!quaternion && !angle) continue;
    const int size = quaternion ? 4 : 2;
    if (!is_unit(q, joint.q_index + joint.nq - size, size)) return Status::NotNormalized;
  }
  return Status::Ok;
}

}  // namespace burnish
