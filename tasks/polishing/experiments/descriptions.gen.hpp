// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "contact/descriptions.gen.hpp"
#include "derivatives/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "estimate/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "mpc/descriptions.gen.hpp"
#include "ocp/descriptions.gen.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/results_table.hpp"
#include "pressing/descriptions.gen.hpp"
#include "report/descriptions.hpp"
#include "sim/descriptions.gen.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish::polishing {

const Description& description_of(const ExperimentSpec*);
const Description& description_of(const Figure*);
const Description& description_of(const NamedTask*);
const Description& description_of(const ExperimentReport*);
const Description& description_of(const ResultColumn*);
const Description& description_of(const ResultTable*);

}  // namespace burnish::polishing
