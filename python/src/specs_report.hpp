// Values of the report layer.
#pragma once

#include "specs_sim.hpp"

namespace burnish::python {}  // namespace burnish::python
