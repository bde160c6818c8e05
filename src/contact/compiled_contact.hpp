// A contact compiled against a model: bodies, offsets, rows, and which entries of v move what.
#pragma once

#include <vector>

#include "burnish/contact/contact_set.hpp"
#include "dynamics/compiled_reference.hpp"
#include "math/spatial.hpp"

namespace burnish {

/// An entry of v that moves the tool's body, the base's body, what the reference is fixed in, or
/// several of them, each by an axis (or sum of axes: tree.hpp) of its own, -1 where it does not
/// move it. Axes are the same but for followers.
struct ContactSupport {
  int v;
  int tool_axis, base_axis;
  ReferenceAxes reference = {};
  /// 1/m: what a linear row of the Jacobian is multiplied by at this entry to say which part it is
  /// of what the entry could do, lengths of the robot being what they are; 1 for a sliding joint.
  double per_reach = 1.0;

  bool moves_tool() const { return tool_axis >= 0; }
  bool moves_base() const { return base_axis >= 0; }
  /// Whether it moves tool and base as one body, or neither.
  bool carries_both() const { return tool_axis == base_axis; }
};

/// Constants of one contact, as the kernels read them.
struct CompiledContact {
  ContactSpec spec;
  int tool_body, base_body;     ///< joint index, -1 for the world
  Mat3<double> tool_R, base_R;  ///< of C2 and C1 in their bodies
  Vec3<double> tool_p, base_p;  ///< m
  CompiledReference reference;
  Mat3<double> target_R;  ///< spec.target
  Vec3<double> target_p;
  std::vector<int> directions;          ///< the held ones, ascending, 0 to 5
  bool proportional, damped;            ///< some held direction has kp or kd
  bool holds_rotation;                  ///< some held direction is angular
  bool rubs = false;                    ///< spec.friction; of the held rows the first is its normal
  std::vector<ContactSupport> support;  ///< moves tool or base; ascending in v
  /// The same and what moves the reference alone: by these the acceleration changes that is held.
  std::vector<ContactSupport> influences;
  double offset_weight = 0.0;  ///< 1/m^2, of the tool's squared distance from the world's origin
  /// Entries of the support and those on their ways to the root, ascending; the same entries unless
  /// followers tie branches together. Where L^-T J^T is not zero.
  std::vector<int> coupled;
  std::vector<int> influenced;  ///< the same of `influences`
};

/// Throws Error, named after the call, for a contact without friction.
void check_rubs(const std::string& call, const CompiledContact& contact);

}  // namespace burnish
