#include "burnish/dynamics/quadric.hpp"

#include <cmath>

#include "base/sentence.hpp"
#include "burnish/base/error.hpp"
#include "dynamics/reference.hpp"

namespace burnish {
namespace {

Eigen::Vector3d unit(const Eigen::Vector3d& given, const std::string& what) {
  if (!given.allFinite() || !(given.norm() > 1e-9))
    throw Error(what + " is not finite or has length 0; wanted a direction");
  return given.normalized();
}

void check_point(const Eigen::Vector3d& point, const char* what) {
  if (!point.allFinite()) throw Error(std::string(what) + " holds a NaN or an infinity");
}

void check_length(double length, const char* what) {
  if (!(length > 0.0) || !std::isfinite(length))
    throw Error(std::string(what) + " is " + number(length) + " m; wanted a positive number");
}

/// Returns the quadric (x - center)^T M (x - center) / 2 - level. Its sign is reversed if hollow.
Quadric about(const Eigen::Vector3d& center, const Eigen::Matrix3d& M, double level, bool hollow) {
  const double sign = hollow ? -1.0 : 1.0;
  return {sign * M, -sign * M * center, sign * (0.5 * center.dot(M * center) - level)};
}

}  // namespace

Quadric Quadric::plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  check_point(point, "the plane's point");
  const Eigen::Vector3d n = unit(normal, "the plane's normal");
  return {Eigen::Matrix3d::Zero(), n, -n.dot(point)};
}

Quadric Quadric::sphere(const Eigen::Vector3d& center, double radius, bool hollow) {
  check_point(center, "the sphere's centre");
  check_length(radius, "the sphere's radius");
  return about(center, Eigen::Matrix3d::Identity() / radius, 0.5 * radius, hollow);
}

Quadric Quadric::cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius,
                          bool hollow) {
  check_point(point, "the cylinder's point");
  check_length(radius, "the cylinder's radius");
  const Eigen::Vector3d a = unit(axis, "the cylinder's axis");
  return about(point, (Eigen::Matrix3d::Identity() - a * a.transpose()) / radius, 0.5 * radius,
               hollow);
}

Quadric Quadric::cone(const Eigen::Vector3d& apex, const Eigen::Vector3d& axis, double half_angle,
                      bool hollow) {
  check_point(apex, "the cone's apex");
  if (!(half_angle > 0.0 && half_angle < 1.57))
    throw Error("the cone's half angle is " + number(half_angle) +
                " rad; wanted above 0 and below 1.57");
  const Eigen::Vector3d a = unit(axis, "the cone's axis");
  const double tangent = std::tan(half_angle);
  const Eigen::Matrix3d along = a * a.transpose();
  return about(apex, Eigen::Matrix3d::Identity() - along - tangent * tangent * along, 0.0, hollow);
}

Quadric Quadric::ellipsoid(const Eigen::Vector3d& center, const Eigen::Matrix3d& axes,
                           const Eigen::Vector3d& semi_axes, bool hollow) {
  check_point(center, "the ellipsoid's centre");
  if (!is_rotation(axes)) throw Error("the ellipsoid's axes are not a rotation matrix");
  for (const double semi_axis : semi_axes) check_length(semi_axis, "a semi-axis of the ellipsoid");
  const double shortest = semi_axes.minCoeff();
  const Eigen::Vector3d weights = shortest * semi_axes.array().square().inverse();
  return about(center, axes * weights.asDiagonal() * axes.transpose(), 0.5 * shortest, hollow);
}

Quadric Quadric::osculating(const Eigen::Vector3d& point, const Eigen::Matrix3d& axes, double k_xx,
                            double k_xy, double k_yy) {
  check_point(point, "the point of the surface");
  if (!is_rotation(axes)) throw Error("the surface's axes are not a rotation matrix");
  if (!std::isfinite(k_xx + k_xy + k_yy))
    throw Error("the surface's curvatures hold a NaN or an infinity");
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  hessian.topLeftCorner<2, 2>() << k_xx, k_xy, k_xy, k_yy;
  const Eigen::Matrix3d Q = -axes * hessian * axes.transpose();
  const Eigen::Vector3d n = axes.col(2);
  return {Q, n - Q * point, 0.5 * point.dot(Q * point) - n.dot(point)};
}

double Quadric::value(const Eigen::Vector3d& x) const { return 0.5 * x.dot(Q * x) + b.dot(x) + c; }

Eigen::Vector3d Quadric::normal(const Eigen::Vector3d& x) const {
  const Eigen::Vector3d g = gradient(x);
  if (!g.allFinite() || !(g.norm() > 1e-9))
    throw Error("the surface has no normal at [" + number(x.x()) + ", " + number(x.y()) + ", " +
                number(x.z()) + "], where its gradient is zero");
  return g.normalized();
}

bool Quadric::is_finite() const { return Q.allFinite() && b.allFinite() && std::isfinite(c); }

void Quadric::check(const std::string& who) const {
  if (!is_finite()) throw Error(who + ": the surface holds a NaN or an infinity");
  if ((Q - Q.transpose()).norm() > 1e-9 * (1.0 + Q.norm()))
    throw Error(who + ": the surface's matrix is not symmetric");
  if (Q.isZero(0.0) && b.isZero(0.0))
    throw Error(who + ": the surface's function is constant, so the surface has no normal");
}

}  // namespace burnish
