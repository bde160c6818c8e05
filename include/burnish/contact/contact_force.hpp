// Contact force with the two bodies on which it acts, and with the Reference that defines its axes.
#pragma once

#include <string>

#include "burnish/contact/contact.hpp"

namespace burnish {

/// Wrench that the base of a contact exerts on the tool, at one state of the robot.
/// @described contact @result
struct ContactForce {
  std::string contact;  ///< Name of the contact
  std::string on;       ///< Name of the tool frame C2; the force acts on the tool's body

  /// Name of the base frame C1; the base's body exerts the force ("world": the environment)
  std::string by;
  Reference reference;  ///< Origin and axes in which `value` is written
  Vector6 value;        ///< Force (N), then moment about the origin of the reference (Nm)

  /// Rotation matrix from tool axes to world axes @note All rotations and positions in this struct
  /// are those at which the force was computed. From these values, in() converts the force without
  /// access to the robot.
  Eigen::Matrix3d tool_rotation;
  Eigen::Matrix3d base_rotation;  ///< Rotation matrix from base axes to world axes
  Eigen::Vector3d tool_position;  ///< Position of the tool frame in the world [m]

  /// Position of the base frame in the world [m]
  Eigen::Vector3d base_position = Eigen::Vector3d::Zero();
  /// Rotation matrix from the axes of the frame `reference.axes` to world axes
  Eigen::Matrix3d frame_rotation = Eigen::Matrix3d::Identity();
  /// Position of the reference's origin in the world [m]
  Eigen::Vector3d frame_position = Eigen::Vector3d::Zero();

  /// Returns this wrench, written in the reference `other`. Throws Error if `other` names a frame
  /// whose pose this ContactForce does not store. For such a frame, use
  /// ContactDynamics::force(contact, reference), which knows the poses of all frames of the robot.
  ContactForce in(const Reference& other) const;

  /// Returns the rotation matrix from the axes of the reference to world axes.
  Eigen::Matrix3d axes() const;
  Eigen::Vector3d origin() const;  ///< Returns the reference's origin in the world [m]

  /// Returns the force as text, such as "30.0 N along +z of the world, on tool, by the world, at
  /// the tool's origin".
  std::string text() const;
};

}  // namespace burnish
