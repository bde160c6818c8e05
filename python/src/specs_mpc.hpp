// Values of the mpc layer.
#pragma once

#include "burnish/mpc/mpc.hpp"
#include "specs_ocp.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

template <>
struct EnumOf<Phase> : AsEnum<Phase> {};
template <>
struct EnumOf<FaultKind> : AsEnum<FaultKind> {};
template <>
struct EnumOf<ModelErrorKind> : AsEnum<ModelErrorKind> {};
template <>
struct SpecOf<Measurement> : AsDataclass<Measurement> {};
template <>
struct SpecOf<Command> : AsDataclass<Command> {};
template <>
struct SpecOf<SchedulePhase> : AsDataclass<SchedulePhase> {};
template <>
struct SpecOf<TaskTarget> : AsDataclass<TaskTarget> {};
template <>
struct SpecOf<SafetyLimits> : AsDataclass<SafetyLimits> {};
template <>
struct SpecOf<Fallback> : AsDataclass<Fallback> {};
template <>
struct SpecOf<ModelErrorOptions> : AsDataclass<ModelErrorOptions> {};
template <>
struct SpecOf<FaultReport> : AsDataclass<FaultReport> {};
template <>
struct SpecOf<LinearFeedback> : AsDataclass<LinearFeedback> {};
template <>
struct SpecOf<MpcSpec> : AsDataclass<MpcSpec> {};

}  // namespace burnish::python
