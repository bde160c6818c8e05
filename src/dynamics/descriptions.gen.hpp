// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/dynamics/quadric.hpp"
#include "burnish/dynamics/surface_shape.hpp"

namespace burnish {

const Description& description_of(const Quadric*);
const Description& description_of(const SurfaceShape*);
const Words& words_of(SurfaceShape::Kind);

}  // namespace burnish
