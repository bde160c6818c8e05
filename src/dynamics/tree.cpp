#include "burnish/dynamics/tree.hpp"

namespace burnish {
namespace {

// Relatives (ancestors, descendants, itself) of an entry on average. Measured on chains, where it
// is their length, with packs of 8 states.
constexpr double relatives_of_deep_trees = 22.0;

double mean_relatives(const std::vector<int>& parent_of_v) {
  double pairs = 0.0;  // of an entry and an ancestor, counted from both sides
  for (int k : parent_of_v)
    for (; k >= 0; k = parent_of_v[static_cast<std::size_t>(k)]) pairs += 2.0;
  return 1.0 + pairs / static_cast<double>(parent_of_v.size());
}

}  // namespace

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
  deep = nv > 0 && mean_relatives(parent_of_v) >= relatives_of_deep_trees;
}

std::vector<std::pair<int, int>> Tree::chains() const {
  std::vector<int> children(static_cast<std::size_t>(nv), 0);
  for (int k = 0; k < nv; ++k)
    if (parent_of_v[k] >= 0) ++children[parent_of_v[k]];
  std::vector<std::pair<int, int>> result;
  for (int k = 0; k < nv; ++k) {
    const bool goes_on =
        k > 0 && parent_of_v[k] == k - 1 && children[k - 1] == 1 && !result.empty();
    if (goes_on) {
      result.back().second = k + 1;
    } else {
      result.emplace_back(k, k + 1);
    }
  }
  return result;
}

}  // namespace burnish
