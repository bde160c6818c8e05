// Functions of time [s] with dataclasses as values, such as the targets of a task.
#pragma once

#include <functional>
#include <string>

#include "callback.hpp"
#include "spec.hpp"

namespace burnish::python {

/// Function of time [s] in Python. Its exceptions pass to the caller. Throws Error if the result is
/// not a Value.
template <class Value>
struct TimeFunction {
  Kept function;

  Value operator()(double time) const {
    const py::gil_scoped_acquire lock;
    const py::object answer = function.get()(time);
    py::detail::make_caster<Value> caster;
    if (!caster.load(answer, true))
      throw Error("the function of time gave " + std::string(py::repr(answer)) + " at " +
                  std::string(py::str(py::float_(time))) + " s; wanted a " +
                  std::string(type_name<Value>()));
    return py::detail::cast_op<Value&>(caster);
  }
};

/// None stands for an empty function. A function from Python is returned to Python unchanged.
template <class Value>
struct TimeFunctionCaster {
  using Function = std::function<Value(double)>;
  PYBIND11_TYPE_CASTER(Function, py::detail::const_name("Callable[[float], ") +
                                     TypeName<Value>::name + py::detail::const_name("]"));
  bool load(py::handle from, bool) {
    value = nullptr;
    if (from.is_none()) return true;
    if (PyCallable_Check(from.ptr()) == 0) return false;
    value = TimeFunction<Value>{Kept(py::reinterpret_borrow<py::object>(from))};
    return true;
  }
  static py::handle cast(const Function& from, py::return_value_policy, py::handle) {
    if (!from) return py::none().release();
    if (const auto* ours = from.template target<TimeFunction<Value>>())
      return py::object(ours->function.get()).release();
    return py::cpp_function(from).release();
  }
};

}  // namespace burnish::python
