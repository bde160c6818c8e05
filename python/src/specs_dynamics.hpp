// Values of the dynamics layer.
#pragma once

#include "specs_contact.hpp"

namespace burnish::python {}  // namespace burnish::python
