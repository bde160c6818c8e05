// Conversion of the types of the derivatives layer between Python and C++.
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/derivatives/check.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "derivatives/descriptions.gen.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

template <>
struct SpecOf<CheckOptions> : AsDataclass<CheckOptions> {};

}  // namespace burnish::python
