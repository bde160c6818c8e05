#include "specs_dynamics.hpp"

namespace burnish::python {

template <>
const EnumTable& AsEnum<FrameAxes>::table() {
  static const EnumTable words("burnish.dynamics", "FrameAxes", {"local", "centered", "world"});
  return words;
}

}  // namespace burnish::python
