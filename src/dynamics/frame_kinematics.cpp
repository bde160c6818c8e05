#include "dynamics/frame_kinematics.hpp"

#include "burnish/base/error.hpp"

namespace burnish {

std::string_view name_of(FrameAxes axes) {
  switch (axes) {
    case FrameAxes::Local:
      return "local";
    case FrameAxes::Centered:
      return "centered";
    case FrameAxes::World:
      return "world";
  }
  return "unknown";
}

FrameAxes parse_frame_axes(const std::string& name) {
  if (name == "local") return FrameAxes::Local;
  if (name == "centered") return FrameAxes::Centered;
  if (name == "world") return FrameAxes::World;
  throw Error("axes: unknown name '" + name + "'; wanted local, centered or world" +
              did_you_mean(name, {"local", "centered", "world"}));
}

CompiledFrame compile_frame(const Model& model, const Frame& frame) {
  return {frame.body, from_eigen(Eigen::Matrix3d(frame.placement.linear())),
          from_eigen(Eigen::Vector3d(frame.placement.translation())),
          moving_axes(model, frame.body)};
}

CompiledFrame compile_frame(const Model& model, std::string_view name) {
  if (name == "world" && !model.has_frame(name))
    return {-1, Mat3<double>::identity(), Vec3<double>::zero(), {}};
  return compile_frame(model, model.frames[static_cast<std::size_t>(model.frame_index(name))]);
}

}  // namespace burnish
