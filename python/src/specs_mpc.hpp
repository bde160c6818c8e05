// Conversion of the types of the mpc layer, and of tasks that press, between Python and C++.
#pragma once

#include "burnish/tasks/pressing/pressing_task.hpp"
#include "mpc/descriptions.gen.hpp"
#include "pressing/descriptions.gen.hpp"
#include "specs_ocp.hpp"
#include "specs_solver.hpp"
#include "time_function.hpp"

namespace pybind11::detail {

template <>
struct type_caster<std::function<burnish::TaskTarget(double)>>
    : burnish::python::TimeFunctionCaster<burnish::TaskTarget> {};

/// Caster of a controller's task: Python's None is an empty MakeTask.
template <>
struct type_caster<burnish::MakeTask> {
  PYBIND11_TYPE_CASTER(burnish::MakeTask, const_name("Optional[PressingTask]"));
  bool load(handle from, bool convert) {
    value = nullptr;
    if (from.is_none()) return true;
    make_caster<burnish::PressingTask> caster;
    if (!caster.load(from, convert)) return false;
    value = cast_op<burnish::PressingTask&>(caster);
    return true;
  }
  static handle cast(const burnish::MakeTask& from, return_value_policy policy, handle parent) {
    if (!from) return none().release();
    if (const auto* task = from.target<burnish::PressingTask>())
      return make_caster<burnish::PressingTask>::cast(*task, policy, parent);
    throw burnish::Error("MpcSpec.task: this task exists only in C++; wanted a PressingTask");
  }
};

}  // namespace pybind11::detail
