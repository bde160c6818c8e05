// What the layer's enumerations hold.
#pragma once

#include "base/description.hpp"
#include "burnish/base/status.hpp"

namespace burnish {

const Words& words_of(Status);

}  // namespace burnish
