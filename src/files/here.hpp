// Where things are at the start: what the word `here` stands for.
#pragma once

#include "files/scene.hpp"

namespace burnish::files {

/// 3 entries, world, m.
Eigen::VectorXd center_of_mass(const Model& model, const Eigen::VectorXd& q);
/// Position of a frame (3) and quaternion (4): world.
Eigen::VectorXd placement_here(const Model& model, const Eigen::VectorXd& q,
                               const std::string& frame);

}  // namespace burnish::files
