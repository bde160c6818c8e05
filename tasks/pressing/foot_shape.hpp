// Size and place of one foot, from its solids or from its mass.
#pragma once

#include <optional>
#include <vector>

#include "burnish/robots/robot.hpp"

namespace burnish::pressing {

/// Collision solids of these bodies; where those have no primitive, primitives of their visuals.
std::vector<Visual> solids_of(const Robot& robot, const std::vector<int>& bodies);

/// Whether a body is on a joint without limits where others of its leg have them, as a wheel is:
/// some files state no limits at all.
bool turns_freely(const Model& model, int body);

/// Height of the lowest point of a solid [m] along z of `R`, solid placed by `in_axes` in the axes
/// of `R`. Infinite for meshes.
double lowest_of(const Shape& shape, const Eigen::Isometry3d& in_axes);

/// Rectangle that touches level ground.
struct SoleShape {
  Eigen::Vector3d centre;  ///< on the ground [m]
  double half_x, half_y;   ///< [m]
};
/// A solid in the axes that the result is wanted in.
struct PlacedShape {
  Shape shape;
  Eigen::Isometry3d at;
};
/// Rectangle around what lies within a few millimetres of the lowest point of `solids`; nothing
/// where that is shorter or narrower than `least` [m].
std::optional<SoleShape> sole_of(const std::vector<PlacedShape>& solids, double least);

/// The sphere that is lowest, as a ball: its centre [m] and radius [m]. Nothing where another solid
/// reaches lower.
struct BallShape {
  Eigen::Vector3d centre;
  double radius;
};
std::optional<BallShape> ball_of(const std::vector<PlacedShape>& solids);

/// Full sides [m] of the box of uniform density with this mass [kg] and inertia about its centre
/// [kg m^2], whose sides lie along the axes of `inertia`; zero where no box has them.
Eigen::Vector3d box_of(double mass, const Eigen::Matrix3d& inertia);

}  // namespace burnish::pressing
