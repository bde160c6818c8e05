// A contact force that says what it is: on which body, by which, at which point, in which axes.
#pragma once

#include <string>

#include "burnish/contact/contact.hpp"

namespace burnish {

/// The wrench that the base exerts on the tool, at one state.
/// @described contact @result
struct ContactForce {
  std::string contact;  ///< name of the contact
  std::string on;       ///< tool frame C2: the body acted on
  std::string by;       ///< base frame C1: the body that acts, "world" for the environment
  Reference reference;  ///< in which `value` is written
  Vector6 value;        ///< force (N), then moment about the reference's origin (Nm)
  /// world axes, at that state @note With these poses the force converts itself. `frame` is the
  /// one that `reference` names: rotation of its axes' frame, position of its origin's.
  Eigen::Matrix3d tool_rotation;
  Eigen::Matrix3d base_rotation;
  Eigen::Vector3d tool_position;  ///< [m]
  Eigen::Vector3d base_position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d frame_rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d frame_position = Eigen::Vector3d::Zero();

  /// The same wrench written in another reference. Throws Error where that names a frame: ask
  /// ContactDynamics::force(contact, reference), which knows where frames are.
  ContactForce in(const Reference& other) const;

  /// Rotation of the reference's axes to the world, and its origin in the world.
  Eigen::Matrix3d axes() const;
  Eigen::Vector3d origin() const;

  /// A sentence: "30.0 N along +z of the world, on tool, by the world, at the tool's origin".
  std::string text() const;
};

}  // namespace burnish
