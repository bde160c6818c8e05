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
/// Origin of a frame from that of a reference, in the axes that its rotation is fixed in, m; its
/// tool is the frame, its base the world. Throws Error with the nearest known name.
Eigen::Vector3d position_here(const Model& model, const Eigen::VectorXd& q,
                              const std::string& frame, const Reference& reference);

}  // namespace burnish::files
