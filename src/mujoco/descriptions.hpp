// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/mujoco/mujoco_plant.hpp"

namespace burnish {
const Words& words_of(MujocoContact);
const Description& description_of(const MujocoPlantOptions*);

}  // namespace burnish
