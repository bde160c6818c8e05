// Values of the files layer.
#pragma once

#include "burnish/files/problem_file.hpp"
#include "specs_ocp.hpp"
#include "specs_solver.hpp"

namespace burnish::python {

template <>
struct EnumOf<WarmStart::Kind> : AsEnum<WarmStart::Kind> {};
template <>
struct SpecOf<WarmStart> : AsDataclass<WarmStart> {};
template <>
struct SpecOf<ProblemFile> : AsDataclass<ProblemFile> {};
template <>
struct SpecOf<TrajectoryGuess> : AsDataclass<TrajectoryGuess> {};

}  // namespace burnish::python
