// Size and position of a foot, from its solids or from its mass and inertia.
#pragma once

#include <optional>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::pressing {

/// Returns the collision primitives of the bodies; if there are none, the visual primitives of the
/// bodies.
std::vector<Visual> solids_of(const Robot& robot, const std::vector<int>& bodies);

/// Returns whether a body turns about a joint without limits, as a wheel does. Another joint of the
/// leg must have limits, so that files without any limits are excluded.
bool turns_freely(const Model& model, int body);

/// Returns the smallest z coordinate of a solid [m]; infinite for meshes. `in_axes`: placement of
/// the solid.
double lowest_of(const Shape& shape, const Eigen::Isometry3d& in_axes);

/// Rectangle that touches level ground.
struct SoleShape {
  Eigen::Vector3d centre;  ///< Centre on the ground [m].
  double half_x, half_y;   ///< Half sides [m].
};
/// Solid with its placement in the axes in which the foot is computed.
struct PlacedShape {
  Shape shape;
  Eigen::Isometry3d at;
};
/// Returns the rectangle around all points of `solids` that are at most 6 mm above the lowest
/// point. Returns nothing if a side of the rectangle is shorter than `min_side` [m].
std::optional<SoleShape> sole_of(const std::vector<PlacedShape>& solids, double min_side);

/// Sphere of a point foot.
struct BallShape {
  Eigen::Vector3d centre;  ///< Centre [m].
  double radius;           ///< Radius [m].
};
/// Returns the lowest of `solids` if it is a sphere, else nothing.
std::optional<BallShape> ball_of(const std::vector<PlacedShape>& solids);

/// Returns the sides of a box of uniform density, along the axes of `inertia` [m]. The box has the
/// given mass [kg] and inertia about its centre [kg m^2]. A side is zero if no box has this
/// inertia.
Eigen::Vector3d box_of(double mass, const Eigen::Matrix3d& inertia);

}  // namespace burnish::pressing
