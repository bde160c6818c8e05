// Contacts compiled against a model: bodies, offsets, rows, and which entries of v move what.
#pragma once

#include <string>
#include <vector>

#include "burnish/contact/contact.hpp"
#include "burnish/dynamics/compiled_reference.hpp"
#include "burnish/math/spatial.hpp"
#include "burnish/model/model.hpp"

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
  std::vector<ContactSupport> support;  ///< moves tool or base; ascending in v
  /// The same and what moves the reference alone: by these the acceleration changes that is held.
  std::vector<ContactSupport> influences;
  double offset_weight = 0.0;  ///< 1/m^2, of the tool's squared distance from the world's origin
  /// Entries of the support and those on their ways to the root, ascending; the same entries unless
  /// followers tie branches together. Where L^-T J^T is not zero.
  std::vector<int> coupled;
  std::vector<int> influenced;  ///< the same of `influences`
};

/// Of one model: memory and time grow with the square and the cube of their rows.
inline constexpr std::size_t max_contacts = 100;

/// Contacts of a model, in the order given. Immutable; rows of contact i start at first_row(i) when
/// every contact is active.
class ContactSet {
 public:
  ContactSet() = default;
  /// Throws Error with one sentence naming the contact, what came and what was wanted (unknown
  /// frame: the nearest known one).
  ContactSet(const Model& model, const std::vector<ContactSpec>& specs);

  const std::vector<CompiledContact>& contacts() const { return contacts_; }
  int size() const { return static_cast<int>(contacts_.size()); }
  int rows() const { return rows_; }
  /// Index by name. Throws Error with the nearest known name.
  int index(const std::string& name) const;
  /// Name of each row, such as "pad/z".
  std::vector<std::string> row_names() const;

 private:
  std::vector<CompiledContact> contacts_;
  int rows_ = 0;
};

}  // namespace burnish
