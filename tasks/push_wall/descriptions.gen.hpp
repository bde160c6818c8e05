// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/tasks/push_wall/push_wall.hpp"
#include "contact/descriptions.gen.hpp"
#include "derivatives/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "estimate/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "mpc/descriptions.gen.hpp"
#include "ocp/descriptions.gen.hpp"
#include "pressing/descriptions.gen.hpp"
#include "report/descriptions.hpp"
#include "sim/descriptions.gen.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish::push_wall {

const Description& description_of(const Weights*);
const Description& description_of(const Wall*);
const Description& description_of(const ForceSearch*);
const Words& words_of(Limit);
const Description& description_of(const Task*);
const Description& description_of(const Setting*);
const Description& description_of(const RunSpec*);

}  // namespace burnish::push_wall
