// Contents of a robot's description file: links, joints and shapes as plain values. build_model()
// in model.hpp compiles them to a Model. ModelOptions select the base and the locked joints.
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "burnish/model/directions.hpp"

namespace burnish {

/// Mass distribution of a link, in the axes of the link.
/// @described model
struct InertiaSpec {
  double mass = 0.0;                              ///< Mass [kg]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();  ///< Centre of mass [m]

  /// Inertia about the centre of mass, in the axes of the link [kg m^2]
  Eigen::Matrix3d inertia_at_com = Eigen::Matrix3d::Zero();
};

/// A box.
/// @described model
struct BoxShape {
  Eigen::Vector3d size;  ///< Full lengths along x, y and z [m] @required
};
/// A cylinder.
/// @described model
struct CylinderShape {
  double radius;  ///< Radius [m] @required
  double length;  ///< Length along z, with the origin in the middle [m] @required
};
/// A sphere.
/// @described model
struct SphereShape {
  double radius;  ///< Radius [m] @required
};
/// A mesh file, used for drawing only.
/// @described model
/// Dynamics computations do not open the file.
struct MeshShape {
  std::string uri;        ///< File name as in the description, including `package://` @required
  Eigen::Vector3d scale;  ///< Scale factors along the axes @required
};
using Shape = std::variant<BoxShape, CylinderShape, SphereShape, MeshShape>;

/// A solid shape to draw, attached to a link.
/// @described model
struct VisualSpec {
  Shape shape;  ///< @required

  /// Placement of the shape in the frame of the link
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  /// Colour: red, green, blue, opacity
  Eigen::Vector4d rgba = Eigen::Vector4d(0.7, 0.7, 0.7, 1.0);
};

/// A link (rigid body) of a robot, as its description states it.
/// @described model
struct LinkSpec {
  std::string name;  ///< @required
  InertiaSpec inertia;
  std::vector<VisualSpec> visuals;
  int line = 0;  ///< Line in the description file, for messages about the link; 0: unknown
};

/// Types of joints in a robot description.
/// @described model
enum class JointType {
  Fixed,
  Revolute,
  Continuous,
  Prismatic,
  Planar,
  Floating,
  Ball,
};

/// Coupling of a joint to another joint, the leader: q = multiplier * q_leader + offset. q is the
/// position of the joint, and q_leader is the position of the leader.
/// @described model
struct MimicSpec {
  std::string leader;  ///< @required
  double multiplier = 1.0;
  double offset = 0.0;
};

/// A joint of a robot, as its description states it.
/// @described model
struct JointSpec {
  std::string name;  ///< @required
  JointType type = JointType::Fixed;
  std::string parent_link;
  std::string child_link;
  /// Placement of the child link's frame in the parent link's frame, at joint position zero
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  /// Unit axis of the joint in the child link's frame; for a planar joint, normal of the plane
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double lower = -std::numeric_limits<double>::infinity();  ///< Lower position limit [rad] or [m]
  double upper = std::numeric_limits<double>::infinity();   ///< Upper position limit [rad] or [m]

  /// Velocity limit [rad/s] or [m/s]
  double velocity_limit = std::numeric_limits<double>::infinity();
  /// Torque or force limit [Nm] or [N]
  double effort_limit = std::numeric_limits<double>::infinity();
  double damping = 0.0;    ///< Viscous friction [Nm s/rad] or [Ns/m]
  double friction = 0.0;   ///< Coulomb friction [Nm] or [N]
  double armature = 0.0;   ///< Inertia of the motor, reflected to the joint [kg m^2] or [kg]
  double stiffness = 0.0;  ///< Stiffness of a spring in the joint [Nm/rad] or [N/m]

  /// Rest position of the joint's spring [rad] or [m] @more Ignored for a ball joint. The spring of
  /// a ball joint is at rest without rotation.
  double rest = 0.0;
  std::optional<MimicSpec> mimic;
  /// Constant position of a held joint [rad] or [m]; empty for other joints @more An equality
  /// constraint of MJCF can hold a hinge or slide joint. A held joint has the type Fixed.
  std::vector<double> held;
  int line = 0;  ///< Line in the description file, for messages about the joint; 0: unknown
};

/// A named frame to add when the Model is built.
/// @described model
struct FrameSpec {
  std::string name;    ///< @required
  std::string parent;  ///< Name of an existing frame @required
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< Placement in the parent frame
};

/// Joint positions by joint name, in URDF's coordinates [rad, m]. A revolute, prismatic or
/// continuous joint has one number. A planar joint has x, y, angle. A ball joint has a quaternion
/// x, y, z, w. A floating joint has x, y, z and a quaternion x, y, z, w. The name "root_joint"
/// stands for the free-flying base.
using Posture = std::map<std::string, std::vector<double>>;

/// A constraint between two links that closes a kinematic chain. A frame is fixed to each link. The
/// constraint prevents relative motion of the two frames along `directions`, in the axes of the
/// first frame.
/// @described model
struct LoopSpec {
  std::string name;         ///< @required
  std::string first_link;   ///< Name of the first link, or "world" @required
  std::string second_link;  ///< Name of the second link, or "world" @required

  /// Placement of the first frame in the first link
  Eigen::Isometry3d first = Eigen::Isometry3d::Identity();
  /// Placement of the second frame in the second link
  Eigen::Isometry3d second = Eigen::Isometry3d::Identity();
  /// Constrained directions: "linear", "all", or names separated by commas such as "x,y,z,rx,rz"
  Directions directions = Directions::linear();
  int line = 0;  ///< Line in the description file, for messages about the loop; 0: unknown
};

/// A tendon that couples joints, such as a fixed tendon of MuJoCo. The length of the tendon is the
/// sum of coefficient * position over the joints.
/// @described model
struct TendonSpec {
  /// A joint along a tendon, with the coefficient of its position in the tendon's length.
  /// @described model.TendonPart
  struct Part {
    std::string joint;  ///< @required

    /// Tendon length per joint position [m/rad]; dimensionless for a prismatic joint
    double coefficient = 1.0;
  };
  std::string name;  ///< @required
  std::vector<Part> parts;
  bool held = false;       ///< Whether a constraint holds the length at `rest`
  double rest = 0.0;       ///< Length of a held tendon, or rest length of the spring [m]
  double stiffness = 0.0;  ///< Stiffness of the tendon's spring [N/m]
  double damping = 0.0;    ///< Damping of the tendon's length [Ns/m]
  int line = 0;  ///< Line in the description file, for messages about the tendon; 0: unknown
};

/// Order of joints with the same parent link in a Model.
/// @described model
enum class SiblingOrder {
  ByName,
  AsListed,
};

/// A robot as its description states it: links and joints as plain values. build_model() compiles a
/// TreeSpec to a Model.
/// @described model
/// The links form a tree. Every joint names existing links, and every link except the root has
/// exactly one parent joint. There is no cycle. build_model() checks these conditions and reports
/// violations.
struct TreeSpec {
  std::string name;    ///< Name of the robot
  std::string source;  ///< File that the robot was read from, for error messages; may be empty
  std::vector<LinkSpec> links;
  std::vector<JointSpec> joints;
  /// Order of joints with the same parent link in the Model @more For URDF, joints are sorted by
  /// name. For MJCF, joints are in the order of `joints`.
  SiblingOrder sibling_order = SiblingOrder::ByName;
  std::vector<LoopSpec> loops;
  std::vector<TendonSpec> tendons;

  /// Named frames of the file other than frames of links and joints
  std::vector<FrameSpec> frames;
  std::map<std::string, Posture> postures;  ///< Named postures of the file
  std::optional<Eigen::Vector3d> gravity;   ///< Gravity, if stated in the file [m/s^2]

  /// Warnings about odd but usable content of the file, one sentence each @more The warnings are
  /// copied to the Model.
  std::vector<std::string> warnings;
  /// Notes on ignored content of the file that does not affect dynamics, one sentence each @more
  /// The notes are copied to the Model. Strict loading does not reject such content.
  std::vector<std::string> notes;
};

}  // namespace burnish
