// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/mpc/mpc.hpp"

namespace burnish {

const Words& words_of(ModelErrorKind);
const Description& description_of(const SafetyLimits*);
const Description& description_of(const Fallback*);
const Description& description_of(const ModelErrorOptions*);

}  // namespace burnish
