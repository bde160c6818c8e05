#include "burnish/contact/reference.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "burnish/base/error.hpp"

namespace burnish {

Reference Reference::local(const Eigen::Matrix3d& rotation) {
  return {Origin::Tool, Axes::Tool, rotation};
}
Reference Reference::centered() { return {}; }
Reference Reference::surface(const Eigen::Matrix3d& rotation) {
  return {Origin::Tool, Axes::Base, rotation};
}
Reference Reference::world() { return {Origin::World, Axes::World, Eigen::Matrix3d::Identity()}; }

Reference Reference::surface_with_normal(const Eigen::Vector3d& normal) {
  if (!normal.allFinite() || normal.norm() < 1e-9)
    throw Error("surface_with_normal: the normal must be finite and not zero");
  const Eigen::Vector3d z = normal.normalized();
  // The tangent that leans least out of the horizontal; along x where the surface is horizontal.
  Eigen::Vector3d x = Eigen::Vector3d::UnitZ().cross(z);
  if (x.norm() < 1e-6) {
    x = Eigen::Vector3d::UnitX() - z * z.x();
  }
  x.normalize();
  Eigen::Matrix3d rotation;
  rotation << x, z.cross(x), z;
  return surface(rotation);
}

std::string Reference::name() const {
  if (origin == Origin::World) return "world";
  switch (axes) {
    case Axes::Tool:
      return "local";
    case Axes::Base:
      return "surface";
    case Axes::World:
      return "centered";
  }
  return "unknown";
}

Reference Reference::parse(const std::string& name) {
  if (name == "local") return local();
  if (name == "centered") return centered();
  if (name == "surface") return surface(Eigen::Matrix3d::Identity());
  if (name == "world") return world();
  throw Error("reference: unknown name '" + name + "'; wanted local, centered, surface or world" +
              did_you_mean(name, {"local", "centered", "surface", "world"}));
}

void Reference::check(const std::string& who) const {
  if (!rotation.allFinite() ||
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).norm() > 1e-6 ||
      rotation.determinant() < 0.0)
    throw Error(who + ": the reference's rotation is not a rotation matrix");
  if (origin == Origin::World && axes != Axes::World)
    throw Error(who +
                ": a reference at the world's origin has axes that move; wanted world axes there");
}

}  // namespace burnish
