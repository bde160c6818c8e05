// Values of the sim layer.
#pragma once

#include "specs_mpc.hpp"

namespace burnish::python {}  // namespace burnish::python
