// Path lengths along the tree between joint axes and the tool, computed from the joint placements.
// They are upper bounds of the lever arms at all postures, unless sliding joints travel far.
#include "contact/row_size.hpp"

#include <algorithm>
#include <cmath>

#include "model/followers.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

/// Assumed largest travel of a sliding joint, chosen by hand [m].
constexpr double usual_travel = 1.0;

/// Returns the length that the motion of a joint adds to the path through it [m].
double travel(const Model& model, const Joint& joint) {
  switch (joint.kind) {
    case JointKind::Revolute:
    case JointKind::Continuous:
    case JointKind::Ball:
      return 0.0;
    case JointKind::Prismatic: {
      const auto [lower, upper] = position_range(model, joint);
      return std::min(usual_travel, std::max(std::abs(lower), std::abs(upper)));
    }
    case JointKind::Planar:
    case JointKind::FreeFlyer:
      break;
  }
  return usual_travel;
}

/// Returns the path length from the axis of joint `from` to a point of `body` [m]. `body` is the
/// body of the joint or a descendant. `offset` is the distance of the point from the body's origin.
double path_length(const Model& model, int from, int body, double offset) {
  double length = offset;
  for (int j = body; j != from; j = model.joints[j].parent)
    length += model.joints[j].placement.translation().norm() + travel(model, model.joints[j]);
  return length;
}

/// Joint through which an entry of v moves a body. An entry with followers has several joints.
struct Lever {
  double multiplier;  ///< Absolute value of the follower's multiplier, 1 for the leader
  double arm;         ///< Path length from the joint's axis to the point of the body [m]
  bool turns;         ///< Whether the entry is a rotation
};

std::vector<Lever> levers(const Model& model, int v, int body, double offset) {
  std::vector<Lever> result;
  for (int j = body; j >= 0; j = model.joints[j].parent) {
    const Joint& joint = model.joints[j];
    const int entry = v - joint.v_index;
    if (entry < 0 || entry >= std::max(joint.nv, 1)) continue;
    const double multiplier = joint.follows ? std::abs(joint.follows->multiplier) : 1.0;
    result.push_back(
        {multiplier, path_length(model, j, body, offset), entry >= sliding_entries(joint.kind)});
  }
  return result;
}

}  // namespace

double robot_size(const Model& model) {
  std::vector<double> from_first(model.joints.size(), 0.0);
  double longest_path = 0.0;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.parent >= 0)
      from_first[i] = from_first[joint.parent] + joint.placement.translation().norm();
    longest_path = std::max(longest_path, from_first[i] + joint.com.norm());
  }
  return longest_path;
}

void set_reaches(const Model& model, CompiledContact& contact) {
  const auto length = [](const Vec3<double>& p) { return std::sqrt(dot(p, p)); };
  const double tool_offset = length(contact.tool_p), base_offset = length(contact.base_p);
  std::vector<std::vector<Lever>> reach;
  double longest_arm = robot_size(model);
  for (const ContactSupport& entry : contact.support) {
    reach.push_back(entry.moves_tool() ? levers(model, entry.v, contact.tool_body, tool_offset)
                                       : levers(model, entry.v, contact.base_body, base_offset));
    for (const Lever& lever : reach.back()) longest_arm = std::max(longest_arm, lever.arm);
  }
  if (!(longest_arm > 0.0)) longest_arm = usual_travel;
  // Lower bound of lever arms. Rounding in a robot description can produce an arm of 1e-17 m.
  const double shortest_arm = 0.01 * longest_arm;
  const bool elsewhere = !contact.reference.at_tool;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    double distance = 0.0;  // largest motion of the point per unit of the entry [m]
    for (const Lever& lever : reach[i]) {
      const double arm = elsewhere ? longest_arm : std::max(lever.arm, shortest_arm);
      distance += lever.multiplier * (lever.turns ? arm : 1.0);
    }
    contact.support[i].per_reach = distance > 0.0 ? 1.0 / distance : 1.0;
  }
  // If the reference's origin is not at the tool, lever arms grow with the distance between origin
  // and tool. If the origin is at the tool, only rounding errors grow, with the distance between
  // tool and world's origin.
  const double per_distance = elsewhere ? 1.0 / longest_arm : 1e-8 / shortest_arm;
  contact.offset_weight = per_distance * per_distance;
}

}  // namespace burnish
