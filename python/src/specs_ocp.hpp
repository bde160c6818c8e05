// Values of the ocp layer.
#pragma once

#include "specs_derivatives.hpp"

namespace burnish::python {}  // namespace burnish::python
