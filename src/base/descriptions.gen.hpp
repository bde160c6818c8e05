// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/description.hpp"
#include "burnish/base/status.hpp"

namespace burnish {

const Words& words_of(Status);

}  // namespace burnish
