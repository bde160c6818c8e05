// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "estimate/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "sim/descriptions.gen.hpp"

namespace burnish {

const Words& words_of(MujocoContact);
const Description& description_of(const MujocoPlantOptions*);

}  // namespace burnish
