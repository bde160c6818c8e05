// A robot compiled for evaluation: joints in depth-first order, bodies, frames, limits.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/error.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Kinds of moving joints.
/// @described model
/// Every joint frame is turned so that its axis is z (one without an axis stays as it is); frames
/// by name keep the axes of the file.
enum class JointKind {
  Revolute,    ///< q = angle, v = rate @note nq = 1, nv = 1
  Continuous,  ///< q = (cos, sin), v = rate @note nq = 2, nv = 1
  Prismatic,   ///< q = displacement, v = rate @note nq = 1, nv = 1
  Planar,      ///< q = (x, y, cos, sin), v = (v_x, v_y, w_z) in body axes @note nq = 4, nv = 3
  FreeFlyer,   ///< q = (p, quaternion x y z w), v = (v, w) in body axes @note nq = 7, nv = 6
  Ball,        ///< q = quaternion x y z w, v = w in body axes @note nq = 4, nv = 3
};

/// Number of entries of a joint in q and in v.
int joint_nq(JointKind kind);
int joint_nv(JointKind kind);
std::string_view name_of(JointKind kind);

/// How a joint moves with another one: multiplier * value of the leader + offset, rad or m.
/// @described model
struct Following {
  int leader = 0;  ///< index of a joint that follows no other
  double multiplier = 1.0;
  double offset = 0.0;
};

/// A moving joint of a Model and the rigid body that it carries. One that follows another has no
/// entries of its own in q and v: its leader's move both.
/// @described model @result
/// Links that are fixed to each other are one body.
struct Joint {
  std::string name;
  JointKind kind = JointKind::Revolute;
  int parent = -1;  ///< index of the joint that carries this one, -1 for the world
  int q_index = 0;  ///< first entry in q; of a follower that of its leader
  int v_index = 0;  ///< first entry in v; of a follower that of its leader
  int nq = 0;       ///< entries in q, 0 of a follower
  int nv = 0;       ///< entries in v, 0 of a follower
  std::optional<Following> follows = {};  ///< @after inertia_at_com
  /// joint frame at zero in the parent body's frame
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  double mass = 0.0;                              ///< of the body, kg
  Eigen::Vector3d com = Eigen::Vector3d::Zero();  ///< of the body, in the joint frame, m
  /// of the body, about com, joint axes, kg m^2
  Eigen::Matrix3d inertia_at_com = Eigen::Matrix3d::Zero();
};

/// A joint that has a position in the description: it moves in the model too, or is held.
/// @described model @result
struct StatedJoint {
  std::string name;
  JointKind kind = JointKind::Revolute;
  int joint = -1;            ///< index in the model's joints, -1: held
  std::vector<double> held;  ///< where it is held, in the coordinates of a Posture
};

/// Joints of a Model coupled by the length of a tendon, which has a spring, a damper or both. What
/// locked joints add is taken off `rest`, and what followers add stands at their leaders.
/// @described model @result
/// The length is the sum of coefficient times position over its parts.
struct Tendon {
  /// A joint that a tendon of a Model goes along.
  /// @described model.TendonEntry @result
  struct Entry {
    int q = 0;                 ///< the joint's entry of q, if its kind has one alone
    int v = 0;                 ///< the joint's entry of v
    double coefficient = 1.0;  ///< [m/rad] or 1
  };
  std::string name;
  std::vector<Entry> parts;  ///< ascending in v
  double rest = 0.0;         ///< [m]
  double stiffness = 0.0;    ///< [N/m]
  double damping = 0.0;      ///< {Ns/m}
};

/// What a named frame belongs to.
/// @described model
enum class FrameKind {
  Link,
  Joint,
  User,
};

/// A named frame fixed to a body of a Model.
/// @described model @result
struct Frame {
  std::string name;
  FrameKind kind = FrameKind::Link;
  int body = -1;                ///< index of the joint whose body carries it, -1 for the world
  Eigen::Isometry3d placement;  ///< in the body's frame (in the world if body is -1) @required
};

/// A solid to draw, fixed to a body of a Model.
/// @described model @result
struct Visual {
  std::string link;
  int body = -1;
  Eigen::Isometry3d placement;  ///< @required
  Shape shape;
  Eigen::Vector4d rgba;
};

/// Two frames of a Model tied to each other along some directions: motion of the second seen from
/// the first, in the first one's axes.
/// @described model @result
/// Loops close chains (LoopSpec); contact/loops.hpp makes contacts of them.
struct Loop {
  std::string name;
  std::string first;   ///< frame of the model, NAME/first
  std::string second;  ///< frame of the model, NAME/second
  Directions directions = Directions::linear();
};

/// How the root link stands in the world.
/// @described model
enum class Base {
  Fixed,
  FreeFlyer,
};

/// How a TreeSpec becomes a Model.
/// @described model
struct ModelOptions {
  Base base = Base::Fixed;
  /// Placement of the root link in the world; with a free-flyer only the neutral posture uses it.
  Eigen::Isometry3d base_placement = Eigen::Isometry3d::Identity();
  /// Joints to lock. A locked joint is fixed at its value in `posture`, or at zero, and those that
  /// follow it where it puts them.
  std::vector<std::string> locked;
  /// When not empty: every joint that is not listed here is locked (a free-flying base stays free),
  /// but for those that follow a listed one.
  std::vector<std::string> free;
  Posture posture;  ///< Where locked joints are held; values of joints that move are passed over.
  std::vector<FrameSpec> frames;  ///< added in this order; a parent may be an earlier one
  Eigen::Vector3d gravity = Eigen::Vector3d(0.0, 0.0, -9.81);  ///< [m/s^2]
  bool strict = false;                                         ///< refuse what would be a warning
};

/// An immutable robot. Cheap to move, safe to share between threads.
/// The vectors over q have nq entries, those over v nv; infinite where the file states no limit.
struct Model {
  std::string name;
  /// Depth-first. Joints of one parent link are in the order of their names, or as the description
  /// lists them (TreeSpec::sibling_order): as in MuJoCo of an MJCF file.
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Visual> visuals;
  std::vector<Loop> loops;  ///< that the description closes, in its order
  int nq = 0;
  int nv = 0;
  Eigen::Vector3d gravity;
  Eigen::VectorXd q_neutral;  ///< zero angles, unit quaternions, base at base_placement
  Eigen::VectorXd q_lower, q_upper;
  Eigen::VectorXd velocity_limit, effort_limit;
  Eigen::VectorXd damping, friction, armature;
  /// Of the springs in joints, Nm/rad (N/m), and where they are at rest, rad (m): 0 of a ball.
  Eigen::VectorXd stiffness, spring_rest;
  std::vector<Tendon> tendons;  ///< those with a spring or a damper on a joint that moves

  /// Joint that owns entry k of v, and the previous entry on the way to the root (-1 at the root).
  /// Entries of one joint are chained: the second hangs on the first. With followers an entry moves
  /// bodies on several branches; the ways are then such that any two entries which move a common
  /// body are on one of them.
  std::vector<int> joint_of_v;
  std::vector<int> parent_of_v;

  /// Entries of v that move body `body`, ascending; empty for the world (-1).
  std::span<const int> support(int body) const;
  /// Name of entry k of v: the joint's name, with ".vx" ... ".wz" for joints of several entries.
  std::string v_name(int k) const;
  std::string q_name(int k) const;

  /// Index by name. Throws Error with the nearest known name. Where a link and a joint share a
  /// name, the frame is the link's.
  int frame_index(std::string_view frame_name) const;
  int joint_index(std::string_view joint_name) const;
  bool has_frame(std::string_view frame_name) const;

  /// Of all moving bodies, kg; links fixed to the world do not count.
  double total_mass() const;

  std::vector<std::string> locked_joints;  ///< moving joints of the description that were locked
  /// All joints with a position in the description, followers and held ones too, in the order of
  /// `joints`; JointOrder maps vectors over them.
  std::vector<StatedJoint> stated_joints;
  /// What is odd about the description but computes, one sentence each: that of the TreeSpec, then
  /// inertias that no solid has and joints that move no mass.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;  ///< those of the TreeSpec

  /// Storage of support(): entries begin[body] to begin[body + 1].
  std::vector<int> support_entries, support_begin;
};

/// Compiles a tree. Throws Error naming the source, the element and the reason, and all problems of
/// the tree at once.
///
/// Refused are: no links, more than 2000 links, a tree deeper than 500 links; names that are empty,
/// used twice or unknown; two roots, a link with two parents, a cycle; numbers that are not finite;
/// negative masses, moments of inertia, limits, damping, friction, armature or stiffness; inertias
/// that are not symmetric; zero axes (others are normalised); lower limits above upper ones.
///
/// Warnings, which ModelOptions::strict turns into refusals, are: figures that no robot has, as
/// those of a wrong unit (docs/robots.md); inertias that belong to no solid (principal moments may
/// break the triangle inequality by 5 % of the largest, since published figures are rounded);
/// joints that move no mass at any posture and have no armature: Status::SingularMass; position
/// limits of a ball and springs in planar and floating joints, which are passed over.
///
/// A loop adds two frames, NAME/first and NAME/second, that hang on its links or stand in the
/// world. Refused are loops without a name, directions or known links, two of one name, and one of
/// a link with itself. Where a loop's links are one body, because joints are fixed or locked, it is
/// dropped if they meet there to 1 mm and 0.1 degrees along its directions, and refused otherwise.
///
/// Position limits count for revolute and prismatic joints only; the other limits, damping,
/// friction and armature of a planar, floating or ball joint hold for each of its entries.
///
/// A joint that mimics another one, directly or through others, follows it: Joint::follows. Both
/// have one coordinate; where one of them is continuous the multiplier is a whole number, since an
/// angle on the circle has no other multiples. A follower has no motor: its effort limit and its
/// friction, times |multiplier|, are added to the leader's, its damping and its armature times
/// multiplier^2. The leader's limits of position and velocity are those that hold for both, and an
/// empty range is refused; a follower of a continuous leader has no position limits. A follower
/// whose leader is locked or fixed is held where it puts it. A follower that is listed as locked is
/// held at its value in the posture, or else at the one that its locked leader gives.
///
/// Springs in joints (torque -k (q - rest); the angle from rest, the short way, on the circle; -k
/// log(q) of a ball) and springs and dampers of tendons are in no dynamics unless the caller adds
/// them, as damping and friction: RigidBody::passive_torque. The spring of a follower stands at its
/// leader, stiffness times multiplier^2; where the leader is continuous that is refused unless the
/// multiplier is 1 or -1 and both rest at one angle. A spring in a locked joint does nothing.
///
/// A tendon that is held couples two joints of one coordinate, of which one then follows the other:
/// the second the first, unless that one alone can follow. Refused are held tendons of one joint,
/// and of more than two that are not locked; tendons of joints that are unknown or have not one
/// coordinate; springs of tendons along continuous joints, whose angle has no length.
Model build_model(const TreeSpec& tree, const ModelOptions& options = {});

/// The posture as a configuration: joints it doesn't name stay neutral. Names of locked joints are
/// passed over, and so is "root_joint" on a fixed base; unknown names and wrong sizes throw Error.
/// The value of a follower stands for that of a leader which has none in the posture; to 1e-3
/// (files are rounded) it must be the one that the leader's gives.
Eigen::VectorXd configuration(const Model& model, const Posture& posture);

}  // namespace burnish
