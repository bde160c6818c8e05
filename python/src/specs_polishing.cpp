#include "specs_polishing.hpp"

namespace burnish::python {}  // namespace burnish::python
