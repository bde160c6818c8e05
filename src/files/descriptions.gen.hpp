// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/files/problem_file.hpp"
#include "contact/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "ocp/descriptions.gen.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const WarmStart*);
const Words& words_of(WarmStart::Kind);
const Description& description_of(const ProblemFile*);
const Description& description_of(const TrajectoryGuess*);

}  // namespace burnish
