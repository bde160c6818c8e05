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
/// Origin of a frame from that of a reference, in the axes that its rotation is fixed in, m; its
/// tool is the frame, its base the world. Throws Error with the nearest known name.
Eigen::Vector3d position_here(const Model& model, const Eigen::VectorXd& q,
                              const std::string& frame, const Reference& reference);

}  // namespace burnish::files
