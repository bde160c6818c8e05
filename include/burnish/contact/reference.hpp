// A reference is data: where its origin is and which axes it has. Motions, forces, their set points
// and their directions are written in it. See docs/frames.md.
#pragma once

#include <Eigen/Core>
#include <string>

#include "burnish/base/abi.hpp"

namespace burnish {

struct Reference {
  enum class Origin { Tool, World };      ///< at the tool's origin, or at the world's
  enum class Axes { Tool, Base, World };  ///< axes that `rotation` is fixed in

  Origin origin = Origin::Tool;
  Axes axes = Axes::World;
  /// Rotation from the reference's axes to the axes that it is fixed in.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  /// The tool's own axes at the tool's origin (the paper's LOCAL), turned by `rotation` if given.
  static Reference local(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());
  /// World axes at the tool's origin (the paper's heart frame).
  static Reference centered();
  /// Axes fixed in the base frame C1, at the tool's origin; the columns of `rotation` are the axes
  /// of the surface in C1. They move with C1.
  static Reference surface(const Eigen::Matrix3d& rotation);
  /// A surface with the given normal as its z axis; x is the horizontal-most tangent.
  static Reference surface_with_normal(const Eigen::Vector3d& normal);
  /// World axes at the world's origin: the true WORLD twist and wrench.
  static Reference world();

  /// "local", "centered", "surface" or "world".
  std::string name() const;
  /// Reads those names ("surface" gets the identity). Throws Error with the nearest known name.
  static Reference parse(const std::string& name);
  /// Throws Error("<who>: ...") unless `rotation` is a rotation matrix, to 1e-6, and axes at the
  /// world's origin are the world's.
  void check(const std::string& who) const;
};

}  // namespace burnish
