// Values of the polishing layer.
#pragma once

#include "specs_report.hpp"

namespace burnish::python {}  // namespace burnish::python
