// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/dynamics/quadric.hpp"
#include "burnish/dynamics/surface_shape.hpp"

namespace burnish {
const Description& description_of(const Quadric*);
const Words& words_of(SurfaceShape::Kind);
const Description& description_of(const SurfaceShape*);

}  // namespace burnish
