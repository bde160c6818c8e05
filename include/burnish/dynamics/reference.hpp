// A reference is data: an origin, axes, and a rotation between the two. Motions, forces, their set
// points and their directions are written in it: those of contacts, of frames and of costs alike.
// See docs/frames.md.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "burnish/base/signal.hpp"
#include "burnish/base/views.hpp"
#include "burnish/dynamics/quadric.hpp"

namespace burnish {

/// What an origin or axes are fixed in. Of a frame that is looked at by itself, the tool is that
/// frame and the base is the world.
struct Anchor {
  enum Of {
    Tool,   ///< frame C2 of the contact
    Base,   ///< its frame C1
    World,  ///< stands still
    Frame,  ///< any frame of the robot, by name
  };
  Of of = World;
  std::string frame = {};  ///< of Frame only

  Anchor() = default;
  Anchor(Of what) : of(what) {}                                    // NOLINT: Reference{Tool, Base}
  Anchor(std::string name) : of(Frame), frame(std::move(name)) {}  // NOLINT: the same, by name
  Anchor(const char* name) : of(Frame), frame(name) {}             // NOLINT
  bool operator==(const Anchor&) const = default;

  /// Reads "tool", "base" and "world", and any other text as the name of a frame; a frame that is
  /// called so itself is "frame tool".
  static Anchor parse(const std::string& text);
  std::string text() const;  ///< as parse() reads it
};

struct Reference {
  using Origin = Anchor;
  using Axes = Anchor;

  Anchor origin = Anchor::Tool;
  Anchor axes = Anchor::World;  ///< what `rotation` is fixed in
  /// Rotation from the reference's axes to the axes that it is fixed in.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  /// The same over time, as quaternions x, y, z, w of unit length, of which q and -q are one
  /// rotation. For the knots of a problem, each of which holds the rotation of its time; empty:
  /// `rotation`, which is the identity otherwise.
  Signal rotation_over_time = {};
  /// A surface in the frame that the axes are fixed in, which they follow as the tool moves over
  /// it: at a normal n they are `rotation` turned by the least rotation that takes its third column
  /// to n. Those of contacts are at the tool, with axes fixed in the base; others may have any
  /// origin, and axes fixed in all but the tool.
  std::optional<Quadric> quadric = {};

  /// The tool's own axes at the tool's origin (the paper's LOCAL), turned by `rotation` if given.
  static Reference local(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());
  /// World axes at the tool's origin (the paper's heart frame), or the columns of `rotation`.
  static Reference centered(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());
  /// Axes fixed in the base frame C1, at the tool's origin; the columns of `rotation` are the axes
  /// of the surface in C1. They move with C1.
  static Reference surface(const Eigen::Matrix3d& rotation);
  /// A surface with the given normal as its z axis; x is the horizontal-most tangent.
  static Reference surface_with_normal(const Eigen::Vector3d& normal);
  /// Axes that follow a curved surface of the base: those of surface_with_normal() at `near`, a
  /// point in the axes of the base where the tool is to be, and turned with the normal elsewhere.
  /// Within half a turn of there.
  static Reference on(const Quadric& surface, const Eigen::Vector3d& near);
  /// The same with the tangent that leads along a direction, such as that of travel, as the first
  /// axis at `near`. Throws Error for the direction of the normal.
  static Reference on(const Quadric& surface, const Eigen::Vector3d& near,
                      const Eigen::Vector3d& along);
  /// The same at the world's origin: the true WORLD twist and wrench.
  static Reference world(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());

  /// "local", "centered", "surface" or "world"; of others such as "axes of torso at the tool".
  std::string name() const;
  /// Reads those four ("surface" gets the identity). Throws Error with the nearest known name.
  static Reference parse(const std::string& name);
  /// As it is at a time, s, with that rotation. Throws Error where it has none there, to 1e-6.
  Reference at(double time) const;
  /// As it is with the tool at a point of the frame that the axes are fixed in, m: axes that follow
  /// no surface. Throws Error where that has no normal, or one half a turn away.
  Reference at(const Eigen::Vector3d& point) const;
  /// Throws Error("<who>: ...") unless `rotation` is a rotation matrix, to 1e-6, and the one that
  /// is stated.
  void check(const std::string& who) const;
};

}  // namespace burnish
