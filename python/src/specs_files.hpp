// Values of the files layer.
#pragma once

#include "specs_ocp.hpp"
#include "specs_solver.hpp"

namespace burnish::python {}  // namespace burnish::python
