// How the numbers of an MJCF file are meant, and placements in it.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "mjcf/item.hpp"

namespace burnish::mjcf {

enum class InertiaFromGeom { No, Yes, Auto };

/// What <compiler> says; of several the later go before.
struct Compiler {
  bool degrees = true;
  std::string euler = "xyz";  ///< small letters: axes that turn along; capitals: fixed ones
  bool autolimits = true;
  bool strip_paths = false;
  bool balance_inertia = false;
  bool exact_meshes = false;  ///< as files before MuJoCo 3.2.5 say it for all meshes at once
  InertiaFromGeom inertia_from_geom = InertiaFromGeom::Auto;
  double least_mass = 0.0;              ///< kg
  double least_inertia = 0.0;           ///< kg m^2
  double total_mass = -1.0;             ///< kg; not positive: as stated
  int first_group = 0, last_group = 5;  ///< of geoms that have a mass
  std::string mesh_folder;              ///< of `meshdir`, or else of `assetdir`

  /// Throws Error for global coordinates and for what is none of the known words.
  void read(const XMLElement& element);

  double angle(double stated) const;  ///< rad
};

/// The rotation that quat, axisangle, xyaxes, zaxis or euler states; the identity where none of
/// them does. What the element states itself goes before its class. Throws Error for two of them,
/// and for what is no rotation.
Eigen::Matrix3d orientation_of(const Item& item, const Compiler& compiler);

/// `pos` with orientation_of.
Eigen::Isometry3d placement_of(const Item& item, const Compiler& compiler);

/// The shortest rotation that takes z to a direction, which need not be of unit length.
Eigen::Matrix3d rotation_to(const Eigen::Vector3d& z);

/// A rotation by four numbers w, x, y, z. Throws Error where they are all zero.
Eigen::Quaterniond quaternion_of(const std::vector<double>& wxyz, const XMLElement& stating);

}  // namespace burnish::mjcf
