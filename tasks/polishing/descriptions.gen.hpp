// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/tasks/polishing/force_profile.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/path.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/stages.hpp"
#include "burnish/tasks/polishing/task.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
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

namespace burnish::polishing {

const Description& description_of(const ForceProfile*);
const Words& words_of(ForceProfile::Kind);
const Description& description_of(const RequiredMargins*);
const Description& description_of(const TaskMargins*);
const Description& description_of(const FittedGains*);
const Words& words_of(PathKind);
const Description& description_of(const PathSpec*);
const Description& description_of(const PlanarPoint*);
const Description& description_of(const FreeHome*);
const Words& words_of(ControllerKind);
const Description& description_of(const RunSpec*);
const Description& description_of(const Setting*);
const Words& words_of(ForceAxes);
const Description& description_of(const Waving*);
const Description& description_of(const RestingHand*);
const Description& description_of(const Weights*);
const Description& description_of(const Verdict*);
const Description& description_of(const Task*);
const Description& description_of(const NamedSurface*);

}  // namespace burnish::polishing
