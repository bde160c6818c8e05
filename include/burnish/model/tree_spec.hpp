// A robot as its description file states it: links, joints and shapes as plain values, before a
// base is chosen or any joint is locked. model.hpp compiles it.
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

/// Mass distribution of a link, in the link's axes.
/// @described model
struct InertiaSpec {
  double mass = 0.0;                                         ///< [kg]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();             ///< [m], from the link's origin
  Eigen::Matrix3d inertia_at_com = Eigen::Matrix3d::Zero();  ///< [kg m^2], about com, link axes
};

/// A box.
/// @described model
struct BoxShape {
  Eigen::Vector3d size;  ///< [m], full lengths along x, y, z @required
};
/// A cylinder.
/// @described model
struct CylinderShape {
  double radius;  ///< [m] @required
  double length;  ///< [m], along z, centred @required
};
/// A sphere.
/// @described model
struct SphereShape {
  double radius;  ///< [m] @required
};
/// A mesh is kept for drawing only.
/// @described model
/// Dynamics never opens it.
struct MeshShape {
  std::string uri;        ///< as written in the file, `package://` included @required
  Eigen::Vector3d scale;  ///< per axis @required
};
using Shape = std::variant<BoxShape, CylinderShape, SphereShape, MeshShape>;

/// One solid to draw, attached to a link.
/// @described model
struct VisualSpec {
  Shape shape;                                                  ///< @required
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< in the link's frame
  Eigen::Vector4d rgba = Eigen::Vector4d(0.7, 0.7, 0.7, 1.0);
};

/// A body of a robot, as its description has it.
/// @described model
struct LinkSpec {
  std::string name;  ///< @required
  InertiaSpec inertia;
  std::vector<VisualSpec> visuals;
  int line = 0;  ///< of the file, for sentences about it; 0: none
};

/// Joints as a description has them.
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

/// A joint that copies another: q = multiplier * q_leader + offset.
/// @described model
struct MimicSpec {
  std::string leader;  ///< @required
  double multiplier = 1.0;
  double offset = 0.0;
};

/// A joint of a robot, as its description has it.
/// @described model
struct JointSpec {
  std::string name;  ///< @required
  JointType type = JointType::Fixed;
  std::string parent_link;
  std::string child_link;
  /// Of the child link's frame in the parent link's frame when the joint is at zero.
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  /// Unit axis in the child link's frame (for Planar the normal of the plane).
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double lower = -std::numeric_limits<double>::infinity();          ///< [rad] or m
  double upper = std::numeric_limits<double>::infinity();           ///< [rad] or m
  double velocity_limit = std::numeric_limits<double>::infinity();  ///< [rad/s] or m/s
  double effort_limit = std::numeric_limits<double>::infinity();    ///< [Nm] or N
  double damping = 0.0;                                             ///< {Nms/rad} or Ns/m
  double friction = 0.0;                                            ///< [Nm] or N, Coulomb
  double armature = 0.0;                                            ///< [kg m^2] or kg
  double stiffness = 0.0;  ///< of a spring in the joint, {Nm/rad} or N/m
  double rest = 0.0;       ///< where that spring is at rest, {rad} or m; a ball's is at no rotation
  std::optional<MimicSpec> mimic;
  /// Value of a fixed joint that moves in the description and is held there, as equalities of MJCF
  /// hold hinges and slides, {rad} or m; empty of others.
  std::vector<double> held;
  int line = 0;  ///< of the file, for sentences about it; 0: none
};

/// A frame to add while compiling.
/// @described model
struct FrameSpec {
  std::string name;    ///< @required
  std::string parent;  ///< name of an existing frame @required
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< in the parent frame
};

/// Values of joints by name: one entry per coordinate of the joint (URDF coordinates: an angle for
/// a continuous joint; x, y, z and a quaternion x, y, z, w for a floating one, the quaternion alone
/// for a ball; x, y, angle for a planar one). The free-flyer base goes by "root_joint".
using Posture = std::map<std::string, std::vector<double>>;

/// Two links tied to each other along some directions: what closes a chain. Relative motion of the
/// second frame seen from the first, in the first one's axes, is held to none.
/// @described model
struct LoopSpec {
  std::string name;                                          ///< @required
  std::string first_link;                                    ///< or "world" @required
  std::string second_link;                                   ///< or "world" @required
  Eigen::Isometry3d first = Eigen::Isometry3d::Identity();   ///< frame in the first link
  Eigen::Isometry3d second = Eigen::Isometry3d::Identity();  ///< frame in the second link
  /// "linear", "all", or names separated by commas such as "x,y,z,rx,rz"
  Directions directions = Directions::linear();
  int line = 0;  ///< of the file, for sentences about it; 0: none
};

/// A fixed tendon: joints coupled by its length, the sum of coefficient times position over them.
/// @described model
struct TendonSpec {
  /// A joint that a tendon goes along.
  /// @described model.TendonPart
  struct Part {
    std::string joint;         ///< @required
    double coefficient = 1.0;  ///< [m/rad] or 1
  };
  std::string name;  ///< @required
  std::vector<Part> parts;
  bool held = false;       ///< the length stays at `rest`
  double rest = 0.0;       ///< [m], where it is held or its spring is at rest
  double stiffness = 0.0;  ///< [N/m]
  double damping = 0.0;    ///< {Ns/m}
  int line = 0;            ///< of the file, for sentences about it; 0: none
};

/// Order in a Model of joints that share a parent link.
/// @described model
enum class SiblingOrder {
  ByName,
  AsListed,
};

/// A robot as its description states it: links and joints as plain values. build_model() compiles
/// it.
/// @described model
/// A tree of links. Valid when every joint names known links, each link but one has exactly one
/// parent joint and there is no cycle; build_model checks this and says what is wrong.
struct TreeSpec {
  std::string name;    ///< of the robot
  std::string source;  ///< file it was read from, used in error sentences; may be empty
  std::vector<LinkSpec> links;
  std::vector<JointSpec> joints;
  /// Order in the Model of joints that share a parent link: by name as of URDF, or as in `joints`,
  /// as of MJCF.
  SiblingOrder sibling_order = SiblingOrder::ByName;
  std::vector<LoopSpec> loops;
  std::vector<TendonSpec> tendons;
  std::vector<FrameSpec> frames;            ///< that the file names beside links and joints
  std::map<std::string, Posture> postures;  ///< that the file names
  std::optional<Eigen::Vector3d> gravity;   ///< [m/s^2], where the file states it
  /// What was odd about the file but stopped nothing, one sentence each; a Model gets them too.
  std::vector<std::string> warnings;
  /// What the file holds beside that which is passed over without changing dynamics, one sentence
  /// each: no oddity, so that strict reading bears it. A Model gets them too.
  std::vector<std::string> notes;
};

}  // namespace burnish
