#include "dynamics/frame.hpp"

#include "base/to_size.hpp"

namespace burnish {

CompiledFrame compile_frame(const Model& model, const Frame& frame) {
  return {frame.body, from_eigen(Eigen::Matrix3d(frame.placement.linear())),
          from_eigen(Eigen::Vector3d(frame.placement.translation())),
          moving_axes(model, frame.body)};
}

CompiledFrame compile_frame(const Model& model, std::string_view name) {
  if (name == "world" && !model.has_frame(name)) return world_frame();
  return compile_frame(model, model.frames[to_size(model.frame_index(name))]);
}

}  // namespace burnish
