// Conversion of the types of the solver layer between Python and C++.
#pragma once

#include "burnish/solver/ddp.hpp"
#include "callback.hpp"
#include "solver/descriptions.gen.hpp"
#include "spec.hpp"

namespace burnish::python {

using DdpCallback = std::function<bool(const DdpProgress&)>;

bool load_callback(py::handle from, DdpCallback& callback);
py::object make_callback(const DdpCallback& callback);

}  // namespace burnish::python

namespace pybind11::detail {

template <>
struct type_caster<burnish::python::DdpCallback> {
  PYBIND11_TYPE_CASTER(burnish::python::DdpCallback, const_name("Callable"));
  bool load(handle from, bool) { return burnish::python::load_callback(from, value); }
  static handle cast(const burnish::python::DdpCallback& from, return_value_policy, handle) {
    return burnish::python::make_callback(from).release();
  }
};

}  // namespace pybind11::detail
