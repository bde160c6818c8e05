// Values of the base layer.
#pragma once

#include "burnish/base/status.hpp"
#include "spec.hpp"

namespace burnish::python {

template <>
struct EnumOf<Status> : AsEnum<Status> {};

}  // namespace burnish::python
