#include "specs_dynamics.hpp"

namespace burnish::python {}  // namespace burnish::python
