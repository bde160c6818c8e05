// Constants of a Reference for kernels. Functions: dynamics/reference.hpp.
#pragma once

#include "math/vec3.hpp"

namespace burnish {

/// Constants of a reference. Bodies are joint indices, -1 for the world.
struct CompiledReference {
  int origin_body = -1, axes_body = -1;
  Vec3<double> origin;      ///< Origin, in axes of the body `origin_body` [m]
  Mat3<double> axes;        ///< Rotation from the reference to the body `axes_body`
  Mat3<double> fixed_in;    ///< `axes` without Reference::rotation
  bool at_tool = false;     ///< True if the origin is the origin of the tool
  bool at_world = false;    ///< True if the origin is the world's origin
  bool is_aligned = false;  ///< True if the axes are world axes
  /// True if the axes follow a surface (curved_axes.hpp). Q, b and c are the coefficients of the
  /// surface, in the frame with axes `fixed_in` and origin `place`.
  bool is_curved = false;
  int tool_body = -1;
  Vec3<double> place;  ///< Origin of the surface frame, in axes of the body `axes_body` [m]
  Vec3<double> tool;   ///< Point whose surface normal the axes follow, in body `tool_body` [m]
  Mat3<double> Q;
  Vec3<double> b;
  double c = 0.0;
};

/// Axes (tree.hpp) along which an entry of v moves three bodies: the body of the reference's
/// origin, the body of its axes, and the tool's body; -1: the entry does not move the body. The
/// tool's axis matters only for reference axes that follow a surface.
struct ReferenceAxes {
  int origin = -1, axes = -1, tool = -1;
};

}  // namespace burnish
