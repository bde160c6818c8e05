// What runs of the task are specified by, and what they give.
#pragma once

#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "mpc/descriptions.hpp"
#include "polishing/descriptions.hpp"
#include "pressing/run_descriptions.hpp"
#include "sim/descriptions.hpp"

namespace burnish::polishing {

const Description& description_of(const VerdictFigures*);
const Words& words_of(ControllerKind);
const Description& description_of(const NamedSurface*);
const Description& description_of(const Setting*);
const Description& description_of(const FreeHome*);
const Description& description_of(const RunSpec*);
const Description& description_of(const RequiredMargins*);
const Description& description_of(const TaskMargins*);
const Description& description_of(const FittedGains*);

}  // namespace burnish::polishing
