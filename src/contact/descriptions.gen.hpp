// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/contact/contact.hpp"
#include "burnish/contact/contact_force.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/contact/loops.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"

namespace burnish {

const Words& words_of(Acceleration);
const Words& words_of(PoseError);
const Description& description_of(const SlidingFriction*);
const Description& description_of(const ContactSpec*);
const Description& description_of(const ContactForce*);
const Description& description_of(const ContactSolver*);
const Description& description_of(const LoopGains*);
const Description& description_of(const RedundantLoop*);
const Description& description_of(const LoopFreedom*);
const Description& description_of(const LoopProjectionOptions*);
const Description& description_of(const LoopMiss*);
const Description& description_of(const LoopProjection*);
const Words& words_of(LoopMetric);

}  // namespace burnish
