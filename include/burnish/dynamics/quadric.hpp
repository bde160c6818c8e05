// Curved surfaces as zeros of a quadratic function. The axes of a Reference can follow such a
// surface.
#pragma once

#include <Eigen/Core>
#include <string>

namespace burnish {

/// A curved surface: all points x with phi(x) = 0, where phi(x) = x^T Q x / 2 + b^T x + c. phi is
/// positive outside the material. x is a point [m] in the frame to which the surface is fixed. The
/// axes of a Reference can follow the normal of the surface.
/// @described contact
/// Planes, spheres, cylinders and cones are represented exactly. Every other smooth surface can be
/// approximated to second order near a point. A Reference uses the normal n = grad phi / |grad phi|
/// at the tool's point, and the derivatives of n. It does not use the value of phi.
///
/// For a round tip, the tool's point is the centre of the tip. While the tip touches the surface,
/// the centre moves on a parallel surface, one radius outside the material. For planes, spheres and
/// cylinders, the normals of the touched surface and of the parallel surface agree at the centre.
/// phi of either surface can then be used.
struct Quadric {
  Eigen::Matrix3d Q = Eigen::Matrix3d::Zero();   ///< Matrix of the quadratic term, symmetric
  Eigen::Vector3d b = Eigen::Vector3d::UnitZ();  ///< Vector of the linear term
  double c = 0.0;                                ///< Constant term

  // Functions that create a Quadric from a shape. Points [m] and axes are in the frame to which the
  // surface is fixed. The functions throw Error for a NaN, a length that is not positive, a
  // direction of length zero, and axes that are not a rotation matrix.

  /// Returns the plane through `point`. `normal` points out of the material and need not have unit
  /// length.
  static Quadric plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
  /// Returns a sphere with the material inside. If hollow, the material is outside, and the normal
  /// points to the centre.
  static Quadric sphere(const Eigen::Vector3d& center, double radius, bool hollow = false);
  /// Returns a cylinder with the material inside. The axis is the line through `point` in the
  /// direction `axis`. If hollow, the material is outside.
  static Quadric cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius,
                          bool hollow = false);
  /// Returns a double cone about `axis`, with the material inside on both sides of the apex. If
  /// hollow, the material is outside. `half_angle` is the angle between the axis and the surface
  /// [rad], above 0 and below 1.57.
  static Quadric cone(const Eigen::Vector3d& apex, const Eigen::Vector3d& axis, double half_angle,
                      bool hollow = false);
  /// Returns an ellipsoid with the material inside. The semi-axes have the directions of the
  /// columns of `axes` and the lengths `semi_axes` [m]. If hollow, the material is outside.
  static Quadric ellipsoid(const Eigen::Vector3d& center, const Eigen::Matrix3d& axes,
                           const Eigen::Vector3d& semi_axes, bool hollow = false);
  /// Returns a Quadric that approximates a surface to second order at `point`. The height of this
  /// surface along the normal is (k_xx x^2 + 2 k_xy x y + k_yy y^2) / 2. x and y are coordinates
  /// along the first two columns of `axes`; the third column is the normal. The curvatures k_xx,
  /// k_xy, k_yy are in 1/m: -1/R for a ball of radius R, positive for a bowl, of both signs for a
  /// saddle.
  static Quadric osculating(const Eigen::Vector3d& point, const Eigen::Matrix3d& axes, double k_xx,
                            double k_xy, double k_yy);

  /// Returns phi(x). If the quadric is a result of plane(), sphere(), cylinder() or osculating(),
  /// phi(x) is the distance of x from the surface to first order [m]. If it is a result of cone()
  /// or ellipsoid(), phi(x) is not a distance.
  double value(const Eigen::Vector3d& x) const;
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const { return Q * x + b; }
  /// Returns the unit normal at x. Throws Error if the gradient is zero, for example on the axis of
  /// a cylinder.
  Eigen::Vector3d normal(const Eigen::Vector3d& x) const;
  bool is_finite() const;
  /// Throws Error if an entry is not finite, if Q is not symmetric, or if Q and b are zero. The
  /// message begins with `who`.
  void check(const std::string& who) const;
};

}  // namespace burnish
