// Conversion of the types of the base layer between Python and C++. A signal is None, a number, an
// array, or a function of time.
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/base/signal.hpp"
#include "callback.hpp"
#include "spec.hpp"

namespace burnish::python {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// Converts the return value of a Python function to an array; null if the value is not numeric.
Numbers numbers_of(const py::object& answer);
/// Returns a text about the received array, for messages.
std::string what_came(const Numbers& numbers);

/// Function of time from C++, for example from a problem file. Python can call it, and pass it
/// back.
struct SignalFunction {
  Signal signal;
};

bool load_signal(py::handle from, Signal& signal);
py::object make_signal(const Signal& signal);

template <>
inline std::string wanted<Signal>() {
  return "a number, a vector of numbers, a function of time, or None";
}

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<burnish::Signal> {
  PYBIND11_TYPE_CASTER(burnish::Signal, const_name("Signal"));
  bool load(handle from, bool) { return burnish::python::load_signal(from, value); }
  static handle cast(const burnish::Signal& from, return_value_policy, handle) {
    return burnish::python::make_signal(from).release();
  }
};

}  // namespace pybind11::detail
