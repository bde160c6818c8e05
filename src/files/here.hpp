// Positions and rotations at the start, which the word `here` stands for in files.
#pragma once

#include "burnish/dynamics/reference.hpp"
#include "burnish/model/model.hpp"

namespace burnish::files {

/// Position of the centre of mass in the world, 3 entries [m].
Eigen::VectorXd center_of_mass(const Model& model, const Eigen::VectorXd& q);
/// Position (3) [m] and quaternion (4) of a frame in the world.
Eigen::VectorXd placement_here(const Model& model, const Eigen::VectorXd& q,
                               const std::string& frame);
/// Quaternion (4) of a frame's rotation relative to the axes of `reference`, the reference of a
/// cost at one time. Its tool is the frame, and its base is the world. Throws Error with the
/// nearest known name.
Eigen::VectorXd rotation_here(const Model& model, const Eigen::VectorXd& q,
                              const std::string& frame, const Reference& reference);
/// Coordinates of the target and axes of the residual in a cost of a frame's position.
struct PositionAxes {
  Eigen::Isometry3d numbers;  ///< from coordinates of targets to the world
  Eigen::Matrix3d rows;       ///< from axes of the residual's rows to the world
};
/// Coordinates and axes of residual::FramePosition at `q`; `reference` is that of the cost at one
/// time. Throws Error with the nearest known name.
PositionAxes position_axes(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference);

/// Target of a frame's position with zero residual at one configuration.
struct PositionHere {
  Eigen::Vector3d target;   ///< [m]
  Eigen::Matrix3d offsets;  ///< from axes of the residual's rows to coordinates of targets
};
PositionHere position_here(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference);

}  // namespace burnish::files
