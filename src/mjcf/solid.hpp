// Mass and inertia of the primitive shapes of MJCF.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "burnish/model/tree_spec.hpp"

namespace burnish::mjcf {

enum class Primitive { Sphere, Capsule, Cylinder, Ellipsoid, Box };

/// Primitive shape, filled or as a shell.
struct Solid {
  Primitive kind = Primitive::Sphere;
  /// Sizes as in MJCF [m]: radius; or radius and half length along z (for a capsule, without its
  /// caps); or half lengths along x, y, z.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  bool is_shell = false;
};

/// Returns the volume [m^3], or the area of a shell [m^2] (ellipsoid: Thomsen's formula, p =
/// 1.6075).
double extent_of(const Solid& solid);

/// Returns the principal moments about the centre along x, y and z, divided by the mass [m^2]. The
/// shell of an ellipsoid is the volume between two ellipsoids 1e-6 m apart, as in MuJoCo.
Eigen::Vector3d moments_over_mass(const Solid& solid);

/// Returns the combined inertia of two bodies that are given in one frame.
InertiaSpec together(const InertiaSpec& a, const InertiaSpec& b);

}  // namespace burnish::mjcf
