// Values of the derivatives layer.
#pragma once

#include "burnish/derivatives/check.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "specs_base.hpp"
#include "specs_contact.hpp"

namespace burnish::python {

template <>
struct SpecOf<WrenchDerivatives> : AsDataclass<WrenchDerivatives> {};
template <>
struct SpecOf<FrameDerivatives> : AsDataclass<FrameDerivatives> {};
template <>
struct SpecOf<PlacementDerivatives> : AsDataclass<PlacementDerivatives> {};
template <>
struct SpecOf<CheckGains> : AsDataclass<CheckGains> {};
template <>
struct SpecOf<CheckOptions> : AsDataclass<CheckOptions> {};
template <>
struct SpecOf<CheckEntry> : AsDataclass<CheckEntry> {};
template <>
struct SpecOf<CheckRow> : AsDataclass<CheckRow> {};
template <>
struct SpecOf<CheckReport> : AsDataclass<CheckReport> {};
template <>
struct SpecOf<RedundantRow> : AsDataclass<RedundantRow> {};
template <>
struct SpecOf<ContactDiagnosis> : AsDataclass<ContactDiagnosis> {};

}  // namespace burnish::python
