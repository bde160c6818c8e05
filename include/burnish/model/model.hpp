// A robot prepared for computation: joints in depth-first order, bodies, frames and limits.
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
/// The z axis of a joint frame is the joint axis. The joint frames of floating and ball joints,
/// which have no axis, keep the axes of the description file. A named Frame always keeps the axes
/// of the file.
enum class JointKind {
  Revolute,    ///< q = angle, v = rate @note nq = 1, nv = 1
  Continuous,  ///< q = (cos, sin), v = rate @note nq = 2, nv = 1
  Prismatic,   ///< q = displacement, v = rate @note nq = 1, nv = 1
  Planar,      ///< q = (x, y, cos, sin), v = (v_x, v_y, w_z) in body axes @note nq = 4, nv = 3

  /// q = (position, quaternion x y z w), v = (linear, angular velocity) in body axes @note nq = 7,
  /// nv = 6
  FreeFlyer,
  Ball,  ///< q = quaternion x y z w, v = angular velocity in body axes @note nq = 4, nv = 3
};

/// Returns the number of entries in q of a joint of this kind.
int joint_nq(JointKind kind);
/// Returns the number of entries in v of a joint of this kind.
int joint_nv(JointKind kind);
std::string_view name_of(JointKind kind);

/// Coupling of a follower joint to its leader joint: follower position = multiplier * leader
/// position + offset, in rad or m.
/// @described model
struct Following {
  int leader = 0;  ///< Index of the leader, which is not a follower itself
  double multiplier = 1.0;
  double offset = 0.0;
};

/// A moving joint of a Model, and the rigid body that the joint moves. A follower is a joint whose
/// position is computed from another joint, the leader. A follower has no entries in q and v.
/// @described model @result
/// Links that are fixed to each other form one body.
struct Joint {
  std::string name;
  JointKind kind = JointKind::Revolute;
  int parent = -1;  ///< Index of the parent joint; -1: the world
  int q_index =
      0;  ///< Index of the first entry in q; for a coupled joint (follower), the leader's index
  int v_index =
      0;  ///< Index of the first entry in v; for a coupled joint (follower), the leader's index
  int nq = 0;  ///< Number of entries in q; 0 for a coupled joint (follower)
  int nv = 0;  ///< Number of entries in v; 0 for a coupled joint (follower)

  /// Coupling to another joint, the leader; only for coupled joints (followers) @after
  /// inertia_at_com
  std::optional<Following> follows = {};
  /// Placement of the joint frame in the parent body's frame, at joint position zero
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  double mass = 0.0;  ///< Mass of the body [kg]

  /// Centre of mass of the body in the joint frame [m]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();
  /// Inertia of the body about its centre of mass, in the axes of the joint frame [kg m^2]
  Eigen::Matrix3d inertia_at_com = Eigen::Matrix3d::Zero();
};

/// A joint that can move according to the robot's description. In the model, the joint either moves
/// or is held at a constant position.
/// @described model @result
struct FileJoint {
  std::string name;
  JointKind kind = JointKind::Revolute;
  int joint = -1;  ///< Index in the model's joints; -1: the joint is held

  /// Position of a held joint, as in a Posture; empty if the joint moves
  std::vector<double> held;
};

/// A tendon of a Model. Its length is a weighted sum of joint positions. A spring, a damper or both
/// act on the length. Locked joints contribute to `rest`. A coupled joint (follower) contributes to
/// the coefficient of its leader.
/// @described model @result
/// The length is the sum of coefficient * position over `parts`.
struct Tendon {
  /// A joint along a tendon of a Model.
  /// @described model.TendonEntry @result
  struct Entry {
    int q = 0;  ///< Index of the joint's position in q (of its cosine for a continuous joint)
    int v = 0;  ///< Index of the joint's entry in v

    /// Tendon length per joint position [m/rad]; dimensionless for a prismatic joint
    double coefficient = 1.0;
  };
  std::string name;
  std::vector<Entry> parts;  ///< Joints along the tendon, in ascending order of v
  double rest = 0.0;         ///< Length at which the spring is at rest [m]
  double stiffness = 0.0;    ///< Stiffness of the spring [N/m]
  double damping = 0.0;      ///< Damping of the length [Ns/m]
};

/// Kinds of named frames: frame of a link, frame of a joint, or additional frame.
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
  int body = -1;  ///< Index of the joint that moves the frame; -1: fixed to the world

  /// Placement in the body's frame, or in the world if body is -1 @required
  Eigen::Isometry3d placement;
};

/// A solid shape to draw, fixed to a body of a Model.
/// @described model @result
struct Visual {
  std::string link;
  int body = -1;
  Eigen::Isometry3d placement;  ///< @required
  Shape shape;
  Eigen::Vector4d rgba;
};

/// A constraint between two frames of a Model that closes a kinematic chain. The constraint
/// prevents relative motion of the frames along `directions`, in the axes of the first frame.
/// @described model @result
/// loop_contacts() in contact/loops.hpp converts loops to contacts. A LoopSpec is a loop in a
/// robot's description.
struct Loop {
  std::string name;
  std::string first;   ///< Name of the first frame: name of the loop followed by "/first"
  std::string second;  ///< Name of the second frame: name of the loop followed by "/second"
  Directions directions = Directions::linear();
};

/// Attachment of the root link to the world.
/// @described model
enum class Base {
  Fixed,
  FreeFlyer,
};

/// Options for building a Model from a TreeSpec.
/// @described model
struct ModelOptions {
  Base base = Base::Fixed;
  /// Placement of the root link in the world @more For a free-flying base, the placement sets only
  /// the neutral configuration.
  Eigen::Isometry3d base_placement = Eigen::Isometry3d::Identity();
  /// Joints to lock @more Joints that are coupled to a locked joint (followers) are locked too. A
  /// joint is locked at its value in `posture`, or at zero if `posture` has no value for the joint.
  std::vector<std::string> locked;
  /// Joints that stay free; empty: all joints @more If the list is not empty, all other joints are
  /// locked. Exceptions are joints that are coupled to a listed joint (followers) and a free-flying
  /// base.
  std::vector<std::string> free;
  Posture posture;  ///< Positions of locked joints; values of moving joints are ignored

  /// Frames to add, in order @more The parent of a frame may be a frame earlier in the list.
  std::vector<FrameSpec> frames;
  Eigen::Vector3d gravity = Eigen::Vector3d(0.0, 0.0, -9.81);  ///< Gravity [m/s^2]
  bool strict = false;  ///< Treat warnings about the robot's description as errors
};

/// An immutable robot, prepared for computation. A Model is cheap to move and safe to share between
/// threads. Position vectors have nq entries. Velocity and torque vectors have nv entries. Limits
/// that the robot's description does not state are infinite.
struct Model {
  std::string name;
  /// Moving joints in depth-first order. TreeSpec::sibling_order states the order of joints with
  /// the same parent link: by name, or as in the description. For MJCF, the joints are in MuJoCo's
  /// order.
  std::vector<Joint> joints;
  std::vector<Frame> frames;
  std::vector<Visual> visuals;
  std::vector<Loop> loops;  ///< Loops that close kinematic chains, in the description's order
  int nq = 0;
  int nv = 0;
  Eigen::Vector3d gravity;

  /// Neutral configuration: zero positions, unit quaternions, base at base_placement
  Eigen::VectorXd q_neutral;
  Eigen::VectorXd q_lower, q_upper;
  Eigen::VectorXd velocity_limit, effort_limit;
  Eigen::VectorXd damping, friction, armature;
  /// Stiffness [Nm/rad or N/m] and rest position [rad or m] of the springs in joints, nv entries
  /// each. The rest position of a ball joint's spring is 0.
  Eigen::VectorXd stiffness, spring_rest;
  std::vector<Tendon> tendons;  ///< Tendons with a spring or damper, along moving joints

  /// For each entry of v, the index of the joint that has this entry.
  std::vector<int> joint_of_v;
  /// For each entry of v, the index of its parent in a tree of all entries; -1 at the root. Entries
  /// of one joint form a chain. The entry of a leader can move bodies on several branches of the
  /// robot. The tree is built such that any two entries that move a common body are on one path to
  /// the root.
  std::vector<int> parent_of_v;

  /// Returns the indices of the entries of v that move body `body`, in ascending order. Returns an
  /// empty span for the world (-1).
  std::span<const int> support(int body) const;
  /// Returns the name of entry k of v: the name of its joint, followed by ".vx" ... ".wz" if the
  /// joint has several entries.
  std::string v_name(int k) const;
  /// Returns the name of entry k of q: the name of its joint, followed by ".x" ... ".qw", ".cos" or
  /// ".sin" if the joint has several entries.
  std::string q_name(int k) const;

  /// Returns the index of a frame. If a link and a joint both have this name, returns the frame of
  /// the link. Throws Error with the nearest known name if there is no such frame.
  int frame_index(std::string_view frame_name) const;
  /// Returns the index of a moving joint. Throws Error if the joint is locked, or if it does not
  /// exist (with the nearest known name).
  int joint_index(std::string_view joint_name) const;
  bool has_frame(std::string_view frame_name) const;

  /// Returns the total mass of all moving bodies [kg], without links that are fixed to the world.
  double total_mass() const;

  /// Names of the locked joints, which can move in the description but not in the model
  std::vector<std::string> locked_joints;

  /// All joints that can move according to the description, in the order of `joints`. Coupled
  /// joints (followers) and held joints are included. JointOrder converts vectors with entries for
  /// all of file_joints.
  std::vector<FileJoint> file_joints;
  /// Warnings about odd but usable content of the description, one sentence each. Warnings of the
  /// TreeSpec come first. Further warnings report inertias that no solid has, joints that move no
  /// mass, and implausible values.
  std::vector<std::string> warnings;
  std::vector<std::string> notes;  ///< Notes of the TreeSpec on content without effect on dynamics

  /// Storage of support(). The entries of body b begin at index support_begin[b] of support_entries
  /// and end before index support_begin[b + 1].
  std::vector<int> support_entries, support_begin;
};

/// Builds a Model from a description. Throws Error with the source, the element and the reason. All
/// problems of the tree are listed in one Error.
///
/// Problems of the tree are
///  - no links, more than 2000 links, or a depth of more than 500 links;
///  - names that are empty, used twice or unknown;
///  - two roots, a link with two parents, or a cycle;
///  - numbers that are not finite;
///  - negative masses, moments of inertia, velocity or effort limits, damping, friction, armature
///    or stiffness;
///  - inertias that are not symmetric;
///  - axes of zero length (other axes are normalized);
///  - lower limits above upper limits.
///
/// Warnings, which ModelOptions::strict turns into errors, are
///  - implausible values, such as values in a wrong unit (docs/robots.md);
///  - inertias that no solid has: the largest principal moment exceeds the sum of the other two by
///    more than 5 % of the largest (published values are rounded);
///  - joints that move no mass at any posture and have no armature (Status::SingularMass);
///  - position limits of ball joints, and springs in planar and floating joints; both are ignored.
///
/// A loop NAME adds two frames, NAME/first and NAME/second. Each frame is fixed to a link or to the
/// world. A loop causes an error if it has no name, no directions or an unknown link, if another
/// loop has the same name, or if both of its links are the same. If no joint between the two links
/// moves, the links are one body. The loop is then removed if it is closed to 1 mm and 0.1 degrees
/// along its directions, and causes an error if it is not.
///
/// Position limits apply to revolute and prismatic joints only. The other limits, damping, friction
/// and armature of a planar, floating or ball joint apply to each entry of v.
///
/// A mimic joint becomes a follower (Joint::follows). If the leader is a mimic joint too, the
/// follower is coupled to the leader's own leader instead. Follower and leader must have one
/// coordinate each. If the follower or the leader is continuous, the multiplier must be a whole
/// number, since an angle on the circle has no other multiples. A prismatic joint cannot follow a
/// continuous joint.
///
/// A follower has no motor. The effort limit and friction of a follower are multiplied by
/// |multiplier| and added to the values of the leader. Damping and armature are multiplied by
/// multiplier^2 and added. The position and velocity limits of the leader are narrowed to satisfy
/// the limits of both joints. It is an error if no position remains. Position limits of a follower
/// are ignored if the follower or the leader is continuous.
///
/// If the leader is locked or fixed, the follower is held at the position that the coupling
/// requires. A follower that is itself listed as locked is held at its value in the posture. If the
/// posture has no value for the follower, the leader must be locked too, and the coupling
/// determines the position.
///
/// The dynamics exclude damping, friction, springs in joints, and springs and dampers of tendons.
/// Their torques are RigidBody::passive_torque, which the caller adds. A spring of stiffness k in a
/// joint has the torque -k (q - rest). For a continuous joint, q - rest is the shorter angle. For a
/// ball joint, the torque is -k log(q). The spring of a follower acts at the leader, with its
/// stiffness times multiplier^2. If this leader is continuous, the multiplier must be 1 or -1, and
/// the springs in both joints must rest at the same angle. A spring in a locked joint has no
/// effect.
///
/// A held tendon has a constant length, which couples two joints: the second joint becomes a
/// follower of the first joint. If only the first joint can follow, the roles are exchanged.
/// A held tendon causes an error if it couples only one joint, or more than two joints that are not
/// locked.
///
/// A tendon causes an error if one of its joints is unknown or has several coordinates. A tendon
/// with a spring also causes an error if one of its joints is continuous, since an angle on the
/// circle has no length.
Model build_model(const TreeSpec& tree, const ModelOptions& options = {});

/// Returns a posture as a configuration (nq entries). Joints without a value stay at their neutral
/// position. Values of locked joints, and of "root_joint" on a fixed base, are ignored. Throws
/// Error for an unknown name or a wrong number of values.
///
/// A coupled joint (follower) can have a value while its leader has none. The leader's value is
/// then computed from the follower's value. Exception: a continuous leader stays at its neutral
/// position. Throws Error if the values of follower and leader violate the coupling by more than
/// 1e-3 (files are rounded).
Eigen::VectorXd configuration(const Model& model, const Posture& posture);

}  // namespace burnish
