// Followers (joints that follow a leader): their contribution to the tables over q and v during
// compilation, and their positions in a compiled model.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Finds the leader of each follower and assigns the leader's entries to the follower. Followers
/// are the joints whose description still has a mimic after lock_joints(). `spec_of_joint` holds
/// the joint of the description for each joint of the model, nullptr for a free-flying base.
void couple_followers(const std::vector<const JointSpec*>& spec_of_joint, Model& model);

/// Adds effort, friction, damping and armature of the followers to those of their leaders.
/// Restricts the limits of leaders so that each follower stays within its own limits. Throws Error
/// with the names of the joints if no position remains.
void take_over_limits(const std::vector<const JointSpec*>& spec_of_joint, const std::string& origin,
                      Model& model);

/// Returns true if the joint has a spring. Springs of planar and floating joints are ignored.
bool has_spring(const JointSpec& spec);

/// Adds the springs of the followers to the springs of their leaders. Throws Error with the names
/// of the joints if the leader is continuous and one spring cannot represent the sum.
void take_over_springs(const std::vector<const JointSpec*>& spec_of_joint,
                       const std::string& origin, Model& model);

/// Sets parent_of_v such that entries of v which move a common body lie on one path to the root.
/// The factor L of M = L^T L is then zero for entries that do not share a path.
void chain_coupled_entries(Model& model);

/// Returns the position of a joint with one coordinate at the configuration `q` [rad, m]. A
/// follower's position follows from its leader's. A continuous joint that is no follower is in
/// [-pi, pi].
double joint_value(const Model& model, const Joint& joint,
                   const Eigen::Ref<const Eigen::VectorXd>& q);

/// Returns the lower and upper position limit of a revolute or prismatic joint [rad, m]. A
/// follower's limits follow from its leader's.
std::pair<double, double> position_range(const Model& model, const Joint& joint);

/// Returns "joint 'f' follows joint 'l' and has no entry of its own; wanted joint 'l'", for error
/// messages.
std::string that_it_follows(const Model& model, const Joint& joint);

}  // namespace burnish
