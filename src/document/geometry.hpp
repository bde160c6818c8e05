// Rotations and placements as texts state them.
#pragma once

#include <string>
#include <vector>

#include "document/reader.hpp"

namespace burnish::document {

/// {xyz: [m]} and one of {rpy: [rad]}, {quaternion: [x, y, z, w]} and {matrix: three rows}; both
/// are optional. `also`: further keys that the map may have.
Eigen::Isometry3d read_placement(const Reader& reader, const std::vector<std::string>& also = {});
/// {rpy: ...}, {quaternion: ...} or {matrix: ...}, or four numbers.
Eigen::Quaterniond read_rotation(const Reader& reader);
/// Columns of the axes that a map's key rpy, quaternion or matrix states, or the identity. A matrix
/// is not rounded.
Eigen::Matrix3d axes_in(const Reader& reader);

}  // namespace burnish::document
