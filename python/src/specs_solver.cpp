#include "specs_solver.hpp"

namespace burnish::python {}  // namespace burnish::python
