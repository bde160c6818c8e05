#include "specs_report.hpp"

namespace burnish::python {}  // namespace burnish::python
