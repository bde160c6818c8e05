#include "mjcf/solid.hpp"

#include <cmath>
#include <numbers>

namespace burnish::mjcf {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

Vector3d about_z(double across, double along) { return {across, across, along}; }

/// Returns, for each entry, the sum of the two other entries. For a box with half lengths h,
/// others(h^2) / 3 are the moments divided by the mass.
Vector3d others(const Vector3d& x) { return Vector3d::Constant(x.sum()) - x; }

/// Moments of a capsule's two caps (half spheres, filled or hollow), divided by the capsule's mass.
/// Each cap is moved outwards by h along z. `fraction`: mass of the caps / mass of the capsule.
/// `own`: moment of a sphere / its mass. `lever`: distance of a cap's centre of mass from its cut.
Vector3d caps(double fraction, double own, double lever, double h) {
  const double out = h + lever;
  return fraction * about_z(own + out * out - lever * lever, own);
}

Vector3d capsule(const Solid& solid) {
  const double r = solid.size[0], h = solid.size[1], r2 = r * r;
  if (solid.is_shell) {
    const double fraction = 2.0 * r / (2.0 * r + 2.0 * h);  // Caps 4 pi r^2, wall 4 pi r h
    return caps(fraction, 2.0 * r2 / 3.0, 0.5 * r, h) +
           (1.0 - fraction) * about_z(0.5 * r2 + h * h / 3.0, r2);
  }
  const double fraction = 4.0 * r / (4.0 * r + 6.0 * h);  // Caps 4/3 pi r^3, wall 2 pi r^2 h
  return caps(fraction, 0.4 * r2, 0.375 * r, h) +
         (1.0 - fraction) * about_z(0.25 * r2 + h * h / 3.0, 0.5 * r2);
}

Vector3d cylinder(const Solid& solid) {
  const double r = solid.size[0], h = solid.size[1], r2 = r * r;
  if (!solid.is_shell) return about_z(0.25 * r2 + h * h / 3.0, 0.5 * r2);
  const double lids = r / (r + 2.0 * h);  // Areas: lids 2 pi r^2, wall 4 pi r h
  return lids * about_z(0.25 * r2 + h * h, 0.5 * r2) +
         (1.0 - lids) * about_z(0.5 * r2 + h * h / 3.0, r2);
}

Vector3d ellipsoid(const Solid& solid) {
  const Vector3d inner = solid.size;
  if (!solid.is_shell) return others(inner.cwiseAbs2()) / 5.0;
  const Vector3d outer = inner.array() + 1e-6;
  const double a = inner.prod(), b = outer.prod();
  return (b * others(outer.cwiseAbs2()) - a * others(inner.cwiseAbs2())) / (5.0 * (b - a));
}

Vector3d box(const Solid& solid) {
  const Vector3d h2 = solid.size.cwiseAbs2();
  if (!solid.is_shell) return others(h2) / 3.0;
  // Mean square of each coordinate on the surface: mean over the faces, weighted by their areas.
  const Vector3d& h = solid.size;
  const Vector3d area(h[1] * h[2], h[2] * h[0], h[0] * h[1]);
  Vector3d mean = Vector3d::Zero();
  for (int face = 0; face < 3; ++face)
    for (int axis = 0; axis < 3; ++axis)
      mean[axis] += area[face] / area.sum() * (axis == face ? 1.0 : 1.0 / 3.0) * h2[axis];
  return others(mean);
}

Eigen::Matrix3d moved(const InertiaSpec& body, const Vector3d& to) {
  const Vector3d arm = body.com - to;
  return body.inertia_at_com +
         body.mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
}

}  // namespace

double extent_of(const Solid& solid) {
  const double a = solid.size[0], b = solid.size[1], c = solid.size[2];
  switch (solid.kind) {
    case Primitive::Sphere:
      return solid.is_shell ? 4.0 * pi * a * a : 4.0 / 3.0 * pi * a * a * a;
    case Primitive::Capsule:
      return solid.is_shell ? 4.0 * pi * a * (a + b) : pi * a * a * (2.0 * b + 4.0 / 3.0 * a);
    case Primitive::Cylinder:
      return solid.is_shell ? 2.0 * pi * a * (a + 2.0 * b) : 2.0 * pi * a * a * b;
    case Primitive::Ellipsoid: {
      if (!solid.is_shell) return 4.0 / 3.0 * pi * a * b * c;
      constexpr double p = 1.6075;
      const double mean = (std::pow(a * b, p) + std::pow(b * c, p) + std::pow(c * a, p)) / 3.0;
      return 4.0 * pi * std::pow(mean, 1.0 / p);
    }
    case Primitive::Box:
      return 8.0 * (solid.is_shell ? a * b + b * c + c * a : a * b * c);
  }
  return 0.0;
}

Vector3d moments_over_mass(const Solid& solid) {
  switch (solid.kind) {
    case Primitive::Sphere:
      return Vector3d::Constant((solid.is_shell ? 2.0 / 3.0 : 0.4) * solid.size[0] * solid.size[0]);
    case Primitive::Capsule:
      return capsule(solid);
    case Primitive::Cylinder:
      return cylinder(solid);
    case Primitive::Ellipsoid:
      return ellipsoid(solid);
    case Primitive::Box:
      return box(solid);
  }
  return Vector3d::Zero();
}

InertiaSpec together(const InertiaSpec& a, const InertiaSpec& b) {
  InertiaSpec sum;
  sum.mass = a.mass + b.mass;
  if (sum.mass > 0.0) sum.com = (a.mass * a.com + b.mass * b.com) / sum.mass;
  sum.inertia_at_com = moved(a, sum.com) + moved(b, sum.com);
  return sum;
}

}  // namespace burnish::mjcf
