// Conversion of a tree's tendons: to followers, or to springs and dampers on joints that move by
// themselves.
#pragma once

#include <vector>

#include "model/mimic.hpp"

namespace burnish {

/// Returns the tree with each held tendon replaced by a mimic of one of its joints. Throws Error
/// with the names of tendon and joints if that is impossible.
TreeSpec with_held_tendons(const TreeSpec& tree, const ModelOptions& options);

/// Returns the tree's tendons over joints that move by themselves. The length along held joints is
/// subtracted from `rest`; the length along followers is assigned to their leaders. Leaves out
/// tendons that move no joint, and tendons without spring and damper.
///
/// Throws Error with the names of tendon and joint for unknown joints, joints with more than one
/// coordinate, and springs along continuous joints.
std::vector<TendonSpec> reduced_tendons(const TreeSpec& tree, const JointByName& joints,
                                        Courses& courses);

/// Compiles the tendons from reduced_tendons() for the entries of the model.
std::vector<Tendon> compile_tendons(const TreeSpec& reduced, const Model& model);

}  // namespace burnish
