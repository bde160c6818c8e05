#include "robots/grippers.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "base/words_in.hpp"

namespace burnish {
namespace {

/// Joints of an arm that at least carry a hand: fewer carry a head, legs or other arms.
constexpr int least_carrying = 2;
/// Joints in a row of a finger at most: thumbs of anthropomorphic hands have five.
constexpr int longest_finger = 5;
/// Length of a finger at most, as a share of the way from the root to the hand: arms beside each
/// other on a torso are longer.
constexpr double shortest_arm = 0.5;

bool moves(const JointSpec& joint) { return joint.type != JointType::Fixed; }

/// A moving joint among the others.
struct Node {
  const JointSpec* joint = nullptr;
  int parent = -1;            ///< node that carries it, -1: none
  int depth = 1;              ///< moving joints from the root to it, itself included
  int height = 1;             ///< joints in a row from it outwards, itself included
  double carried_length = 0;  ///< from the root to its link [m]
  double reach = 0;           ///< from the root to what is furthest on or beyond it [m]
  double mass = 0;            ///< that it moves up to the next joints [kg]
  std::vector<int> children = {};
};

/// A wrist may be named after the gripper that it turns.
bool is_named_finger(const JointSpec& joint) {
  const std::string name = lower_case(joint.name), link = lower_case(joint.child_link);
  if (has_one_of(name, {"roll", "rot", "wrist", "yaw", "pitch"})) return false;
  return has_one_of(name, {"finger", "jaw", "knuckle", "thumb", "gripper"}) ||
         has_one_of(link, {"finger", "jaw", "knuckle", "thumb"});
}

/// The moving joints of a description, each with those that it carries.
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
      Node& parent = nodes_[static_cast<std::size_t>(node.parent)];
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
      if (node.children.empty() && node.depth > least_carrying && is_named_finger(*node.joint))
        names.insert(node.joint->name);
    // What follows a joint of the arm moves with it and cannot be held.
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
    int carrier;    ///< node that moves it, -1: none
    double length;  ///< from the root [m]
  };

  /// Each link once, after those that carry it: descriptions with loops are refused elsewhere.
  void descend(const std::string& root) {
    std::vector<Link> open{{root, -1, 0.0}};
    while (!open.empty()) {
      const Link link = std::move(open.back());
      open.pop_back();
      if (!seen_.insert(link.name).second) continue;
      if (link.carrier >= 0) {
        Node& node = nodes_[static_cast<std::size_t>(link.carrier)];
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
      Node& parent = nodes_[static_cast<std::size_t>(carrier)];
      node.depth = parent.depth + 1;
      parent.children.push_back(index);
    }
    nodes_.push_back(std::move(node));
    return index;
  }

  /// The rotor of a motor beside the link that it drives: by its name, or without mass beside a
  /// branch that has some.
  bool is_rotor(int child, const Node& carrier) const {
    const Node& node = nodes_[static_cast<std::size_t>(child)];
    if (!node.children.empty()) return false;
    if (has_one_of(node.joint->child_link, {"rotor"})) return true;
    return node.mass == 0.0 &&
           std::any_of(carrier.children.begin(), carrier.children.end(), [&](int other) {
             return nodes_[static_cast<std::size_t>(other)].mass > 0.0;
           });
  }

  bool is_hand(const Node& node) const {
    const auto branches = std::count_if(node.children.begin(), node.children.end(),
                                        [&](int child) { return !is_rotor(child, node); });
    if (node.depth < least_carrying || branches < 2) return false;
    return std::all_of(node.children.begin(), node.children.end(), [&](int child) {
      const Node& finger = nodes_[static_cast<std::size_t>(child)];
      return finger.height <= longest_finger &&
             finger.reach - node.carried_length <= shortest_arm * node.carried_length;
    });
  }

  void add(int branch, std::set<std::string>& names) const {
    const Node& node = nodes_[static_cast<std::size_t>(branch)];
    names.insert(node.joint->name);
    for (const int child : node.children) add(child, names);
  }

  std::map<std::string, std::vector<const JointSpec*>> by_parent_;
  std::map<std::string, double> masses_;  ///< of links [kg]
  std::set<std::string> seen_;
  std::vector<Node> nodes_;  ///< each behind the one that carries it
};

}  // namespace

std::set<std::string> finger_joints(const TreeSpec& tree) { return Branches(tree).fingers(); }

}  // namespace burnish
