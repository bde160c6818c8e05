// Lengths of the robot, from the placements of its joints: how far an entry of v is from the tool
// by the way through the tree, which no posture exceeds but by what sliding joints add.
#include "contact/row_size.hpp"

#include <algorithm>
#include <cmath>

#include "model/followers.hpp"
#include "model/joint_entries.hpp"

namespace burnish {
namespace {

constexpr double usual_travel = 1.0;  // m, where a joint states none or a huge one

/// What a joint adds to the way through it.
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

/// From the axis of joint `from` to a point of a body that it carries, itself or further out; m.
double way(const Model& model, int from, int body, double offset) {
  double length = offset;
  for (int j = body; j != from; j = model.joints[j].parent)
    length += model.joints[j].placement.translation().norm() + travel(model, model.joints[j]);
  return length;
}

/// A joint by which an entry of v moves a body: several where others follow it.
struct Lever {
  double multiplier;  ///< absolute
  double arm;         ///< m, from its axis to the body's point
  bool turns;
};

std::vector<Lever> levers(const Model& model, int v, int body, double offset) {
  std::vector<Lever> result;
  for (int j = body; j >= 0; j = model.joints[j].parent) {
    const Joint& joint = model.joints[j];
    const int entry = v - joint.v_index;
    if (entry < 0 || entry >= std::max(joint.nv, 1)) continue;
    const double multiplier = joint.follows ? std::abs(joint.follows->multiplier) : 1.0;
    result.push_back(
        {multiplier, way(model, j, body, offset), entry >= sliding_entries(joint.kind)});
  }
  return result;
}

}  // namespace

double robot_size(const Model& model) {
  std::vector<double> from_first(model.joints.size(), 0.0);
  double longest = 0.0;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (joint.parent >= 0)
      from_first[i] = from_first[joint.parent] + joint.placement.translation().norm();
    longest = std::max(longest, from_first[i] + joint.com.norm());
  }
  return longest;
}

void set_reaches(const Model& model, CompiledContact& contact) {
  const auto length = [](const Vec3<double>& p) { return std::sqrt(dot(p, p)); };
  const double tool_offset = length(contact.tool_p), base_offset = length(contact.base_p);
  std::vector<std::vector<Lever>> reach;
  double longest = robot_size(model);
  for (const ContactSupport& entry : contact.support) {
    reach.push_back(entry.moves_tool() ? levers(model, entry.v, contact.tool_body, tool_offset)
                                       : levers(model, entry.v, contact.base_body, base_offset));
    for (const Lever& lever : reach.back()) longest = std::max(longest, lever.arm);
  }
  if (!(longest > 0.0)) longest = usual_travel;
  // A lever that a drawing made 1e-17 m long is none.
  const double shortest = 0.01 * longest;
  const bool elsewhere = !contact.reference.at_tool;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    double could = 0.0;  // m per unit of the entry
    for (const Lever& lever : reach[i]) {
      const double arm = elsewhere ? longest : std::max(lever.arm, shortest);
      could += lever.multiplier * (lever.turns ? arm : 1.0);
    }
    contact.support[i].per_reach = could > 0.0 ? 1.0 / could : 1.0;
  }
  // Levers about another origin grow with the distance from it; others gain rounding alone.
  const double per_distance = elsewhere ? 1.0 / longest : 1e-8 / shortest;
  contact.offset_weight = per_distance * per_distance;
}

}  // namespace burnish
