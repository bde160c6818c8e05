#include "specs_mpc.hpp"

namespace burnish::python {}  // namespace burnish::python
