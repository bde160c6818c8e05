// Curved surfaces that references follow: the zeros of a quadratic function, as data.
#pragma once

#include <Eigen/Core>
#include <string>

namespace burnish {

/// A curved surface, where phi(x) = x^T Q x / 2 + b^T x + c is zero, phi growing out of the
/// material; x is a point in the axes of the frame that the surface is fixed in, m. References
/// follow its normals.
/// @described contact
/// Spheres, cylinders and cones are such functions, and so is every smooth surface to second order
/// near a point of it. A reference asks for the directions of phi alone: the normal n = grad phi /
/// |grad phi| and how it turns, at the tool's point. The centre of a round tip sees the normal of
/// the surface that is its radius away; for planes, spheres, cylinders and cones that is the same
/// function's.
struct Quadric {
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();  ///< symmetric
  Eigen::Vector3d b = Eigen::Vector3d::UnitZ();
  double c = 0.0;

  // Makers throw Error for what is no such shape: a NaN, a length that is not positive, a direction
  // of none, axes that are no rotation. Points and axes are in the frame's axes, m.

  /// Through a point, with a normal of any length out of the material.
  static Quadric plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
  /// Material inside, or outside of a hollow one: then the normal is towards the centre.
  static Quadric sphere(const Eigen::Vector3d& center, double radius, bool hollow = false);
  static Quadric cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius,
                          bool hollow = false);
  /// Material about the axis, on both sides of the apex; half_angle between axis and surface, rad.
  static Quadric cone(const Eigen::Vector3d& apex, const Eigen::Vector3d& axis, double half_angle,
                      bool hollow = false);
  /// semi_axes along the columns of `axes`, m.
  static Quadric ellipsoid(const Eigen::Vector3d& center, const Eigen::Matrix3d& axes,
                           const Eigen::Vector3d& semi_axes, bool hollow = false);
  /// What a surface is to second order at one of its points: its height along the normal, the third
  /// column of `axes`, is (k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2 over the first two. 1/m; -1/R for
  /// a ball of radius R, above zero where it is a bowl, of both signs for a saddle.
  static Quadric osculating(const Eigen::Vector3d& point, const Eigen::Matrix3d& axes, double k_xx,
                            double k_xy, double k_yy);

  /// phi in its own unit; to first order the distance, m, beside the surface of what the makers
  /// above make, but for cones and ellipsoids.
  double value(const Eigen::Vector3d& x) const;
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const { return Q * x + b; }
  /// Unit length. Throws Error where the gradient is zero, as on the axis of a cylinder.
  Eigen::Vector3d normal(const Eigen::Vector3d& x) const;
  bool is_finite() const;
  /// Throws Error("<who>: ...") unless all is finite and Q symmetric, and not everything is zero.
  void check(const std::string& who) const;
};

}  // namespace burnish
