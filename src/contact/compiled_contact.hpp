// Constants of a contact for one model: bodies, frame offsets, constrained rows, and the entries of
// v that move tool, base and reference.
#pragma once

#include <vector>

#include "burnish/contact/contact_set.hpp"
#include "dynamics/compiled_reference.hpp"
#include "math/spatial.hpp"

namespace burnish {

/// Entry of v that moves the body of the tool, the body of the base, or a body of the reference.
/// An axis index selects the axis or sum of axes (tree.hpp) along which the entry moves a body; -1:
/// the body does not move. The indices of two bodies differ only if the entry has followers or
/// moves just one of the bodies.
struct ContactSupport {
  int v;
  int tool_axis, base_axis;
  ReferenceAxes reference = {};
  /// Factor that scales the entry's column in linear rows of the Jacobian. For a rotation: one over
  /// the longest lever arm that the lengths of the robot allow [1/m]. For a sliding joint: 1.
  double per_reach = 1.0;

  bool moves_tool() const { return tool_axis >= 0; }
  bool moves_base() const { return base_axis >= 0; }
  /// Returns true if the entry moves tool and base as one body, or moves neither.
  bool carries_both() const { return tool_axis == base_axis; }
};

/// Constants of one contact for the kernels.
struct CompiledContact {
  ContactSpec spec;
  int tool_body, base_body;     ///< Joint indices, -1 for the world
  Mat3<double> tool_R, base_R;  ///< Rotations of tool frame C2, base frame C1 in their bodies
  Vec3<double> tool_p, base_p;  ///< Positions of tool frame C2, base frame C1 in their bodies [m]
  CompiledReference reference;
  Mat3<double> target_R;                ///< Rotation of spec.target
  Vec3<double> target_p;                ///< Position of spec.target [m]
  std::vector<int> directions;          ///< Indices of constrained directions, 0 to 5, ascending
  bool proportional, damped;            ///< Whether any kp > 0, and whether any kd > 0
  bool holds_rotation;                  ///< Whether a constrained direction is angular
  bool has_friction = false;            ///< Whether spec.friction is set; row 0 is then the normal
  std::vector<ContactSupport> support;  ///< Entries that move tool or base, ascending in v
  /// Entries on which the constrained acceleration depends: the entries of `support` and those that
  /// move only the reference. Ascending in v.
  std::vector<ContactSupport> influences;
  double offset_weight = 0.0;  ///< Factor on |p|^2 in attainable_row_size() [1/m^2]
  /// Rows of L^-T J^T (with M = L^T L) that can be nonzero, ascending: entries of `support` and all
  /// their ancestors. Equals `support` unless followers couple branches.
  std::vector<int> coupled;
  std::vector<int> influenced;  ///< Entries of `influences` and all their ancestors, ascending
};

/// Throws Error if `contact` has no friction. The message begins with `call`.
void check_has_friction(const std::string& call, const CompiledContact& contact);

}  // namespace burnish
