// Bindings of the parts of the derivatives layer, and their common helpers.
#pragma once

#include <string>
#include <variant>

#include "bind.hpp"
#include "specs_derivatives.hpp"

namespace burnish::python {

void bind_contact_dynamics(py::module_& m);
void bind_contact_dynamics_batch(py::module_& m);
void bind_rigid_body(py::module_& m);

/// Contact or frame, by index or by name.
using NumberOrName = std::variant<int, std::string>;

/// Throws Error("ContactDynamics.forward: tau has 5 entries; wanted 6") unless the sizes are equal.
void require_size(const char* what, const char* argument, Eigen::Index entries, int wanted);

/// Returns the index of a contact. Throws Error for an unknown contact.
int contact_number(const char* what, const NumberOrName& contact,
                   const std::vector<std::string>& names);

}  // namespace burnish::python
