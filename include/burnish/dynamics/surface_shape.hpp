// Surfaces of exact shapes (sphere, cone, torus, ...) through a given point: distances, normals and
// curvatures.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/dynamics/quadric.hpp"

namespace burnish {

/// Signed distance of a point from a surface, with first and second derivatives with respect to the
/// point. Vectors and matrices are in the axes in which the point is given.
struct SurfaceDistance {
  double distance = 0.0;  ///< Distance, positive outside the material [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Gradient of the distance, a unit vector

  /// Second derivative of the distance [1/m]; symmetric, zero along the normal
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();

  /// Returns the parallel surface at a distance of `offset` [m] outside the material, exact to
  /// second order at x. x must be the point for which this SurfaceDistance was computed. Example:
  /// while a round tip of radius `offset` touches the surface, the centre of the tip is on the
  /// parallel surface.
  Quadric quadric(const Eigen::Vector3d& x, double offset) const;
};

/// Shape of a surface near a given point: kind, lengths and angles. The two axes of the tangent
/// plane at this point are called first and second tangent.
/// @described contact
struct SurfaceShape {
  /// Kinds of surface shapes. First and second tangent are the two axes of the tangent plane at the
  /// given point.
  /// @described contact.SurfaceKind
  enum class Kind {
    Plane,
    Sphere,
    Cylinder,   ///< Cylinder with its axis along the first tangent
    Cone,       ///< Cone that opens along the first tangent
    Torus,      ///< Outside of a torus; the ring runs along the first tangent
    Ellipsoid,  ///< Ellipsoid, touched at the end of its third semi-axis
    Saddle,     ///< Surface with a given curvature along each tangent
    Ridge,      ///< Two planes that meet in an edge perpendicular to the first tangent
  };
  /// Kind of shape: plane, sphere, cylinder, cone, torus, ellipsoid, saddle or ridge
  Kind kind = Kind::Plane;
  /// Radius of a sphere, cylinder, torus tube, or cone at the given point [m], > 0 @more For a
  /// cone, the radius is the distance from the point to the axis, along the normal.
  double radius = 0.3;
  double ring = 0.5;  ///< Radius of a torus from its centre to the middle of the tube [m], > 0
  double half_angle = 0.3;  ///< Angle between the axis and the surface of a cone [rad], > 0

  /// Semi-axes of an ellipsoid, along the two tangents and the normal [m]
  Eigen::Vector3d semi_axes = {0.4, 0.3, 0.3};
  /// Curvatures of a saddle along the tangents [1/m] @more The height of the saddle is (k_0 x^2 +
  /// k_1 y^2) / 2, with the curvatures k_0 and k_1 and distances x and y along the tangents.
  Eigen::Vector2d curvature = {1.0, -1.0};
  /// Distance from the given point to the edge of a ridge, along the first tangent [m]
  double edge = 0.03;
  /// Downward slope of a ridge's second plane, behind the edge [rad]
  double slope = 0.1;
  /// Whether the material is outside the shape: the tool works inside, as in a bowl
  bool hollow = false;
  double turn_deg = 0.0;  ///< Rotation of the shape about the normal [degrees]

  bool is_flat() const { return kind == Kind::Plane; }
  /// Throws Error if a length or an angle is invalid for this kind of shape. The message begins
  /// with `who`.
  void check(const std::string& who) const;
  /// Returns a text such as "sphere of radius 0.3 m".
  std::string text() const;
  /// Parses a text such as "sphere", "sphere:0.3" or "torus:0.1:0.5:hollow": the name of a kind,
  /// optionally followed by the numbers of this kind and by "hollow". The numbers are
  ///  - sphere, cylinder: radius;
  ///  - cone: radius, half angle;
  ///  - torus: radius, ring;
  ///  - ellipsoid: three semi-axes;
  ///  - saddle: two curvatures;
  ///  - ridge: edge, slope.
  /// Throws Error if check() rejects the numbers, or with the nearest known kind if the kind is
  /// unknown.
  static SurfaceShape parse(const std::string& text);
};

std::string name_of(SurfaceShape::Kind kind);
std::vector<std::string> surface_kinds();  ///< Names of all kinds, in the order of the enumeration

/// A SurfaceShape placed in space, by a point of the surface and the normal at that point. No
/// member function allocates memory.
///
/// The normal of a ridge jumps at the edge, from one plane to the other. For a point outside the
/// material, the nearest point of the surface can be on the edge. The normal then points from the
/// edge to the outside point. A hollow ridge is a valley: the second plane rises.
class Surface {
 public:
  Surface() : Surface(SurfaceShape{}, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()) {}
  /// Places `shape` so that the surface passes through `point` with the normal `normal`. `normal`
  /// points out of the material and need not have unit length. The tangents are the x and y axes of
  /// Reference::surface_with_normal(), turned about the normal by `shape.turn_deg`. Throws Error if
  /// SurfaceShape::check() rejects the shape, or for a normal of zero length.
  Surface(const SurfaceShape& shape, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  const SurfaceShape& shape() const { return shape_; }
  /// Returns the centre of the shape [m]. For a cylinder, this is a point on the axis; for a cone,
  /// the apex. For a plane, saddle or ridge, it is the point passed to the constructor.
  const Eigen::Vector3d& center() const { return center_; }
  /// Returns the axes of the shape as columns. The third column is the axis of a cylinder, cone or
  /// torus.
  const Eigen::Matrix3d& axes() const { return axes_; }
  /// Returns the signed distance of x from the surface, with derivatives. For an ellipsoid or a
  /// saddle, the nearest point of the surface is computed by Newton's method. Newton's method
  /// converges if x is closer to the surface than about the smallest radius of curvature.
  SurfaceDistance at(const Eigen::Vector3d& x) const noexcept;
  /// Returns the intersection of the surface with a line through x. The line is parallel to the
  /// normal that was passed to the constructor. If there are several intersections, returns the one
  /// nearest to the tangent plane at the constructor's `point`.
  Eigen::Vector3d along_normal(const Eigen::Vector3d& x) const noexcept;
  /// Returns the largest concave curvature of the surface [1/m], or 0 if the surface is nowhere
  /// concave. The radius of a round tip that touches the surface must not exceed the inverse of
  /// this curvature. For a solid torus, the inner side around the hole does not count.
  double max_concavity() const;

 private:
  SurfaceShape shape_;
  Eigen::Vector3d center_;  ///< Centre of the shape
  Eigen::Matrix3d axes_;    ///< Axes of the shape, as columns
  Eigen::Vector3d point_, normal_;
};

}  // namespace burnish
