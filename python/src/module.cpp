// Extension module burnish._core, which binds all layers of the library.
#include <pybind11/pybind11.h>

#include "bind.hpp"

namespace burnish::python {

PYBIND11_MODULE(_core, module) {
  module.doc() = "Compiled part of burnish; import burnish instead.";
  module.attr("__version__") = BURNISH_VERSION;
  bind_base(module);
  bind_specs(module);
  bind_model(module);
  bind_contact(module);
  bind_dynamics(module);
  bind_derivatives(module);
  bind_ocp(module);
  bind_solver(module);
  bind_files(module);
  bind_estimate(module);
  bind_mpc(module);
  bind_sim(module);
  bind_identify(module);
  bind_report(module);
  bind_polishing(module);
  bind_named_tasks(module);
}

}  // namespace burnish::python
