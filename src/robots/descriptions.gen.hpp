// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "robots/robot_settings.hpp"

namespace burnish {

const Description& description_of(const JointLimits*);
const Description& description_of(const JointFigures*);
const Description& description_of(const RobotSettings*);

}  // namespace burnish
