// Collision geometry of a URDF file. No dynamics and no drawing needs it.
#pragma once

#include <string>
#include <vector>

#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// One solid that stands for a link in collisions.
struct LinkSolid {
  std::string link;
  Shape shape;
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();  ///< in the link's frame
};

/// Solids of all <collision> elements, in the order of the file. Solids that cannot be read are
/// left out. Throws Error for a text that is not a URDF file.
std::vector<LinkSolid> parse_collisions(const std::string& xml, const std::string& source);

}  // namespace burnish
