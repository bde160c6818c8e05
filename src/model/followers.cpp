#include "model/followers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <unordered_map>

#include "base/sentence.hpp"
#include "base/to_size.hpp"

namespace burnish {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Range of a leader's position in which a follower is within its limits. Empty if lower > upper.
struct LeaderRange {
  double lower = -no_limit, upper = no_limit;
};
LeaderRange range_of_leader(const JointSpec& spec, const Following& follows) {
  if (follows.multiplier == 0.0) {
    const bool within = spec.lower <= follows.offset && follows.offset <= spec.upper;
    return within ? LeaderRange{} : LeaderRange{no_limit, -no_limit};
  }
  const double a = (spec.lower - follows.offset) / follows.multiplier;
  const double b = (spec.upper - follows.offset) / follows.multiplier;
  return {std::min(a, b), std::max(a, b)};
}

/// Adds a follower's effort limit to its leader's limit. An infinite limit means that none is
/// stated, and adds nothing.
void add_effort(double of_follower, double factor, double& limit) {
  if (std::isfinite(of_follower)) limit += factor * of_follower;
}

}  // namespace

void couple_followers(const std::vector<const JointSpec*>& spec_of_joint, Model& model) {
  std::unordered_map<std::string_view, int> index;
  for (std::size_t i = 0; i < model.joints.size(); ++i)
    index.emplace(model.joints[i].name, static_cast<int>(i));
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    if (spec_of_joint[i] == nullptr || !spec_of_joint[i]->mimic) continue;
    const MimicSpec& mimic = *spec_of_joint[i]->mimic;
    const int leader = index.at(mimic.leader);
    const Joint& leading = model.joints[to_size(leader)];
    Joint& joint = model.joints[i];
    joint.follows = Following{leader, mimic.multiplier, mimic.offset};
    joint.q_index = leading.q_index;
    joint.v_index = leading.v_index;
  }
}

void take_over_limits(const std::vector<const JointSpec*>& spec_of_joint, const std::string& origin,
                      Model& model) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (!joint.follows) continue;
    const JointSpec& spec = *spec_of_joint[i];
    const Joint& leader = model.joints[to_size(joint.follows->leader)];
    const int q = joint.q_index, v = joint.v_index;
    const double factor = std::abs(joint.follows->multiplier);
    add_effort(spec.effort_limit, factor, model.effort_limit[v]);
    model.friction[v] += factor * spec.friction;
    model.damping[v] += factor * factor * spec.damping;
    model.armature[v] += factor * factor * spec.armature;
    if (factor > 0.0)
      model.velocity_limit[v] = std::min(model.velocity_limit[v], spec.velocity_limit / factor);
    if (joint.kind == JointKind::Continuous || leader.kind == JointKind::Continuous) continue;
    const LeaderRange range = range_of_leader(spec, *joint.follows);
    const double lower = std::max(model.q_lower[q], range.lower);
    const double upper = std::min(model.q_upper[q], range.upper);
    if (lower > upper) {
      refuse(origin,
             "joint " + in_quotes(joint.name) + " follows joint " + in_quotes(leader.name) +
                 ", but no posture is within the limits of both joints: the follower is at " +
                 number(joint.follows->multiplier) + " times " + in_quotes(leader.name) + " plus " +
                 number(joint.follows->offset) + " and has limits " + number(spec.lower) + " to " +
                 number(spec.upper) + ", and " + in_quotes(leader.name) + " has limits " +
                 number(model.q_lower[q]) + " to " + number(model.q_upper[q]));
    }
    model.q_lower[q] = lower;
    model.q_upper[q] = upper;
  }
}

bool has_spring(const JointSpec& spec) {
  return spec.stiffness > 0.0 && spec.type != JointType::Planar &&
         spec.type != JointType::Floating && spec.type != JointType::Fixed;
}

void take_over_springs(const std::vector<const JointSpec*>& spec_of_joint,
                       const std::string& origin, Model& model) {
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const Joint& joint = model.joints[i];
    if (!joint.follows || !has_spring(*spec_of_joint[i])) continue;
    const auto [leader_index, multiplier, offset] = *joint.follows;
    if (multiplier == 0.0) continue;  // the deflection is the same at all postures
    // Torque on the leader at q, with multiplier m, offset o, stiffness k and rest position r:
    // k (m q + o - r) m = m^2 k (q - (r - o) / m).
    const double added = multiplier * multiplier * spec_of_joint[i]->stiffness;
    const double rest = (spec_of_joint[i]->rest - offset) / multiplier;
    double& stiffness = model.stiffness[joint.v_index];
    double& leader_rest = model.spring_rest[joint.v_index];
    const Joint& leader = model.joints[to_size(leader_index)];
    if (leader.kind == JointKind::Continuous) {
      const double rest_difference = std::remainder(rest - leader_rest, 2.0 * std::numbers::pi);
      if (std::abs(multiplier) != 1.0 || (stiffness > 0.0 && std::abs(rest_difference) > 1e-9)) {
        refuse(origin,
               "joint " + in_quotes(joint.name) + " has a spring and follows joint " +
                   in_quotes(leader.name) + ", which is continuous; wanted a revolute joint " +
                   in_quotes(leader.name) +
                   ", or a multiplier of 1 or -1 and both springs at rest at one angle of " +
                   in_quotes(leader.name));
      }
    }
    leader_rest =
        stiffness > 0.0 ? (stiffness * leader_rest + added * rest) / (stiffness + added) : rest;
    stiffness += added;
  }
}

void chain_coupled_entries(Model& model) {
  // Builds the elimination tree of a sparse factorization, from the last entry to the first. The
  // parent of an entry is the last earlier entry that it is coupled to. The parent inherits the
  // entry's other couplings.
  std::vector<std::set<int>> before(to_size(model.nv));
  for (const Joint& joint : model.joints) {
    for (const int a : model.support(joint.parent)) {
      for (int b = joint.v_index; b < joint.v_index + std::max(joint.nv, 1); ++b) {
        if (a != b) before[to_size(std::max(a, b))].insert(std::min(a, b));
      }
    }
    for (int b = joint.v_index + 1; b < joint.v_index + joint.nv; ++b)
      for (int a = joint.v_index; a < b; ++a) before[to_size(b)].insert(a);
  }
  for (int k = model.nv - 1; k >= 0; --k) {
    std::set<int>& coupled = before[to_size(k)];
    const int parent = coupled.empty() ? -1 : *coupled.rbegin();
    model.parent_of_v[to_size(k)] = parent;
    if (parent < 0) continue;
    coupled.erase(parent);
    before[to_size(parent)].merge(coupled);
  }
}

double joint_value(const Model& model, const Joint& joint,
                   const Eigen::Ref<const Eigen::VectorXd>& q) {
  if (joint.follows) {
    const Joint& leader = model.joints[to_size(joint.follows->leader)];
    return joint.follows->multiplier * joint_value(model, leader, q) + joint.follows->offset;
  }
  if (joint.kind == JointKind::Continuous)
    return std::atan2(q[joint.q_index + 1], q[joint.q_index]);
  return q[joint.q_index];
}

std::pair<double, double> position_range(const Model& model, const Joint& joint) {
  const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
  if (!joint.follows) return {lower, upper};
  const Following& follows = *joint.follows;
  if (follows.multiplier == 0.0) return {follows.offset, follows.offset};
  const double a = follows.multiplier * lower + follows.offset;
  const double b = follows.multiplier * upper + follows.offset;
  return {std::min(a, b), std::max(a, b)};
}

std::string that_it_follows(const Model& model, const Joint& joint) {
  const Joint& leader = model.joints[to_size(joint.follows->leader)];
  return "joint " + in_quotes(joint.name) + " follows joint " + in_quotes(leader.name) +
         " and has no entry of its own; wanted joint " + in_quotes(leader.name);
}

}  // namespace burnish
