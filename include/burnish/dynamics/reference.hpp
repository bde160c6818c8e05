// References: origin and axes in which motions, forces, set points and directions are written. See
// docs/frames.md.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "burnish/base/signal.hpp"
#include "burnish/base/views.hpp"
#include "burnish/dynamics/quadric.hpp"

namespace burnish {

/// Frame to which the origin or the axes of a Reference are fixed. For a contact, Tool and Base are
/// the contact's two frames. Without a contact, for example for the velocity of a frame, Tool is
/// this frame and Base is the world.
struct Anchor {
  enum Kind {
    Tool,   ///< Tool frame C2 of the contact
    Base,   ///< Base frame C1 of the contact
    World,  ///< World, which does not move
    Frame,  ///< Frame of the robot, selected by name
  };
  Kind kind = World;
  std::string frame = {};  ///< Name of the frame; used only if `kind` is Frame

  Anchor() = default;
  Anchor(Kind what) : kind(what) {}  // NOLINT: Reference{Tool, Base}
  Anchor(std::string name) : kind(Frame), frame(std::move(name)) {}  // NOLINT: by name
  Anchor(const char* name) : kind(Frame), frame(name) {}             // NOLINT
  bool operator==(const Anchor&) const = default;

  /// Parses "tool", "base", "world" or the name of a frame. The text "frame tool" stands for a
  /// frame whose name is "tool".
  static Anchor parse(const std::string& text);
  std::string text() const;  ///< Returns the text from which parse() creates this Anchor
};

/// Origin and axes in which a motion or a force is written.
struct Reference {
  using Origin = Anchor;
  using Axes = Anchor;

  Anchor origin = Anchor::Tool;
  Anchor axes = Anchor::World;  ///< Frame in which the axes are fixed

  /// Rotation matrix that maps coordinates in this Reference to coordinates in the frame `axes`.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  /// Rotation as a function of time, for the knots of an optimal control problem. The values are
  /// unit quaternions x, y, z, w; a quaternion and its negative are the same rotation. If this
  /// signal is set, `rotation` must be the identity. If it is empty, `rotation` is used.
  Signal rotation_over_time = {};
  /// Curved surface; the axes turn with its normal as the tool moves. The surface is written in the
  /// frame `axes`. At a point with normal n, the axes are the columns of S * `rotation`. S is the
  /// smallest rotation that maps the third column of `rotation` to n. In contacts, `origin` must be
  /// Tool and `axes` must be Base. In other uses, `origin` is arbitrary and `axes` must not be
  /// Tool.
  std::optional<Quadric> quadric = {};

  /// Returns a Reference at the tool's origin. Its axes are the tool's axes, turned by `rotation`.
  /// The paper cited in docs/frames.md calls it LOCAL.
  static Reference local(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());
  /// Returns a Reference at the tool's origin. Its axes are the columns of `rotation`, by default
  /// the world axes. The paper cited in docs/frames.md calls it the heart frame.
  static Reference centered(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());
  /// Returns a Reference at the tool's origin, with axes fixed in the base frame C1. The axes are
  /// the columns of `rotation`, written in C1, and move with C1.
  static Reference surface(const Eigen::Matrix3d& rotation);
  /// Returns a Reference at the tool's origin, with axes fixed in the base frame C1. The z axis is
  /// along `normal`, which is written in C1. The x axis is perpendicular to the z axis of C1, so
  /// that it is horizontal in C1. Throws Error for a normal of zero length.
  static Reference surface_with_normal(const Eigen::Vector3d& normal);
  /// Returns a Reference whose axes follow a curved surface of the base. `near` is a point in the
  /// axes of the base; choose it where the tool will touch. At `near`, the axes are those of
  /// surface_with_normal() for the normal at `near`. At other points, the axes turn with the
  /// surface normal. The angle between this normal and the normal at `near` must be less than half
  /// a turn.
  static Reference on(const Quadric& surface, const Eigen::Vector3d& near);
  /// Returns a Reference whose axes follow a curved surface of the base. At the point `near`, the x
  /// axis is the tangent in the direction `along`, such as the direction of travel. Throws Error if
  /// `along` is parallel to the normal.
  static Reference on(const Quadric& surface, const Eigen::Vector3d& near,
                      const Eigen::Vector3d& along);
  /// Returns a Reference at the world's origin. Its axes are the columns of `rotation`, by default
  /// the world axes. With the world axes, motions and wrenches are the spatial (WORLD) twist and
  /// wrench.
  static Reference world(const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity());

  /// Returns "local", "centered", "surface" or "world". For other combinations of origin and axes,
  /// returns a text such as "axes of torso at the tool".
  std::string name() const;
  /// Parses "local", "centered", "surface" (with the identity as rotation) or "world". Throws Error
  /// with the nearest known name.
  static Reference parse(const std::string& name);
  /// Returns this Reference with a constant rotation: the value of `rotation_over_time` at `time`
  /// [s]. Throws Error unless this value is a quaternion of unit length to 1e-6.
  Reference at(double time) const;
  /// Returns this Reference with constant axes: the axes that it has at `point`. The constant axes
  /// do not follow the surface. `point` [m] is in the frame `axes`. Throws Error if the surface has
  /// no normal at `point`, or if the normal is opposite to the third column of `rotation`.
  Reference at(const Eigen::Vector3d& point) const;
  /// Throws Error, with a message that begins with `who`, if
  ///  - `rotation` is not a rotation matrix to 1e-6;
  ///  - `rotation_over_time` is set, and `rotation` is not the identity or `quadric` is set;
  ///  - `rotation_over_time` does not have 4 entries;
  ///  - the surface is invalid or fixed in the tool.
  void check(const std::string& who) const;
};

}  // namespace burnish
