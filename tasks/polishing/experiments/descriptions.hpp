// What the layer's specifications hold.
#pragma once

#include "polishing/experiments/experiment.hpp"
#include "polishing/run_descriptions.hpp"
#include "report/descriptions.hpp"

namespace burnish::polishing {
const Description& description_of(const ExperimentSpec*);
const Description& description_of(const ResultColumn*);
const Description& description_of(const ResultTable*);
const Description& description_of(const Figure*);
const Description& description_of(const NamedTask*);
const Description& description_of(const ExperimentReport*);

}  // namespace burnish::polishing
