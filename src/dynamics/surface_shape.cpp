#include "burnish/dynamics/surface_shape.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/base/error.hpp"
#include "burnish/dynamics/reference.hpp"
#include "dynamics/descriptions.gen.hpp"

namespace burnish {
namespace {

using Kind = SurfaceShape::Kind;
// Length [m] or gradient below which a direction is undefined, chosen by hand.
constexpr double tiny = 1e-12;

/// Distance of a point from an axis, unit vector `out` away from the axis, and unit vector `along`
/// around the axis. On the axis, `out` is arbitrary.
struct Around {
  double distance;
  Eigen::Vector3d out, along;
};
Around around_z(const Eigen::Vector3d& y) {
  const double distance = std::hypot(y.x(), y.y());
  const Eigen::Vector3d out = distance > tiny
                                  ? Eigen::Vector3d(y.x() / distance, y.y() / distance, 0.0)
                                  : Eigen::Vector3d::UnitX();
  return {std::max(distance, tiny), out, Eigen::Vector3d::UnitZ().cross(out)};
}

SurfaceDistance of_sphere(double radius, const Eigen::Vector3d& y) {
  const double length = std::max(y.norm(), tiny);
  const Eigen::Vector3d n =
      y.norm() > tiny ? Eigen::Vector3d(y / length) : Eigen::Vector3d::UnitZ();
  return {y.norm() - radius, n, (Eigen::Matrix3d::Identity() - n * n.transpose()) / length};
}

/// Distance from a cylinder about the z axis.
SurfaceDistance of_cylinder(double radius, const Eigen::Vector3d& y) {
  const Around at = around_z(y);
  return {at.distance - radius, at.out, at.along * at.along.transpose() / at.distance};
}

/// Distance from a double cone about the z axis, with its apex at the origin.
SurfaceDistance of_cone(double half_angle, const Eigen::Vector3d& y) {
  const Around at = around_z(y);
  const double c = std::cos(half_angle), s = std::sin(half_angle);
  const double side = y.z() < 0.0 ? -1.0 : 1.0;
  return {at.distance * c - std::abs(y.z()) * s, c * at.out - side * s * Eigen::Vector3d::UnitZ(),
          c / at.distance * at.along * at.along.transpose()};
}

/// Distance from a torus whose ring is a circle about the z axis.
SurfaceDistance of_torus(double ring, double radius, const Eigen::Vector3d& y) {
  const Around at = around_z(y);
  const double out = at.distance - ring;
  const double length = std::max(std::hypot(out, y.z()), tiny);
  const Eigen::Vector3d n = (out * at.out + y.z() * Eigen::Vector3d::UnitZ()) / length;
  const Eigen::Vector3d across = n.cross(at.along);
  return {length - radius, n,
          across * across.transpose() / length +
              out / (length * at.distance) * at.along * at.along.transpose()};
}

/// Surface F = 0 with F(x) = x^T A x / 2 + b^T x + c and a diagonal A. The point p of the surface
/// nearest to y satisfies y = p + m grad F(p) for a number m, so p(m) = (1 + m A)^-1 (y - m b).
/// Newton's method solves F(p(m)) = 0 for m, with dF/dm = -grad F^T (1 + m A)^-1 grad F.
SurfaceDistance of_quadric(const Eigen::Vector3d& A, const Eigen::Vector3d& b, double c,
                           const Eigen::Vector3d& y) {
  constexpr int max_iterations = 30;  // chosen by hand
  double m = 0.0;
  Eigen::Vector3d p = y, g = A.cwiseProduct(p) + b;
  for (int i = 0; i < max_iterations; ++i) {
    const Eigen::Vector3d scale = (1.0 + m * A.array()).max(1e-6).inverse();
    p = scale.cwiseProduct(y - m * b);
    g = A.cwiseProduct(p) + b;
    const double F = 0.5 * p.dot(A.cwiseProduct(p)) + b.dot(p) + c;
    const double slope = g.dot(scale.cwiseProduct(g));
    if (!(slope > tiny)) break;
    const double step = F / slope;
    m += step;
    if (std::abs(step) * g.norm() < 1e-15) break;
  }
  const double length = std::max(g.norm(), tiny);
  const Eigen::Vector3d n = g / length;
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - n * n.transpose();
  const Eigen::Matrix3d here = tangent * A.asDiagonal() * tangent / length;
  const double distance = n.dot(y - p);
  // Hessian of the distance on the parallel surface through y.
  const Eigen::Matrix3d there = (Eigen::Matrix3d::Identity() + distance * here).inverse() * here;
  return {distance, n, 0.5 * (there + there.transpose())};
}

/// Ridge: the plane z = 0 and, for x > edge, a plane that falls by the angle `slope`. The material
/// is below both planes. The nearest point is on one of the planes or on the edge.
SurfaceDistance of_ridge(double edge, double slope, const Eigen::Vector3d& y) {
  const double x = y.x() - edge, c = std::cos(slope), s = std::sin(slope);
  const double second = x * s + y.z() * c, along = x * c - y.z() * s;
  if (x > 0.0 && along < 0.0 && y.z() > 0.0) {  // nearest to the edge
    const double length = std::max(std::hypot(x, y.z()), tiny);
    const Eigen::Vector3d n = Eigen::Vector3d(x, 0.0, y.z()) / length;
    const Eigen::Vector3d around(n.z(), 0.0, -n.x());
    return {length, n, around * around.transpose() / length};
  }
  if (second > y.z()) return {second, {s, 0.0, c}, Eigen::Matrix3d::Zero()};
  return {y.z(), Eigen::Vector3d::UnitZ(), Eigen::Matrix3d::Zero()};
}

void check_length(const std::string& who, const char* what, double length) {
  if (!(length > 0.0) || !std::isfinite(length))
    throw Error(who + ": its " + what + " is " + number(length) + " m; wanted a positive number");
}

Eigen::Matrix3d turned_axes(const Eigen::Vector3d& normal, double turn_deg) {
  return Reference::surface_with_normal(normal).rotation *
         Eigen::AngleAxisd(turn_deg * std::numbers::pi / 180.0, Eigen::Vector3d::UnitZ())
             .toRotationMatrix();
}

}  // namespace

std::string name_of(Kind kind) { return words_of(kind).words[to_size(kind)].word; }
std::vector<std::string> surface_kinds() { return words_of(Kind{}).list(); }

namespace {
/// Returns pointers to the numbers of a shape, in the order of its text (after the kind's name).
std::vector<double*> stated_of(SurfaceShape& shape) {
  switch (shape.kind) {
    case Kind::Sphere:
    case Kind::Cylinder:
      return {&shape.radius};
    case Kind::Cone:
      return {&shape.radius, &shape.half_angle};
    case Kind::Torus:
      return {&shape.radius, &shape.ring};
    case Kind::Ellipsoid:
      return {&shape.semi_axes.x(), &shape.semi_axes.y(), &shape.semi_axes.z()};
    case Kind::Saddle:
      return {&shape.curvature.x(), &shape.curvature.y()};
    case Kind::Ridge:
      return {&shape.edge, &shape.slope};
    case Kind::Plane:
      break;
  }
  return {};
}
}  // namespace

SurfaceShape SurfaceShape::parse(const std::string& text) {
  const std::string who = "surface " + in_quotes(text);
  std::vector<std::string> pieces;
  std::istringstream stream(text);
  for (std::string piece; std::getline(stream, piece, ':');) pieces.push_back(piece);
  SurfaceShape shape;
  const std::string name = pieces.empty() ? "" : pieces.front();
  const std::vector<std::string> known = surface_kinds();
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end())
    throw Error(who + ": there is no shape " + in_quotes(name) +
                "; wanted a shape such as sphere:0.3" + did_you_mean(name, known));
  shape.kind = static_cast<Kind>(found - known.begin());
  shape.hollow = pieces.size() > 1 && pieces.back() == "hollow";
  const std::vector<double*> numbers = stated_of(shape);
  const std::size_t stated = pieces.size() - 1 - (shape.hollow ? 1 : 0);
  if (stated != 0 && stated != numbers.size())
    throw Error(who + ": " + name + " is followed by " + std::to_string(stated) +
                " numbers; wanted " + std::to_string(numbers.size()) + " or none");
  for (std::size_t i = 0; i < stated; ++i) {
    const std::optional<double> number = parse_number(pieces[i + 1]);
    if (!number)
      throw Error(who + ": " + in_quotes(pieces[i + 1]) +
                  " is not a number; wanted numbers as in " + name +
                  ":0.3 (with ':hollow' at the end if the tool touches the inner side)");
    *numbers[i] = *number;
  }
  shape.check(who);
  return shape;
}

Quadric SurfaceDistance::quadric(const Eigen::Vector3d& x, double offset) const {
  Quadric result{.Q = hessian, .b = normal - hessian * x};
  result.c = distance - offset - normal.dot(x) + 0.5 * x.dot(hessian * x);
  return result;
}

void SurfaceShape::check(const std::string& who) const {
  const std::string what = who + ": " + name_of(kind);
  if (!std::isfinite(turn_deg))
    throw Error(what + ": turn_deg is not finite; wanted a number in degrees");
  switch (kind) {
    case Kind::Plane:
      if (hollow) throw Error(what + ": a plane cannot be hollow");
      return;
    case Kind::Saddle:
      if (hollow)
        throw Error(what +
                    ": a saddle cannot be hollow; wanted hollow false, with the signs of both "
                    "curvatures changed for the opposite saddle");
      if (!curvature.allFinite())
        throw Error(what + ": its curvatures are not finite; wanted numbers in 1/m");
      return;
    case Kind::Ridge:
      if (!std::isfinite(edge))
        throw Error(what + ": the distance to its edge is not finite; wanted a number in m");
      if (!(slope > 0.0 && slope < 1.5))
        throw Error(what + ": its slope is " + number(slope) +
                    " rad; wanted above 0 and below 1.5 (if the surface rises behind the edge, "
                    "state a hollow ridge)");
      return;
    case Kind::Ellipsoid:
      for (const double length : semi_axes) check_length(what, "semi-axis", length);
      return;
    case Kind::Torus:
      check_length(what, "ring", ring);
      check_length(what, "radius", radius);
      if (!(radius < ring))
        throw Error(what + ": the radius of its tube is " + number(radius) +
                    " m; wanted less than the radius of its ring, " + number(ring) + " m");
      return;
    case Kind::Cone:
      if (!(half_angle > 0.0 && half_angle < 1.5))
        throw Error(what + ": its half angle is " + number(half_angle) +
                    " rad; wanted above 0 and below 1.5");
      check_length(what, "radius", radius);
      return;
    case Kind::Sphere:
    case Kind::Cylinder:
      check_length(what, "radius", radius);
  }
}

std::string SurfaceShape::text() const {
  const auto metres = [](double length) { return number(length) + " m"; };
  const std::string name = (hollow ? "hollow " : "") + name_of(kind);
  switch (kind) {
    case Kind::Sphere:
    case Kind::Cylinder:
      return name + " of radius " + metres(radius);
    case Kind::Cone:
      return name + " of half angle " + number(half_angle) + " rad, " + metres(radius) +
             " from its axis";
    case Kind::Torus:
      return name + " of radius " + metres(radius) + " along a ring of " + metres(ring);
    case Kind::Ellipsoid:
      return name + " of semi-axes " + number(semi_axes.x()) + ", " + number(semi_axes.y()) + ", " +
             metres(semi_axes.z());
    case Kind::Saddle:
      return name + " of curvatures " + number(curvature.x()) + ", " + number(curvature.y()) +
             " 1/m";
    case Kind::Ridge:
      return name + " that " + (hollow ? "rises" : "falls") + " by " + number(slope) +
             " rad behind an edge " + metres(edge) + " away";
    case Kind::Plane:
      break;
  }
  return name;
}

Surface::Surface(const SurfaceShape& shape, const Eigen::Vector3d& point,
                 const Eigen::Vector3d& normal)
    : shape_(shape), center_(point), axes_(turned_axes(normal, shape.turn_deg)), point_(point) {
  shape.check("the surface");
  normal_ = axes_.col(2);
  const Eigen::Vector3d x = axes_.col(0), y = axes_.col(1), n = normal_;
  const double into = shape.hollow ? -1.0 : 1.0;  // -1 if hollow: the centre is on the side of n
  switch (shape.kind) {
    case Kind::Plane:
    case Kind::Saddle:
      break;
    case Kind::Sphere:
      center_ -= into * shape.radius * n;
      break;
    case Kind::Cylinder:
      center_ -= into * shape.radius * n;
      axes_ << y, n, x;
      break;
    case Kind::Cone: {  // the cone's axis z is x, turned into the material by the half angle
      const double c = std::cos(shape.half_angle), s = std::sin(shape.half_angle);
      const Eigen::Vector3d z = c * x - into * s * n;
      center_ -= shape.radius / std::tan(shape.half_angle) * x;
      axes_ << y, z.cross(y), z;
      break;
    }
    case Kind::Torus:  // the given point is at the outer equator of the torus
      center_ -= into * (shape.ring + shape.radius) * n;
      axes_ << n, x, n.cross(x);
      break;
    case Kind::Ridge:
      if (shape.hollow) axes_ << x, -y, -n;
      break;
    case Kind::Ellipsoid:
      center_ -= into * shape.semi_axes.z() * n;
      break;
  }
}

SurfaceDistance Surface::at(const Eigen::Vector3d& x) const noexcept {
  const Eigen::Vector3d y = axes_.transpose() * (x - center_);
  SurfaceDistance result;
  switch (shape_.kind) {
    case Kind::Plane:
      result.distance = y.z();
      break;
    case Kind::Sphere:
      result = of_sphere(shape_.radius, y);
      break;
    case Kind::Cylinder:
      result = of_cylinder(shape_.radius, y);
      break;
    case Kind::Cone:
      result = of_cone(shape_.half_angle, y);
      break;
    case Kind::Torus:
      result = of_torus(shape_.ring, shape_.radius, y);
      break;
    case Kind::Ellipsoid: {
      const double shortest = shape_.semi_axes.minCoeff();
      result = of_quadric(shortest * shape_.semi_axes.array().square().inverse(),
                          Eigen::Vector3d::Zero(), -0.5 * shortest, y);
      break;
    }
    case Kind::Ridge:
      result = of_ridge(shape_.edge, shape_.slope, y);
      break;
    case Kind::Saddle:
      result = of_quadric({-shape_.curvature.x(), -shape_.curvature.y(), 0.0},
                          Eigen::Vector3d::UnitZ(), 0.0, y);
      break;
  }
  const double sign = shape_.hollow ? -1.0 : 1.0;
  return {sign * result.distance, sign * axes_ * result.normal,
          sign * axes_ * result.hessian * axes_.transpose()};
}

Eigen::Vector3d Surface::along_normal(const Eigen::Vector3d& x) const noexcept {
  constexpr int max_iterations = 50;  // chosen by hand
  constexpr double min_slope = 0.1;   // bounds the steps of Newton's method, chosen by hand
  Eigen::Vector3d p = x - normal_.dot(x - point_) * normal_;  // in the tangent plane
  for (int i = 0; i < max_iterations; ++i) {
    const SurfaceDistance here = at(p);
    const double slope = std::max(here.normal.dot(normal_), min_slope);
    p -= here.distance / slope * normal_;
    if (std::abs(here.distance) < 1e-14) break;
  }
  return p;
}

double Surface::max_concavity() const {
  switch (shape_.kind) {
    case Kind::Plane:
    case Kind::Ridge:  // a tip of any radius fits into a valley and touches both planes
      return 0.0;
    case Kind::Saddle:
      return std::max({0.0, shape_.curvature.x(), shape_.curvature.y()});
    case Kind::Torus:  // a solid torus is concave only around its hole, which paths do not reach
      return shape_.hollow ? 1.0 / shape_.radius : 0.0;
    case Kind::Ellipsoid: {
      const double longest = shape_.semi_axes.maxCoeff(), shortest = shape_.semi_axes.minCoeff();
      return shape_.hollow ? longest / (shortest * shortest) : 0.0;
    }
    case Kind::Sphere:
    case Kind::Cylinder:
    case Kind::Cone:
      return shape_.hollow ? 1.0 / shape_.radius : 0.0;
  }
  return 0.0;
}

}  // namespace burnish
