// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/mpc/controller.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/mpc/feedback.hpp"
#include "burnish/mpc/margins.hpp"
#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/mpc/task.hpp"
#include "contact/descriptions.gen.hpp"
#include "derivatives/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "estimate/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "ocp/descriptions.gen.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const ToolCommand*);
const Description& description_of(const Command*);
const Words& words_of(FaultKind);
const Description& description_of(const FaultReport*);
const Description& description_of(const LinearFeedback*);
const Description& description_of(const GainRange*);
const Description& description_of(const LoopMargins*);
const Description& description_of(const SafetyLimits*);
const Description& description_of(const Fallback*);
const Words& words_of(PlanTiming);
const Description& description_of(const ToolSpec*);
const Description& description_of(const MpcSpec*);
const Description& description_of(const SchedulePhase*);

}  // namespace burnish
