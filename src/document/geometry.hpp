// Reads rotations and placements from YAML or JSON.
#pragma once

#include <string>
#include <vector>

#include "document/reader.hpp"

namespace burnish::document {

/// Reads a map with the optional key xyz [m] and at most one of the keys rpy [rad], quaternion
/// (x, y, z, w) and matrix (three rows). `also` lists further allowed keys.
Eigen::Isometry3d read_placement(const Reader& reader, const std::vector<std::string>& also = {});
/// Reads {rpy: ...}, {quaternion: ...} or {matrix: ...}, or a list of four numbers (x, y, z, w).
Eigen::Quaterniond read_rotation(const Reader& reader);
/// Returns the rotation of the key rpy, quaternion or matrix of a map, or the identity without such
/// a key. The entries of a matrix are returned unchanged.
Eigen::Matrix3d axes_in(const Reader& reader);

}  // namespace burnish::document
