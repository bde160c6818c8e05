// Parts of the derivatives layer, each in a file of its own, and what they have in common.
#pragma once

#include <string>
#include <variant>

#include "bind.hpp"
#include "specs_derivatives.hpp"

namespace burnish::python {

void bind_contact_dynamics(py::module_& m);
void bind_contact_dynamics_batch(py::module_& m);
void bind_rigid_body(py::module_& m);

/// A contact or a frame as Python names it.
using NumberOrName = std::variant<int, std::string>;

/// "ContactDynamics.forward: tau has 5 entries; wanted 6", as Error, unless they agree.
void require_size(const char* what, const char* argument, Eigen::Index entries, int wanted);

/// Number of a contact. Throws Error naming what there is.
int contact_number(const char* what, const NumberOrName& contact,
                   const std::vector<std::string>& names);

}  // namespace burnish::python
