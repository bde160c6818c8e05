#include "specs_files.hpp"

namespace burnish::python {}  // namespace burnish::python
