// Meshes of MJCF and their mass, centre of mass and inertia.
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
  /// Indices of vertices, counterclockwise seen from outside
  std::vector<std::array<int, 3>> faces;
};

/// Reads STL (binary or ASCII), OBJ or MuJoCo's MSH, depending on the file extension. Throws Error
/// if the file cannot be read or contains no triangle.
Triangles read_triangles(const std::filesystem::path& file);

/// Reads triangles from the bytes of a file; `ending` is the extension, such as ".stl".
Triangles parse_triangles(const std::string& bytes, const std::string& ending,
                          const std::string& source);

/// Method for the inertia of a mesh.
enum class MeshInertia {
  Legacy,  ///< Sum of the absolute volumes of tetrahedra from the centroid to each triangle
  Exact,   ///< Mass fills the enclosed volume
  Shell,   ///< Mass lies on the surface
};

/// Returns mass, centre of mass and inertia in the mesh's axes for density 1 kg/m^3 (1 kg/m^2 for
/// Shell). Tetrahedra and triangles are integrated in closed form, as in MuJoCo. Throws Error, with
/// `source` in the message, if the mass is not positive.
InertiaSpec inertia_of(const Triangles& mesh, MeshInertia how, const std::string& source);

}  // namespace burnish::mjcf
