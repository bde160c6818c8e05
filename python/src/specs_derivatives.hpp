// Values of the derivatives layer.
#pragma once

#include "specs_dynamics.hpp"

namespace burnish::python {}  // namespace burnish::python
