// The model as the kernels read it: constants in plain structs, ancestor lists.
//
// Axes and entries of v are the same, one by one, unless joints follow others. A follower has an
// axis of its own but moves by its leader's entry of v: with q_full = S q + s, axis k of S's column
// is multiplier * S_k. Kernels work on axes, scaled so, and add up what the axes of an entry give.
#pragma once

#include <utility>
#include <vector>

#include "burnish/model/inertia.hpp"
#include "math/spatial.hpp"

namespace burnish {

/// Constants of one joint and its body. The joint's axis is z of its frame.
struct TreeJoint {
  JointKind kind;    ///< of a turning follower: Continuous where its leader is, else Revolute
  int parent;        ///< joint index, -1 for the world
  int q, v, nv;      ///< first entry in q and v, number of entries in v; of a follower its leader's
  int axis;          ///< first of its nv axes
  int follower;      ///< index into the tree's followers, -1 for none
  Mat3<double> R;    ///< joint frame at zero in the parent body
  Vec3<double> p;    ///< m
  double mass;       ///< kg
  Vec3<double> com;  ///< in the body, m
  Sym3<double> inertia;  ///< about com, body axes, kg m^2
};

/// Mass distribution of a body, in its axes.
struct BodyInertia {
  double mass;           ///< kg
  Vec3<double> com;      ///< m
  Sym3<double> inertia;  ///< about com, kg m^2
};

/// Value of a follower: multiplier * value of its leader + offset, rad or m.
struct TreeFollower {
  double multiplier, offset;
  double cosine, sine;  ///< of the offset
};

/// An axis that stands for all those of one entry of v on a body's way to the root: axis `own`, the
/// nearest to the body, plus `above`, which may be such a sum itself.
struct AxisSum {
  int own, above;
};

struct Tree {
  explicit Tree(const Model& model);

  std::vector<TreeJoint> joints;
  std::vector<TreeFollower> followers;
  std::vector<int> parent_of_v;     ///< Model::parent_of_v
  std::vector<int> parent_of_axis;  ///< previous axis on the way to the root, -1 at the root
  std::vector<int> v_of_axis;
  std::vector<int> joint_of_axis;
  std::vector<double> armature;  ///< per axis: that of an entry of v is on its owner's
  std::vector<AxisSum> sums;     ///< sum i has the number axes + i
  Vec3<double> gravity;          ///< m/s^2, world axes
  int nq = 0, nv = 0;
  int axes = 0;

  /// Whether entries of v have so many relatives on the ways to the root and to the tips that
  /// articulated bodies are cheaper than sparse matrices (articulated.hpp). Never with followers,
  /// which tie branches together.
  bool deep = false;

  /// Whether entries of v have several axes, so that results per axis are to be added up.
  bool shares_entries() const { return !followers.empty(); }
  int bodies() const { return static_cast<int>(joints.size()); }
  /// Maximal chains [first, end) of entries of v in which each but the first hangs on the one
  /// before it and each but the last carries that one alone; ascending.
  std::vector<std::pair<int, int>> chains() const;
};

BodyInertia body_inertia(const InertiaSpec& inertia);
/// Another mass distribution in the place of that of a body: a payload taken up, for states that
/// are evaluated from then on. Allocates nothing.
void set_body_inertia(Tree& tree, int body, const BodyInertia& inertia);

/// A body of a model together with what it carries at one of its frames, whatever it carried
/// before; `status` is that of check_inertia. Throws Error as frame_on_body does. Allocates nothing
/// otherwise.
struct LoadedBody {
  Status status;
  int body;
  InertiaSpec inertia;  ///< in the body's axes
};
LoadedBody loaded_body(std::string_view call, const Model& model, std::string_view frame,
                       const InertiaSpec& carried);

/// An entry of v that moves a body, and the axis, or sum of axes, by which it does.
struct MovingAxis {
  int v, axis;
};
/// Of a body (joint index, -1 for the world), ascending in v.
std::vector<MovingAxis> moving_axes(const Model& model, int body);
/// The axis, or sum of axes, by which entry v moves a body; -1 where it does not. Allocates
/// nothing.
int moving_axis(const Tree& tree, int body, int v);

}  // namespace burnish
