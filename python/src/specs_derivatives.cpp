#include "specs_derivatives.hpp"

namespace burnish::python {}  // namespace burnish::python
