// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

const Words& words_of(StepUpdate);

}  // namespace burnish
