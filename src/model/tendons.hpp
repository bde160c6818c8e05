// What becomes of a tree's tendons: joints that follow others, or springs and dampers on joints
// that move by themselves.
#pragma once

#include <vector>

#include "model/mimic.hpp"

namespace burnish {

/// The tree with a mimic in place of each tendon that is held. Throws Error naming tendon and
/// joints where that cannot be.
TreeSpec with_held_tendons(const TreeSpec& tree, const ModelOptions& options);

/// The tree's tendons over joints that move by themselves: what held joints add to the length is
/// taken off `rest`, what followers add is their leaders'. Without those that move nothing or have
/// neither spring nor damper. Throws Error naming tendon and joint for a joint that is unknown, has
/// not one coordinate, or has no length.
std::vector<TendonSpec> reduced_tendons(const TreeSpec& tree, const JointByName& joints,
                                        Courses& courses);

/// The tendons of a tree that reduced_tendons() gave, at the model's entries.
std::vector<Tendon> compile_tendons(const TreeSpec& reduced, const Model& model);

}  // namespace burnish
