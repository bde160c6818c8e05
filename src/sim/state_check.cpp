#include "sim/state_check.hpp"

#include <cmath>

#include "model/joint_entries.hpp"

namespace burnish {
namespace {

// Tolerance of the squared norm of unit entries of q; equal to the tolerance of contact kernels.
constexpr double tolerance = 2e-6;

bool is_unit(const ConstVectorRef& q, int first, int size) {
  return std::abs(q.segment(first, size).squaredNorm() - 1.0) < tolerance;
}

}  // namespace

Status check_state(const Model& model, const ConstVectorRef& q, const ConstVectorRef& v) noexcept {
  if (q.size() != model.nq || v.size() != model.nv) return Status::WrongSize;
  if (!q.allFinite() || !v.allFinite()) return Status::NotFinite;
  for (const Joint& joint : model.joints) {
    if (joint.follows) continue;
    const int size = unit_entries(joint.kind);
    if (size > 0 && !is_unit(q, joint.q_index + joint.nq - size, size))
      return Status::NotNormalized;
  }
  return Status::Ok;
}

}  // namespace burnish
