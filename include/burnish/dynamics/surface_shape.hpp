// Surfaces of exact shapes, through a point: how far others are from them, and how they bend there.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "burnish/dynamics/quadric.hpp"

namespace burnish {

/// The signed distance of a point to a surface, and its first two derivatives by the point, in the
/// axes that the point is given in.
struct SurfaceDistance {
  double distance = 0.0;                              ///< m, above zero outside of the material
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< of length one
  /// of the distance by the point twice, 1/m, in the point's axes; symmetric, zero along the normal
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();

  /// The surface that is `offset` m outside, to second order at x: of which the centre of a round
  /// tip of that radius is a point while the tip touches.
  Quadric quadric(const Eigen::Vector3d& x, double offset) const;
};

/// What a surface is beyond a point of it and its normal there: the lengths and angles of a shape
/// that touches the tangent plane at that point.
/// @described contact
struct SurfaceShape {
  /// What a surface is beyond a point of it and its normal there.
  /// @described contact.SurfaceKind
  enum class Kind {
    Plane,
    Sphere,
    Cylinder,   ///< its axis along the first tangent
    Cone,       ///< opening along the first tangent
    Torus,      ///< the outside of a ring that runs along the first tangent
    Ellipsoid,  ///< at the end of its third semi-axis
    Saddle,     ///< of any two curvatures along the tangents
    Ridge,      ///< two planes that meet in an edge across the first tangent
  };
  Kind kind = Kind::Plane;  ///< plane, sphere, cylinder, cone, torus, ellipsoid, saddle or ridge
  /// [m]: of a sphere; of a cylinder; of a cone, from the point to its axis along the normal; of
  /// the tube of a torus, > 0
  double radius = 0.3;
  double ring = 0.5;        ///< [m], of the circle that the tube of a torus runs along, > 0
  double half_angle = 0.3;  ///< [rad], of a cone, > 0
  /// [m], of an ellipsoid, along the tangents and the normal
  Eigen::Vector3d semi_axes = {0.4, 0.3, 0.3};
  /// [1/m], of a saddle: its height over the tangents is (k_0 x^2 + k_1 y^2) / 2
  Eigen::Vector2d curvature = {1.0, -1.0};
  double edge = 0.03;   ///< [m], of a ridge: from the point to its edge along the first tangent
  double slope = 0.1;   ///< [rad], of a ridge: by which its second plane falls off behind the edge
  bool hollow = false;  ///< the material is outside: the tool works in it, as in a bowl
  double turn_deg = 0.0;  ///< by which the shape is turned about the normal, degrees

  bool is_flat() const { return kind == Kind::Plane; }
  /// Throws Error("<who>: ...") for a length or an angle that makes no such shape.
  void check(const std::string& who) const;
  /// Such as "sphere of radius 0.3 m".
  std::string text() const;
  /// Reads "sphere:0.3" or "torus:0.1:0.5:hollow": a kind, its numbers or none of them (of a sphere
  /// or cylinder its radius; of a cone radius and half angle; of a torus radius and ring; of an
  /// ellipsoid three semi-axes; of a saddle two curvatures), and whether it is hollow. Throws Error
  /// with the nearest known kind, and as check() does.
  static SurfaceShape parse(const std::string& text);
};

std::string name_of(SurfaceShape::Kind kind);
std::vector<std::string> surface_kinds();  ///< names of all, in their order

/// A shape in its place. No call allocates. A ridge has an edge: its normal turns at once where its
/// planes meet, and outside around the edge itself; hollow, as a valley, its second plane rises.
class Surface {
 public:
  Surface() : Surface(SurfaceShape{}, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()) {}
  /// Through `point` with this normal there, of any length, out of the material; tangents are those
  /// of Reference::surface_with_normal(). Throws Error as SurfaceShape::check() does.
  Surface(const SurfaceShape& shape, const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

  const SurfaceShape& shape() const { return shape_; }
  /// Where it is itself: the middle of a sphere, an ellipsoid or a torus, a point of a cylinder's
  /// axis, a cone's apex, the point else; and its axes there, of which the third is that of a
  /// cylinder, a cone or a torus. m.
  const Eigen::Vector3d& center() const { return center_; }
  const Eigen::Matrix3d& axes() const { return axes_; }
  /// Of what is nearest to a point. Of ellipsoids and saddles by Newton's method, which finds the
  /// nearest for points about as near as the least radius of curvature.
  SurfaceDistance at(const Eigen::Vector3d& x) const noexcept;
  /// The point of the surface that stands over x along the normal at its point, or under it: the
  /// nearest along that line.
  Eigen::Vector3d along_normal(const Eigen::Vector3d& x) const noexcept;
  /// Largest curvature towards the tip, 1/m: a tip of a larger radius than 1 / that does not fit.
  double most_concave() const;

 private:
  SurfaceShape shape_;
  Eigen::Vector3d center_;  ///< of what the shape is about
  Eigen::Matrix3d axes_;    ///< its own: columns
  Eigen::Vector3d point_, normal_;
};

}  // namespace burnish
