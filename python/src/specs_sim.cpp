#include "specs_sim.hpp"

namespace burnish::python {}  // namespace burnish::python
