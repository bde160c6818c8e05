// Mass and inertia of the primitive shapes of MJCF.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "burnish/model/tree_spec.hpp"

namespace burnish::mjcf {

enum class Primitive { Sphere, Capsule, Cylinder, Ellipsoid, Box };

/// What is filled, or whose surface alone has a mass.
struct Solid {
  Primitive kind = Primitive::Sphere;
  /// As MJCF states it, m: radius; radius and half the length along z, of a capsule without its
  /// caps; half lengths along x, y, z.
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  bool is_shell = false;
};

/// Volume in m^3, or of a shell area in m^2 (of an ellipsoid by Thomsen's formula, p = 1.6075).
double extent_of(const Solid& solid);

/// Principal moments about the centre over the mass, along x, y and z, m^2. Of an ellipsoid's shell
/// as MuJoCo has it: between two ellipsoids 1e-6 m apart.
Eigen::Vector3d moments_over_mass(const Solid& solid);

/// The two of one, about the origin of what both are placed in.
InertiaSpec together(const InertiaSpec& a, const InertiaSpec& b);

}  // namespace burnish::mjcf
