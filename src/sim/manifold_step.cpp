#include "sim/manifold_step.hpp"

#include "dynamics/joint_twist.hpp"

namespace burnish {

void increment_rate(const Model& model, const ConstVectorRef& u, const ConstVectorRef& v,
                    Eigen::VectorXd& out) noexcept {
  out = v;
  for (const Joint& joint : model.joints) {
    if (joint.nv <= 1) continue;
    const Motion<double> increment = load_twist(joint.kind, u.data() + joint.v_index);
    const Motion<double> twist = load_twist(joint.kind, v.data() + joint.v_index);
    const Motion<double> once = cross(increment, twist);
    store_twist(joint.kind, twist + once * 0.5 + cross(increment, once) * (1.0 / 12.0),
                out.data() + joint.v_index);
  }
}

}  // namespace burnish
