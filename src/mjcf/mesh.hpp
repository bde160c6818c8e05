// Meshes of MJCF, where masses are computed from them.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/tree_spec.hpp"

namespace burnish::mjcf {

struct Triangles {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> faces;  ///< indices of vertices, against the clock from outside
};

/// Reads STL (binary or ASCII), OBJ or MuJoCo's MSH, by the file's ending. Throws Error where the
/// file cannot be read or holds no triangle; its formats are as published by their makers.
Triangles read_triangles(const std::filesystem::path& file);

/// The same from a text; `ending` as ".stl".
Triangles parse_triangles(const std::string& bytes, const std::string& ending,
                          const std::string& source);

/// What `inertia` of a mesh says.
enum class MeshInertia {
  Legacy,  ///< every triangle adds a tetrahedron with the centroid, whichever way it looks
  Exact,   ///< of what the triangles enclose
  Shell,   ///< of the triangles themselves
};

/// A mesh of density 1, kg/m^3 or kg/m^2: mass, centre and inertia in the mesh's axes.
/// Tetrahedra and triangles are summed in closed form, as MuJoCo does. Throws Error, called
/// `source`, where that comes to no mass.
InertiaSpec inertia_of(const Triangles& mesh, MeshInertia how, const std::string& source);

}  // namespace burnish::mjcf
