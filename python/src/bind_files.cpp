// Problems in files.
#include "bind.hpp"
#include "specs_files.hpp"

namespace burnish::python {

void bind_files(py::module_& /*m*/) {}

}  // namespace burnish::python
