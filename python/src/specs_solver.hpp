// Values of the solver layer.
#pragma once

#include "specs_base.hpp"

namespace burnish::python {}  // namespace burnish::python
