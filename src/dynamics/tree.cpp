#include "dynamics/tree.hpp"

#include <algorithm>
#include <cmath>

#include "base/to_size.hpp"

namespace burnish {
namespace {

// Smallest mean number of relatives of an entry of v at which the articulated-body solver is used.
// Relatives are ancestors, descendants and the entry itself; in a chain, their number is the length
// of the chain. The value was measured on chains, with packs of 8 states.
constexpr double relatives_of_deep_trees = 22.0;

double mean_relatives(const std::vector<int>& parent_of_v) {
  double pairs = 0.0;  // each pair of entry and ancestor counts twice
  for (int k : parent_of_v)
    for (; k >= 0; k = parent_of_v[to_size(k)]) pairs += 2.0;
  return 1.0 + pairs / static_cast<double>(parent_of_v.size());
}

/// Numbering of the axes of a model.
struct AxisNumbers {
  std::vector<int> first;       ///< First axis of each joint
  std::vector<int> up_to_root;  ///< Axis or sum of axes by which each joint moves its body
  std::vector<AxisSum> sums;
};

/// Returns the nearest ancestor of a joint that moves with the same entry of v, or -1.
int same_entry_above(const Model& model, const Joint& joint) {
  int above = joint.parent;
  while (above >= 0 && model.joints[to_size(above)].v_index != joint.v_index)
    above = model.joints[to_size(above)].parent;
  return above;
}

AxisNumbers number_axes(const Model& model) {
  AxisNumbers result;
  int count = 0;
  bool any_follower = false;
  for (const Joint& joint : model.joints) {
    result.first.push_back(count);
    count += joint_nv(joint.kind);
    any_follower = any_follower || joint.follows;
  }
  result.up_to_root = result.first;
  if (!any_follower) return result;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const int above = same_entry_above(model, model.joints[i]);
    if (above < 0) continue;
    result.up_to_root[i] = count + static_cast<int>(result.sums.size());
    result.sums.push_back({result.first[i], result.up_to_root[to_size(above)]});
  }
  return result;
}

TreeFollower follower_of(const Following& follows) {
  return {follows.multiplier, follows.offset, std::cos(follows.offset), std::sin(follows.offset)};
}

/// Returns the kind of a joint in the tree. A rotary follower uses the angle coordinates of its
/// leader.
JointKind kind_in_tree(const Model& model, const Joint& joint) {
  if (!joint.follows || joint.kind == JointKind::Prismatic) return joint.kind;
  const Joint& leader = model.joints[to_size(joint.follows->leader)];
  return leader.kind == JointKind::Continuous ? JointKind::Continuous : JointKind::Revolute;
}

}  // namespace

std::vector<MovingAxis> moving_axes(const Model& model, int body) {
  const AxisNumbers numbers = number_axes(model);
  std::vector<MovingAxis> result;
  for (; body >= 0; body = model.joints[to_size(body)].parent) {
    const Joint& joint = model.joints[to_size(body)];
    const auto same = [&](const MovingAxis& entry) { return entry.v == joint.v_index; };
    if (std::any_of(result.begin(), result.end(), same)) continue;
    for (int k = 0; k < joint_nv(joint.kind); ++k)
      result.push_back({joint.v_index + k, numbers.up_to_root[to_size(body)] + k});
  }
  std::sort(result.begin(), result.end(),
            [](const MovingAxis& a, const MovingAxis& b) { return a.v < b.v; });
  return result;
}

int moving_axis(const Tree& tree, int body, int v) {
  while (body >= 0) {
    const TreeJoint& joint = tree.joints[to_size(body)];
    if (joint.v <= v && v < joint.v + joint.nv) {
      for (std::size_t i = 0; i < tree.sums.size(); ++i)
        if (tree.sums[i].own == joint.axis) return tree.axes + static_cast<int>(i);
      return joint.axis + v - joint.v;
    }
    body = joint.parent;
  }
  return -1;
}

BodyInertia body_inertia(const InertiaSpec& inertia) {
  const Eigen::Matrix3d& I = inertia.inertia_at_com;
  return {inertia.mass,
          from_eigen(inertia.com),
          {I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2)}};
}

void set_body_inertia(Tree& tree, int body, const BodyInertia& inertia) {
  TreeJoint& joint = tree.joints[to_size(body)];
  joint.mass = inertia.mass;
  joint.com = inertia.com;
  joint.inertia = inertia.inertia;
}

LoadedBody loaded_body(std::string_view call, const Model& model, std::string_view frame,
                       const InertiaSpec& carried) {
  const Frame& at = frame_on_body(call, model, frame);
  return {check_inertia(carried), at.body,
          together(inertia_of_body(model, at.body), placed(carried, at.placement))};
}

Tree::Tree(const Model& model)
    : parent_of_v(model.parent_of_v),
      gravity(from_eigen(model.gravity)),
      nq(model.nq),
      nv(model.nv) {
  AxisNumbers numbers = number_axes(model);
  sums = std::move(numbers.sums);
  joints.reserve(model.joints.size());
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    const BodyInertia own = body_inertia({joint.mass, joint.com, joint.inertia_at_com});
    const int count = joint_nv(joint.kind);
    joints.push_back({kind_in_tree(model, joint), joint.parent, joint.q_index, joint.v_index, count,
                      numbers.first[i], joint.follows ? static_cast<int>(followers.size()) : -1,
                      from_eigen(Eigen::Matrix3d(joint.placement.linear())),
                      from_eigen(Eigen::Vector3d(joint.placement.translation())), own.mass, own.com,
                      own.inertia});
    if (joint.follows) followers.push_back(follower_of(*joint.follows));
    int previous = -1;
    if (joint.parent >= 0) {
      const TreeJoint& parent = joints[to_size(joint.parent)];
      previous = parent.axis + parent.nv - 1;
    }
    for (int k = 0; k < count; ++k) {
      parent_of_axis.push_back(previous);
      v_of_axis.push_back(joint.v_index + k);
      joint_of_axis.push_back(static_cast<int>(i));
      armature.push_back(joint.follows ? 0.0 : model.armature[joint.v_index + k]);
      previous = axes++;
    }
  }
  deep = nv > 0 && !shares_entries() && mean_relatives(parent_of_v) >= relatives_of_deep_trees;
}

std::vector<std::pair<int, int>> Tree::chains() const {
  std::vector<int> children(to_size(nv), 0);
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
