// Kinematic tree of a model for kernels: constants in plain structs, and lists of ancestors.
//
// Each entry of v has one axis, unless joints follow other joints. A follower has its own axis but
// moves with the entry of v of its leader. Kernels scale the axis of a follower by its multiplier,
// compute one result per axis, and then add the results of all axes of an entry.
#pragma once

#include <utility>
#include <vector>

#include "burnish/model/inertia.hpp"
#include "math/spatial.hpp"

namespace burnish {

/// Constants of one joint and its body. The axis of the joint is the z axis of its frame.
struct TreeJoint {
  JointKind kind;  ///< Kind. A rotary follower is Continuous if its leader is, otherwise Revolute
  int parent;      ///< Joint index of the parent; -1: the world
  int q, v, nv;  ///< First entry in q and v, shared by leader and followers; number of entries in v
  int axis;      ///< First of the nv axes
  int follower;  ///< Index in Tree::followers; -1: not a follower
  Mat3<double> R;        ///< Rotation from the joint frame at zero to the parent body
  Vec3<double> p;        ///< Origin of the joint frame in the parent body [m]
  double mass;           ///< Mass of the body [kg]
  Vec3<double> com;      ///< Centre of mass, in the body [m]
  Sym3<double> inertia;  ///< Inertia about com, in body axes [kg m^2]
};

/// Mass distribution of a body, in body axes.
struct BodyInertia {
  double mass;           ///< Mass [kg]
  Vec3<double> com;      ///< Centre of mass [m]
  Sym3<double> inertia;  ///< Inertia about com [kg m^2]
};

/// Relation of a follower to its leader: value = multiplier * value of the leader + offset
/// [rad or m].
struct TreeFollower {
  double multiplier, offset;
  double cosine, sine;  ///< Cosine and sine of the offset
};

/// Sum of all axes of one entry of v on the path from a body to the root. It consists of the axis
/// nearest to the body (`own`), plus the next axis or the sum of all further axes (`above`).
struct AxisSum {
  int own, above;
};

/// Kinematic tree of a model.
struct Tree {
  explicit Tree(const Model& model);

  std::vector<TreeJoint> joints;
  std::vector<TreeFollower> followers;
  std::vector<int> parent_of_v;     ///< Model::parent_of_v
  std::vector<int> parent_of_axis;  ///< Next axis on the path to the root; -1 at the root
  std::vector<int> v_of_axis;
  std::vector<int> joint_of_axis;
  std::vector<double> armature;  ///< Armature per axis; zero for axes of followers
  std::vector<AxisSum> sums;     ///< Sums of axes; sum i has the axis number axes + i
  Vec3<double> gravity;          ///< Gravity in world axes [m/s^2]
  int nq = 0, nv = 0;
  int axes = 0;

  /// True if the tree is so deep that articulated bodies are cheaper than sparse matrices
  /// (articulated.hpp). Always false with followers, which connect branches.
  bool deep = false;

  /// Returns true if an entry of v can have several axes, whose results must be added.
  bool shares_entries() const { return !followers.empty(); }
  int bodies() const { return static_cast<int>(joints.size()); }
  /// Returns the maximal unbranched chains [first, end) of entries of v, in ascending order. In a
  /// chain, each entry is the only child of the previous entry.
  std::vector<std::pair<int, int>> chains() const;
};

/// Converts an InertiaSpec.
BodyInertia body_inertia(const InertiaSpec& inertia);
/// Replaces the mass distribution of a body, for example with a payload. Evaluations after the call
/// use the new values. Does not allocate.
void set_body_inertia(Tree& tree, int body, const BodyInertia& inertia);

/// Body of a model with a load.
struct LoadedBody {
  Status status;        ///< Result of check_inertia for the load
  int body;             ///< Joint index of the body
  InertiaSpec inertia;  ///< Inertia of the body with its load, in body axes
};
/// Returns the body of `frame`, with the load `carried` (given in `frame`) added to its inertia in
/// the model. Loads from earlier calls are not included. Throws Error as frame_on_body does.
/// Allocates only if it throws.
LoadedBody loaded_body(std::string_view call, const Model& model, std::string_view frame,
                       const InertiaSpec& carried);

/// Entry of v that moves a body, with the axis or sum of axes by which it moves the body.
struct MovingAxis {
  int v, axis;
};
/// Returns the entries of v that move a body (joint index; -1: the world), in ascending order.
std::vector<MovingAxis> moving_axes(const Model& model, int body);
/// Returns the axis or sum of axes by which entry v moves a body, or -1 if v does not move the
/// body. Does not allocate.
int moving_axis(const Tree& tree, int body, int v);

}  // namespace burnish
