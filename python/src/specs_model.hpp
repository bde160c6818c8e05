// Values of the model layer.
#pragma once

#include "burnish/model/model.hpp"
#include "burnish/robots/robot.hpp"
#include "model/descriptions.hpp"
#include "spec.hpp"

namespace burnish::python {

template <>
struct SpecOf<RobotOverrides> : AsDataclass<RobotOverrides> {};

}  // namespace burnish::python
