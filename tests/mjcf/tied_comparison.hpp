// Forward dynamics under the equalities of a file, beside MuJoCo's own terms.
#pragma once

#include "burnish/model/tree_spec.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::testing {

/// Worst errors of accelerations over random states on the loops, relative to the largest entry.
struct TiedAgreement {
  int rows = 0;         ///< of MuJoCo's equalities that the tree carries
  int left_out = 0;     ///< equalities that the tree does not carry, which are put out of work
  int states = 0;       ///< that were compared
  double rest = 0.0;    ///< at v = 0
  double moving = 0.0;  ///< at velocities that the equalities allow
  double worst() const { return std::max(rest, moving); }
};

/// Accelerations by burnish, whose loops are contacts and whose followers and held joints have no
/// coordinates, beside those of
///   [M  -J^T] [qacc  ]   [qfrc_applied + qfrc_passive - qfrc_bias]
///   [J    0 ] [lambda] = [-dJ/dt qvel                            ],
/// with all of MuJoCo's coordinates and J = efc_J of all its equalities. Rows may depend on each
/// other: only accelerations are compared. Few states count where loops can hardly be closed from
/// random postures. Throws Error where the two have other joints or MuJoCo ties other points.
TiedAgreement compare_tied(const TreeSpec& tree, mjModel& theirs, int states);

}  // namespace burnish::testing
