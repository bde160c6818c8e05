// Conversion of the types of the model layer between Python and C++.
#pragma once

#include "burnish/model/inertia.hpp"
#include "burnish/model/model.hpp"
#include "burnish/robots/robot.hpp"
#include "model/descriptions.gen.hpp"
#include "spec.hpp"

namespace burnish::python {

/// Throws Error("<call>: ...") for an inertia that is physically impossible.
inline void check_payload(const char* call, const InertiaSpec& inertia) {
  if (const std::string problem = inertia_problem(inertia); !problem.empty())
    throw Error(std::string(call) + ": " + problem);
}

template <>
struct SpecOf<RobotOverrides> : AsDataclass<RobotOverrides> {};

}  // namespace burnish::python
