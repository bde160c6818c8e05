// A frame that is fixed to a body, as the kernels read it.
#pragma once

#include <string_view>
#include <vector>

#include "dynamics/tree.hpp"

namespace burnish {

/// Constants of one frame.
struct CompiledFrame {
  int body;                         ///< joint index, -1 for the world
  Mat3<double> R;                   ///< frame -> body
  Vec3<double> p;                   ///< origin in the body, m
  std::vector<MovingAxis> support;  ///< entries of v that move the body, ascending
};

CompiledFrame compile_frame(const Model& model, const Frame& frame);
/// By name; "world" is always known. Throws Error with the nearest known name.
CompiledFrame compile_frame(const Model& model, std::string_view name);

/// The world, which nothing moves.
inline CompiledFrame world_frame() {
  return {-1, Mat3<double>::identity(), Vec3<double>::zero(), {}};
}

}  // namespace burnish
