#include "robots/grippers.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/to_size.hpp"
#include "base/words_in.hpp"

namespace burnish {
namespace {

/// Smallest number of joints that carry a hand. A branching link behind fewer joints is a torso.
constexpr int min_carrying = 2;
/// Largest number of joints of a finger in series: thumbs of anthropomorphic hands have five.
constexpr int max_finger_joints = 5;
/// Largest length of a finger, as a fraction of the path length from the root to the hand. Arms on
/// a torso are longer. Chosen by hand.
constexpr double max_finger_ratio = 0.5;

bool moves(const JointSpec& joint) { return joint.type != JointType::Fixed; }

/// Moving joint in the tree of moving joints.
struct Node {
  const JointSpec* joint = nullptr;
  int parent = -1;            ///< Node that carries this joint, -1 if none
  int depth = 1;              ///< Number of moving joints from the root to this joint, inclusive
  int height = 1;             ///< Largest number of moving joints from this one to a tip, inclusive
  double carried_length = 0;  ///< Path length from the root to the joint's link [m]
  double reach = 0;           ///< Largest path length from the root to a carried link [m]
  double mass = 0;            ///< Mass between this joint and the next moving joints [kg]
  std::vector<int> children = {};
};

/// Returns true if the name of the joint or of its link suggests a finger. Excludes wrists, which
/// may be named after the gripper that they turn.
bool is_named_finger(const JointSpec& joint) {
  const std::string name = lower_case(joint.name), link = lower_case(joint.child_link);
  if (has_one_of(name, {"roll", "rot", "wrist", "yaw", "pitch"})) return false;
  return has_one_of(name, {"finger", "jaw", "knuckle", "thumb", "gripper"}) ||
         has_one_of(link, {"finger", "jaw", "knuckle", "thumb"});
}

/// Tree of the moving joints of a description.
class Branches {
 public:
  explicit Branches(const TreeSpec& tree) {
    for (const JointSpec& joint : tree.joints) by_parent_[joint.parent_link].push_back(&joint);
    for (const LinkSpec& link : tree.links) masses_[link.name] = link.inertia.mass;
    std::set<std::string> children;
    for (const JointSpec& joint : tree.joints) children.insert(joint.child_link);
    for (const LinkSpec& link : tree.links)
      if (!children.contains(link.name)) descend(link.name);
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      const Node& node = nodes_[i];
      if (node.parent < 0) continue;
      Node& parent = nodes_[to_size(node.parent)];
      parent.height = std::max(parent.height, node.height + 1);
      parent.reach = std::max(parent.reach, node.reach);
    }
  }

  std::set<std::string> fingers() const {
    std::set<std::string> names;
    for (const Node& hand : nodes_)
      if (is_hand(hand))
        for (const int branch : hand.children) add(branch, names);
    for (const Node& node : nodes_)
      if (node.children.empty() && node.depth > min_carrying && is_named_finger(*node.joint))
        names.insert(node.joint->name);
    // A mimic joint whose leader is an arm joint moves with the arm, so it is not a finger.
    std::erase_if(names, [&, all = names](const std::string& name) {
      const auto node = std::find_if(nodes_.begin(), nodes_.end(),
                                     [&](const Node& of) { return of.joint->name == name; });
      return node->joint->mimic && !all.contains(node->joint->mimic->leader);
    });
    return names;
  }

 private:
  struct Link {
    std::string name;
    int carrier;    ///< Node that moves the link, -1 if none
    double length;  ///< Path length from the root [m]
  };

  /// Visits each link below `root` once, after the links that carry it. Visiting once ends cycles,
  /// which build_model() rejects.
  void descend(const std::string& root) {
    std::vector<Link> open{{root, -1, 0.0}};
    while (!open.empty()) {
      const Link link = std::move(open.back());
      open.pop_back();
      if (!seen_.insert(link.name).second) continue;
      if (link.carrier >= 0) {
        Node& node = nodes_[to_size(link.carrier)];
        node.reach = std::max(node.reach, link.length);
        node.mass += masses_[link.name];
      }
      const auto joints = by_parent_.find(link.name);
      if (joints == by_parent_.end()) continue;
      for (const JointSpec* joint : joints->second) {
        const double length = link.length + joint->placement.translation().norm();
        open.push_back({joint->child_link,
                        moves(*joint) ? add_node(*joint, link.carrier, length) : link.carrier,
                        length});
      }
    }
  }

  int add_node(const JointSpec& joint, int carrier, double length) {
    const int index = static_cast<int>(nodes_.size());
    Node node{.joint = &joint, .parent = carrier, .carried_length = length, .reach = length};
    if (carrier >= 0) {
      Node& parent = nodes_[to_size(carrier)];
      node.depth = parent.depth + 1;
      parent.children.push_back(index);
    }
    nodes_.push_back(std::move(node));
    return index;
  }

  /// Returns true if a tip represents the rotor of a motor: its name contains "rotor", or it has no
  /// mass and a branch beside it has mass.
  bool is_rotor(int child, const Node& carrier) const {
    const Node& node = nodes_[to_size(child)];
    if (!node.children.empty()) return false;
    if (has_one_of(node.joint->child_link, {"rotor"})) return true;
    return node.mass == 0.0 &&
           std::any_of(carrier.children.begin(), carrier.children.end(),
                       [&](int other) { return nodes_[to_size(other)].mass > 0.0; });
  }

  bool is_hand(const Node& node) const {
    const auto branches = std::count_if(node.children.begin(), node.children.end(),
                                        [&](int child) { return !is_rotor(child, node); });
    if (node.depth < min_carrying || branches < 2) return false;
    return std::all_of(node.children.begin(), node.children.end(), [&](int child) {
      const Node& finger = nodes_[to_size(child)];
      return finger.height <= max_finger_joints &&
             finger.reach - node.carried_length <= max_finger_ratio * node.carried_length;
    });
  }

  void add(int branch, std::set<std::string>& names) const {
    const Node& node = nodes_[to_size(branch)];
    names.insert(node.joint->name);
    for (const int child : node.children) add(child, names);
  }

  std::map<std::string, std::vector<const JointSpec*>> by_parent_;
  std::map<std::string, double> masses_;  ///< Masses of links [kg]
  std::set<std::string> seen_;
  std::vector<Node> nodes_;  ///< Parents before children
};

}  // namespace

std::set<std::string> finger_joints(const TreeSpec& tree) { return Branches(tree).fingers(); }

}  // namespace burnish
