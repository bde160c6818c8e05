// What the layer's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/files/problem_file.hpp"
#include "ocp/descriptions.hpp"
#include "solver/descriptions.hpp"

namespace burnish {
const Words& words_of(WarmStart::Kind);
const Description& description_of(const WarmStart*);
const Description& description_of(const ProblemFile*);
const Description& description_of(const TrajectoryGuess*);

}  // namespace burnish
