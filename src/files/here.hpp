// Where things are at the start: what the word `here` stands for.
#pragma once

#include "burnish/dynamics/reference.hpp"
#include "burnish/model/model.hpp"

namespace burnish::files {

/// 3 entries, world, m.
Eigen::VectorXd center_of_mass(const Model& model, const Eigen::VectorXd& q);
/// Position of a frame (3) and quaternion (4): world.
Eigen::VectorXd placement_here(const Model& model, const Eigen::VectorXd& q,
                               const std::string& frame);
/// Quaternion (4) of a frame's rotation from the axes of a reference of one time, whose tool is the
/// frame and whose base is the world. Throws Error with the nearest known name.
Eigen::VectorXd rotation_here(const Model& model, const Eigen::VectorXd& q,
                              const std::string& frame, const Reference& reference);
/// The two kinds of coordinates of a cost of a frame's position, at one configuration.
struct PositionAxes {
  Eigen::Isometry3d numbers;  ///< coordinates of targets -> world
  Eigen::Matrix3d rows;       ///< axes of the residual's rows -> world
};
/// Axes of residual::FramePosition of a frame, in a reference of one time, at `q`. Throws Error
/// with the nearest known name.
PositionAxes position_axes(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference);

/// Target of a frame's position that leaves the frame where it is.
struct PositionHere {
  Eigen::Vector3d target;   ///< [m]
  Eigen::Matrix3d offsets;  ///< axes of the residual's rows -> coordinates of targets
};
PositionHere position_here(const Model& model, const Eigen::VectorXd& q, const std::string& frame,
                           const Reference& reference);

}  // namespace burnish::files
