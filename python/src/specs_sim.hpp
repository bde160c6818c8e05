// Conversion of the types of the sim layer between Python and C++.
#pragma once

#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"
#include "mujoco/descriptions.gen.hpp"
#include "sim/descriptions.gen.hpp"
#include "specs_mpc.hpp"

namespace pybind11::detail {

template <>
struct type_caster<std::function<burnish::TaskPoint(double)>>
    : burnish::python::TimeFunctionCaster<burnish::TaskPoint> {};

}  // namespace pybind11::detail
