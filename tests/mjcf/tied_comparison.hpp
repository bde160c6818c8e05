// Compares forward dynamics under the equalities of a file with MuJoCo's terms.
#pragma once

#include "burnish/model/tree_spec.hpp"
#include "mujoco/mujoco_description.hpp"

namespace burnish::testing {

/// Worst errors of accelerations over random states on the loops, relative to the largest entry.
struct TiedAgreement {
  int rows = 0;         ///< rows of MuJoCo's equalities that the tree contains
  int left_out = 0;     ///< equalities that the tree does not contain; they are deactivated
  int states = 0;       ///< compared states
  double rest = 0.0;    ///< at v = 0
  double moving = 0.0;  ///< at velocities that the equalities allow
  double worst() const { return std::max(rest, moving); }
};

/// Compares the accelerations of burnish, whose loops are contacts and whose followers and locked
/// joints have no coordinates, with the solution of
///   [M  -J^T] [qacc  ]   [qfrc_applied + qfrc_passive - qfrc_bias]
///   [J    0 ] [lambda] = [-dJ/dt qvel                            ],
/// with all of MuJoCo's coordinates and J = efc_J of all its equalities. Rows may be dependent, so
/// that only accelerations are compared. Fewer states are compared if loops cannot be closed from
/// random postures. Throws Error if the joints differ or MuJoCo's rows use other points.
TiedAgreement compare_tied(const TreeSpec& tree, mjModel& theirs, int states);

}  // namespace burnish::testing
