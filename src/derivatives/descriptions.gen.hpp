// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/derivatives/check.hpp"
#include "burnish/derivatives/contact_dynamics.hpp"
#include "burnish/derivatives/diagnosis.hpp"
#include "burnish/derivatives/rigid_body.hpp"
#include "contact/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const CheckGains*);
const Description& description_of(const CheckEntry*);
const Description& description_of(const CheckRow*);
const Description& description_of(const CheckReport*);
const Description& description_of(const WrenchDerivatives*);
const Description& description_of(const RedundantRow*);
const Description& description_of(const ContactDiagnosis*);
const Description& description_of(const FrameDerivatives*);
const Description& description_of(const PlacementDerivatives*);

}  // namespace burnish
