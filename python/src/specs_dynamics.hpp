// Values of the dynamics layer.
#pragma once

#include "burnish/dynamics/frame_axes.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

template <>
struct EnumOf<FrameAxes> : AsEnum<FrameAxes> {};

}  // namespace burnish::python
