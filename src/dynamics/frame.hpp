// Constants of a frame that is fixed to a body, for kernels.
#pragma once

#include <string_view>
#include <vector>

#include "dynamics/tree.hpp"

namespace burnish {

/// Constants of one frame.
struct CompiledFrame {
  int body;                         ///< Joint index of the body; -1: the world
  Mat3<double> R;                   ///< Rotation from the frame to the body
  Vec3<double> p;                   ///< Origin in the body [m]
  std::vector<MovingAxis> support;  ///< Entries of v that move the body, in ascending order
};

/// Prepares a frame for the kernels.
CompiledFrame compile_frame(const Model& model, const Frame& frame);
/// Prepares the frame called `name`; "world" always exists. Throws Error with the nearest name if
/// the model does not have this frame.
CompiledFrame compile_frame(const Model& model, std::string_view name);

/// Frame of the world, which does not move.
inline CompiledFrame world_frame() {
  return {-1, Mat3<double>::identity(), Vec3<double>::zero(), {}};
}

}  // namespace burnish
