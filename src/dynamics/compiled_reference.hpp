// A reference as the kernels read it: dynamics/reference.hpp makes and asks it.
#pragma once

#include "math/vec3.hpp"

namespace burnish {

/// Constants of a reference. Bodies are joint indices, -1 for the world.
struct CompiledReference {
  int origin_body = -1, axes_body = -1;
  Vec3<double> origin;      ///< in its body, m
  Mat3<double> axes;        ///< of the reference, in their body
  Mat3<double> fixed_in;    ///< in the same: those that the rotation starts from
  bool at_tool = false;     ///< the origin is the tool's own
  bool at_world = false;    ///< it is the world's
  bool is_aligned = false;  ///< the axes are the world's
  /// The axes follow a surface (curved_axes.hpp), in those that the rotation starts from; `place`
  /// is their origin in the axes' body, m, and `tool` the point that they look at it from, in its.
  bool is_curved = false;
  int tool_body = -1;
  Vec3<double> place, tool;
  Mat3<double> Q;
  Vec3<double> b;
  double c = 0.0;
};

/// The axes (tree.hpp) by which an entry of v moves a reference's origin, turns what its axes are
/// fixed in and moves the tool, which matters where they follow a surface; -1 where it does not.
struct ReferenceAxes {
  int origin = -1, axes = -1, tool = -1;
};

}  // namespace burnish
