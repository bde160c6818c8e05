// Values of the sim layer.
#pragma once

#include "burnish/mujoco/mujoco_plant.hpp"
#include "burnish/sim/actuation.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/ideal_plant.hpp"
#include "burnish/sim/plant.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/pressing/circle_path.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "specs_mpc.hpp"

namespace burnish::python {

template <>
struct SpecOf<Push> : AsDataclass<Push> {};
template <>
struct SpecOf<Disturbances> : AsDataclass<Disturbances> {};
template <>
struct SpecOf<SurfaceSpec> : AsDataclass<SurfaceSpec> {};
template <>
struct SpecOf<ToolTipSpec> : AsDataclass<ToolTipSpec> {};
template <>
struct SpecOf<SceneSpec> : AsDataclass<SceneSpec> {};
template <>
struct SpecOf<PlantSnapshot> : AsDataclass<PlantSnapshot> {};
template <>
struct SpecOf<ActuationStep> : AsDataclass<ActuationStep> {};
template <>
struct SpecOf<TaskPoint> : AsDataclass<TaskPoint> {};
template <>
struct SpecOf<CirclePath> : AsDataclass<CirclePath> {};
template <>
struct SpecOf<ImpedanceSpec> : AsDataclass<ImpedanceSpec> {};
template <>
struct SpecOf<IdealPlantOptions> : AsDataclass<IdealPlantOptions> {};
template <>
struct SpecOf<MujocoPlantOptions> : AsDataclass<MujocoPlantOptions> {};
template <>
struct SpecOf<ClosedLoopOptions> : AsDataclass<ClosedLoopOptions> {};

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<std::function<burnish::TaskPoint(double)>>
    : burnish::python::TimeFunctionCaster<burnish::TaskPoint> {};

}  // namespace pybind11::detail
