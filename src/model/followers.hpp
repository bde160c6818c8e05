// What followers do to the tables over q and v of a model that is being compiled, and where they
// are in one that is.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// Finds the leaders of joints whose description still mimics another (lock.hpp) and gives the
/// followers their leaders' entries. `spec_of_joint`: the joint of the description behind each of
/// the model, nullptr for a free-flying base.
void couple_followers(const std::vector<const JointSpec*>& spec_of_joint, Model& model);

/// Adds effort, friction, damping and armature of the followers to their leaders', and takes the
/// limits that hold for both. Throws Error naming the joints where no position is left.
void take_over_limits(const std::vector<const JointSpec*>& spec_of_joint, const std::string& origin,
                      Model& model);

/// Whether the joint has a spring that counts: planar and floating joints have none.
bool has_spring(const JointSpec& spec);

/// Adds the springs of the followers to their leaders'. Throws Error naming the joints where a
/// leader on the circle would have no one spring.
void take_over_springs(const std::vector<const JointSpec*>& spec_of_joint,
                       const std::string& origin, Model& model);

/// Lays the ways to the root such that entries of v which move a common body are on one: M = L^T L
/// then has zeros in L wherever two entries are on none.
void chain_coupled_entries(Model& model);

/// Value of a joint of one coordinate at a configuration, rad or m: of a follower what its leader
/// gives, of a continuous joint in [-pi, pi] unless it follows one.
double joint_value(const Model& model, const Joint& joint,
                   const Eigen::Ref<const Eigen::VectorXd>& q);

/// Least and greatest position of a revolute or prismatic joint, rad or m; a follower's are those
/// that its leader's limits give.
std::pair<double, double> position_range(const Model& model, const Joint& joint);

/// "joint 'f' follows joint 'l' and has no entry of its own; name that one", for refusals.
std::string that_it_follows(const Model& model, const Joint& joint);

}  // namespace burnish
