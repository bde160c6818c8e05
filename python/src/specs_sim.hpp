// Values of the sim layer.
#pragma once

#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "sim/descriptions.hpp"
#include "specs_mpc.hpp"

namespace burnish::python {

template <>
struct SpecOf<TaskPoint> : AsDataclass<TaskPoint> {};
template <>
struct SpecOf<CirclePath> : AsDataclass<CirclePath> {};
template <>
struct SpecOf<ImpedanceSpec> : AsDataclass<ImpedanceSpec> {};
template <>
struct SpecOf<MujocoPlantOptions> : AsDataclass<MujocoPlantOptions> {};

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<std::function<burnish::TaskPoint(double)>>
    : burnish::python::TimeFunctionCaster<burnish::TaskPoint> {};

}  // namespace pybind11::detail
