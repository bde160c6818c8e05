// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/solver/ddp.hpp"
#include "burnish/solver/options.hpp"

namespace burnish {

const Words& words_of(StopReason);
const Description& description_of(const PhaseTimes*);
const Description& description_of(const RowPlace*);
const Description& description_of(const StartRow*);
const Description& description_of(const DdpSummary*);
const Description& description_of(const CostReport*);
const Description& description_of(const CostReport::Entry*);
const Description& description_of(const CostReport::Knot*);
const Description& description_of(const CostReport::Row*);
const Description& description_of(const CostReport::ActiveLimit*);
const Description& description_of(const NamedMatrix*);
const Words& words_of(StepUpdate);
const Description& description_of(const Regularization*);
const Description& description_of(const LineSearch*);
const Description& description_of(const LimitOptions*);
const Description& description_of(const DdpProgress*);
const Description& description_of(const DdpOptions*);

}  // namespace burnish
