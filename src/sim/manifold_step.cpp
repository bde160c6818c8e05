#include "sim/manifold_step.hpp"

namespace burnish {
namespace {

/// A planar or floating joint's entries as a twist.
Vector6 twist_of(JointKind kind, const double* x) {
  Vector6 result = Vector6::Zero();
  if (kind == JointKind::Planar)
    result << x[0], x[1], 0.0, 0.0, 0.0, x[2];
  else
    result = Eigen::Map<const Vector6>(x);
  return result;
}

/// The bracket of two twists, linear part first.
Vector6 bracket(const Vector6& a, const Vector6& b) {
  const Eigen::Vector3d a_linear = a.head<3>(), a_angular = a.tail<3>();
  const Eigen::Vector3d b_linear = b.head<3>(), b_angular = b.tail<3>();
  Vector6 result;
  result << a_angular.cross(b_linear) + a_linear.cross(b_angular), a_angular.cross(b_angular);
  return result;
}

}  // namespace

void increment_rate(const Model& model, const ConstVectorRef& u, const ConstVectorRef& v,
                    Eigen::VectorXd& out) noexcept {
  out = v;
  for (const Joint& joint : model.joints) {
    if (joint.nv <= 1) continue;
    const int first = joint.v_index;
    const Vector6 increment = twist_of(joint.kind, u.data() + first);
    const Vector6 once = bracket(increment, twist_of(joint.kind, v.data() + first));
    const Vector6 added = 0.5 * once + bracket(increment, once) / 12.0;
    if (joint.kind == JointKind::Planar) {
      out[first] += added[0], out[first + 1] += added[1], out[first + 2] += added[5];
    } else {
      out.segment<6>(first) += added;
    }
  }
}

}  // namespace burnish
