// Settings of <compiler>, and placements of MJCF elements.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "mjcf/item.hpp"

namespace burnish::mjcf {

enum class InertiaFromGeom { No, Yes, Auto };

/// Settings of <compiler>. If a file has several <compiler> elements, later ones override earlier
/// ones.
struct Compiler {
  bool degrees = true;
  /// Euler axes in sequence; small letters rotate with the body, capitals are fixed
  std::string euler = "xyz";
  bool autolimits = true;
  bool strip_paths = false;
  bool balance_inertia = false;
  /// Whether mesh inertia is exact by default (an attribute of files before MuJoCo 3.2.5)
  bool exact_meshes = false;
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::Auto;
  double min_mass = 0.0;                ///< Smallest mass of a body [kg]
  double min_inertia = 0.0;             ///< Smallest principal moment of a body [kg m^2]
  double total_mass = -1.0;             ///< Prescribed total mass [kg]; not positive: no scaling
  int first_group = 0, last_group = 5;  ///< First and last group of geoms with mass
  std::string mesh_folder;              ///< Folder of meshes, from `meshdir`, else from `assetdir`

  /// Reads a <compiler> element. Throws Error for global coordinates and for unknown values.
  void read(const XMLElement& element);

  double angle(double stated) const;  ///< Converts an angle of the file to [rad]
};

/// Returns the rotation from quat, axisangle, xyaxes, zaxis or euler; the identity if the item has
/// none of these attributes. The element itself has priority over its class. Throws Error for two
/// of the attributes in one element, and for values that are not a rotation.
Eigen::Matrix3d orientation_of(const Item& item, const Compiler& compiler);

/// Returns the placement from `pos` and orientation_of().
Eigen::Isometry3d placement_of(const Item& item, const Compiler& compiler);

/// Returns the shortest rotation that takes z to a direction of any length.
Eigen::Matrix3d rotation_to(const Eigen::Vector3d& z);

/// Returns the rotation of a quaternion w, x, y, z of any length. Throws Error if all numbers are
/// zero.
Eigen::Quaterniond quaternion_of(const std::vector<double>& wxyz, const XMLElement& stating);

}  // namespace burnish::mjcf
