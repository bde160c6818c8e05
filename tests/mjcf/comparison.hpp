// An MJCF file as burnish reads it beside MuJoCo's own reading, or, of files that MuJoCo 2.2.2 does
// not read, beside MuJoCo's reading of a copy with bodies and joints alone.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/model/tree_spec.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::testing {

/// Worst errors over random states, each relative to the largest entry of what is compared.
struct Agreement {
  double mass_matrix = 0.0;
  double bias = 0.0;
  double placement = 0.0;    ///< of bodies, m and entries of rotations
  double passive = 0.0;      ///< torques of springs and dampers, of joints and tendons
  double coordinates = 0.0;  ///< of qpos and qvel as vectors, mapped there and back
  double worst() const { return std::max({mass_matrix, bias, placement, coordinates}); }
};

/// Followers and held joints of the tree move by themselves in MuJoCo; what it says is reduced.
/// Throws Error where the two have other joints, or have them in another order.
Agreement compare(const TreeSpec& tree, mjModel& theirs, int states);

/// MuJoCo's reading of a file. Throws Error with its sentence.
mujoco::ModelPointer load(const std::filesystem::path& file);

/// A text for MuJoCo 2.2.2 with the bodies, joints, fixed tendons, equalities and defaults of the
/// file, taken from it element by element, and the masses of the tree. Throws Error where a frame
/// of MuJoCo 3 holds joints.
std::string plain_copy(const std::filesystem::path& file, const TreeSpec& tree);

/// Masses and inertias of the tree to the last digit; MuJoCo's own reading of an inertia is good to
/// seven.
void load_masses(const TreeSpec& tree, mjModel& theirs);

}  // namespace burnish::testing
