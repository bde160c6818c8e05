#include "specs_ocp.hpp"

namespace burnish::python {}  // namespace burnish::python
