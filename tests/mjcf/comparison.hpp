// Compares burnish's reading of an MJCF file with MuJoCo's. If MuJoCo 2.2.2 cannot read the file,
// it reads a copy with bodies, joints, fixed tendons and equalities only.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/model/tree_spec.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::testing {

/// Worst errors over random states, each relative to the largest entry of the compared values.
struct Agreement {
  double mass_matrix = 0.0;
  double bias = 0.0;
  double placement = 0.0;    ///< of bodies: positions [m] and entries of rotations
  double passive = 0.0;      ///< torques of springs and dampers in joints and tendons
  double coordinates = 0.0;  ///< qpos and qvel, mapped from burnish to MuJoCo and back
  double worst() const { return std::max({mass_matrix, bias, placement, coordinates}); }
};

/// Compares the two models. Followers and locked joints move independently in MuJoCo; its results
/// are reduced to the leaders. Throws Error if the models differ in joints or in their order.
Agreement compare(const TreeSpec& tree, mjModel& theirs, int states);

/// Returns MuJoCo's reading of a file. Throws Error with MuJoCo's reason.
mujoco::ModelPointer load(const std::filesystem::path& file);

/// Returns a text for MuJoCo 2.2.2 with the file's bodies, joints, fixed tendons, equalities and
/// defaults, and the masses of the tree. Throws Error if a frame contains joints, as MuJoCo 3
/// allows.
std::string plain_copy(const std::filesystem::path& file, const TreeSpec& tree);

/// Sets masses and inertias of MuJoCo's model to those of the tree; MuJoCo reads inertias to seven
/// digits only.
void load_masses(const TreeSpec& tree, mjModel& theirs);

}  // namespace burnish::testing
