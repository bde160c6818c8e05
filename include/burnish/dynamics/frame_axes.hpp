// Which axes and origin the motion of a frame is written in.
#pragma once

#include <string>
#include <string_view>

namespace burnish {

/// What a frame's motion is written in. The acceleration is in brackets.
enum class FrameAxes {
  Local,     ///< the frame's own axes and origin (its spatial acceleration)
  Centered,  ///< world axes, the frame's origin (acceleration of the material point there)
  World,     ///< world axes, the world's origin (spatial acceleration in the world)
};

std::string_view name_of(FrameAxes axes);
/// Reads "local", "centered" or "world". Throws Error with the nearest known name.
FrameAxes parse_frame_axes(const std::string& name);

}  // namespace burnish
