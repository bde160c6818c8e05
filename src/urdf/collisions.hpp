// Collision geometry of a URDF file. Dynamics and drawings do not use it.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Solid that represents a link in collisions.
struct LinkSolid {
  std::string link;
  Shape shape;
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< Placement in the link's frame
};

/// Returns the solids of all <collision> elements, in the order of the file. Solids that cannot be
/// read are left out. Throws Error if the text is not a URDF file.
std::vector<LinkSolid> parse_collisions(const std::string& xml, const std::string& source);

}  // namespace burnish
