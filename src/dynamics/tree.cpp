#include "burnish/dynamics/tree.hpp"

namespace burnish {

Tree::Tree(const Model& model)
    : parent_of_v(model.parent_of_v),
      joint_of_v(model.joint_of_v),
      armature(model.armature.data(), model.armature.data() + model.armature.size()),
      gravity(from_eigen(model.gravity)),
      nq(model.nq),
      nv(model.nv) {
  joints.reserve(model.joints.size());
  for (const Joint& joint : model.joints) {
    const Eigen::Matrix3d& I = joint.inertia_at_com;
    joints.push_back({joint.kind,
                      joint.parent,
                      joint.q_index,
                      joint.v_index,
                      joint.nv,
                      from_eigen(Eigen::Matrix3d(joint.placement.linear())),
                      from_eigen(Eigen::Vector3d(joint.placement.translation())),
                      joint.mass,
                      from_eigen(joint.com),
                      {I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2)}});
  }
}

}  // namespace burnish
