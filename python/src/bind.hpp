// Functions that bind the layers, one per layer, in the order of the layers.
#pragma once

#include <pybind11/pybind11.h>

namespace burnish::python {

namespace py = pybind11;

void bind_specs(py::module_& m);  ///< Binds the functions that all dataclasses use
void bind_described(py::module_& m);
void bind_base(py::module_& m);
void bind_model(py::module_& m);
void bind_contact(py::module_& m);
void bind_dynamics(py::module_& m);
void bind_derivatives(py::module_& m);
void bind_ocp(py::module_& m);
void bind_solver(py::module_& m);
void bind_files(py::module_& m);
void bind_estimate(py::module_& m);
void bind_mpc(py::module_& m);
void bind_sim(py::module_& m);
void bind_identify(py::module_& m);
void bind_report(py::module_& m);
void bind_polishing(py::module_& m);
void bind_named_tasks(py::module_& m);

}  // namespace burnish::python
