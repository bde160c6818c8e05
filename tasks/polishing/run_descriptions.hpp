// What runs of the task are specified by, and what they give.
#pragma once

#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/descriptions.hpp"
#include "pressing/run_descriptions.hpp"
#include "sim/descriptions.hpp"

namespace burnish::polishing {

const Description& description_of(const VerdictFigures*);
const Words& words_of(ControllerKind);
const Description& description_of(const NamedSurface*);
const Description& description_of(const Setting*);
const Description& description_of(const RunSpec*);

}  // namespace burnish::polishing
