// Positions and rotations in the starting configuration: the meaning of the word `here` in files.
#pragma once

#include "burnish/dynamics/reference.hpp"
#include "burnish/model/model.hpp"

namespace burnish::files {

/// Returns the position of the centre of mass in the world, 3 entries [m].
Eigen::VectorXd center_of_mass(const Model& model, const Eigen::VectorXd& q);
/// Returns the position (3) [m] and the quaternion (4) of a frame in the world.
Eigen::VectorXd placement_here(const Model& model, const Eigen::VectorXd& q,
                               const std::string& frame);
/// Returns the quaternion (4) of a frame's rotation relative to the axes of `reference`, whose
/// rotation must be constant. In `reference`, `tool` means this frame, and `base` means the world.
/// Throws Error with the nearest known name.
Eigen::VectorXd rotation_here(const Model& model, const Eigen::VectorXd& q,
                              const std::string& frame, const Reference& reference);
/// Axes for a cost on the position of a frame: coordinates of the target, and axes of the residual.
struct PositionAxes {
  Eigen::Isometry3d numbers;  ///< Transform from coordinates of targets to the world
  Eigen::Matrix3d rows;       ///< Rotation from axes of the residual's rows to the world
};
/// Returns the coordinates and axes of residual::FramePosition at `q`. The rotation of `reference`
/// must be constant. Throws Error with the nearest known name.
PositionAxes position_axes(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference);

/// Target for which the residual of a frame's position is zero at one configuration.
struct PositionHere {
  Eigen::Vector3d target;  ///< Target [m]
  /// Rotation from the axes of the residual's rows to the coordinates of targets
  Eigen::Matrix3d offsets;
};
PositionHere position_here(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference);

}  // namespace burnish::files
