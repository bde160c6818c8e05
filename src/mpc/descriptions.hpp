// What the layer's specifications hold.
#pragma once

#include "burnish/mpc/margins.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/mpc/surface_estimate.hpp"
#include "estimate/descriptions.hpp"
#include "ocp/descriptions.hpp"
#include "solver/descriptions.hpp"

namespace burnish {

const Words& words_of(ModelErrorKind);
const Words& words_of(PlanTiming);
const Description& description_of(const SafetyLimits*);
const Description& description_of(const SlipOptions*);
const Description& description_of(const Fallback*);
const Description& description_of(const ModelErrorOptions*);
const Description& description_of(const SurfaceEstimateOptions*);
const Description& description_of(const FrictionEstimateOptions*);
const Words& words_of(FaultKind);
const Description& description_of(const Measurement*);
const Description& description_of(const Command*);
const Description& description_of(const SchedulePhase*);
const Description& description_of(const FaultReport*);
const Description& description_of(const LinearFeedback*);
const Description& description_of(const MpcSpec*);
const Description& description_of(const GainRange*);
const Description& description_of(const LoopMargins*);

}  // namespace burnish
