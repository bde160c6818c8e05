#include "model/moving_links.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string_view>

#include "base/to_size.hpp"

namespace burnish {
namespace {

double half_size(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return 0.5 * box->size.norm();
  if (const auto* tube = std::get_if<CylinderShape>(&shape))
    return std::hypot(tube->radius, 0.5 * tube->length);
  if (const auto* ball = std::get_if<SphereShape>(&shape)) return ball->radius;
  return 0.0;  // mesh files are not read
}

double volume_of(const Shape& shape) {
  if (const auto* box = std::get_if<BoxShape>(&shape)) return box->size.prod();
  if (const auto* tube = std::get_if<CylinderShape>(&shape))
    return std::numbers::pi * tube->radius * tube->radius * tube->length;
  if (const auto* ball = std::get_if<SphereShape>(&shape))
    return 4.0 / 3.0 * std::numbers::pi * std::pow(ball->radius, 3);
  return 0.0;
}

double volume_of(const LinkSpec& link) {
  double sum = 0.0;
  for (const VisualSpec& visual : link.visuals) sum += volume_of(visual.shape);
  return sum;
}

double extent_of(const LinkSpec& link) {
  double extent = 0.0;
  for (const VisualSpec& visual : link.visuals)
    extent = std::max(extent, visual.placement.translation().norm() + half_size(visual.shape));
  return extent;
}

/// Walk over the tree that collects the moving links.
class LinkWalk {
 public:
  explicit LinkWalk(const TreeSpec& tree) {
    for (const LinkSpec& link : tree.links) link_by_name_.emplace(link.name, &link);
    for (const JointSpec& joint : tree.joints) below_[joint.parent_link].push_back(&joint);
  }

  MovingLinks walk(const LinkSpec& root, bool floats) {
    if (floats) joints_.push_back(1);
    std::vector<Pending> stack{{&root, nullptr, floats ? 0 : -1, -1, 0.0}};
    while (!stack.empty()) {
      const Pending next = stack.back();
      stack.pop_back();
      const int at = next.subtree < 0 ? -1 : add(next);
      for (const JointSpec* joint : below_[next.link->name])
        stack.push_back(child(next, *joint, at));
    }
    for (const int joints : joints_)
      all_.joints_in_a_subtree = std::max(all_.joints_in_a_subtree, joints);
    return std::move(all_);
  }

 private:
  struct Pending {
    const LinkSpec* link;
    const JointSpec* joint;
    int subtree;  ///< Index of the subtree that moves in the world, -1 if fixed to the world
    int parent;   ///< Index of the parent among the moving links, -1 if none
    double path;  ///< Path length from the first joint that moves the link [m]
  };

  Pending child(const Pending& above, const JointSpec& joint, int parent) {
    const LinkSpec* link = link_by_name_.at(joint.child_link);
    const bool moves = joint.type != JointType::Fixed;
    if (above.subtree >= 0) {
      joints_[to_size(above.subtree)] += moves ? 1 : 0;
      return {link, &joint, above.subtree, parent,
              above.path + joint.placement.translation().norm()};
    }
    if (!moves) return {link, &joint, -1, -1, 0.0};
    joints_.push_back(1);
    return {link, &joint, static_cast<int>(joints_.size()) - 1, -1, 0.0};
  }

  int add(const Pending& next) {
    const auto index = static_cast<int>(all_.links.size());
    const double mass = next.link->inertia.mass;
    all_.links.push_back(
        {next.link, next.joint, next.path, extent_of(*next.link), volume_of(*next.link), 0.0});
    parents_.push_back(next.parent);
    all_.mass += mass;
    all_.skeleton = std::max(all_.skeleton, next.path + all_.links.back().extent);
    for (int up = index; up >= 0; up = parents_[to_size(up)])
      all_.links[to_size(up)].mass_beyond += mass;
    return index;
  }

  std::map<std::string_view, const LinkSpec*> link_by_name_;
  std::map<std::string_view, std::vector<const JointSpec*>> below_;
  std::vector<int> parents_, joints_;
  MovingLinks all_;
};

const LinkSpec& root_link(const TreeSpec& tree) {
  std::set<std::string_view> children;
  for (const JointSpec& joint : tree.joints) children.insert(joint.child_link);
  return *std::find_if(tree.links.begin(), tree.links.end(),
                       [&](const LinkSpec& link) { return !children.contains(link.name); });
}

}  // namespace

bool MovingLinks::is_far_off(const MovingLink& link) const {
  // Distance that counts as far off, relative to `skeleton`; chosen by hand. The factor leaves
  // room for links without a shape, whose size does not count in `skeleton`.
  constexpr double far = 5.0;
  return link.link->inertia.mass > 0.0 && skeleton > 0.0 && joints_in_a_subtree > 1 &&
         link.link->inertia.com.norm() > far * skeleton;
}

MovingLinks moving_links(const TreeSpec& tree, const ModelOptions& options) {
  MovingLinks moving = LinkWalk(tree).walk(root_link(tree), options.base == Base::FreeFlyer);
  moving.reach = moving.skeleton;
  for (const MovingLink& link : moving.links)
    if (link.link->inertia.mass > 0.0 && !moving.is_far_off(link))
      moving.reach = std::max(moving.reach, link.path + link.link->inertia.com.norm());
  return moving;
}

}  // namespace burnish
