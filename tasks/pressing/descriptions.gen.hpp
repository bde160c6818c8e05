// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#pragma once

#include "base/descriptions.gen.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_path.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "burnish/tasks/pressing/standing.hpp"
#include "contact/descriptions.gen.hpp"
#include "derivatives/descriptions.gen.hpp"
#include "dynamics/descriptions.gen.hpp"
#include "estimate/descriptions.gen.hpp"
#include "model/descriptions.gen.hpp"
#include "mpc/descriptions.gen.hpp"
#include "ocp/descriptions.gen.hpp"
#include "report/descriptions.hpp"
#include "sim/descriptions.gen.hpp"
#include "solver/descriptions.gen.hpp"

namespace burnish {

const Description& description_of(const AdmittanceGains*);
const Description& description_of(const AdmittanceSpec*);
const Description& description_of(const HomeSpec*);
const Description& description_of(const HomeMove*);
const Description& description_of(const ImpedanceGains*);
const Description& description_of(const ImpedanceSpec*);
const Words& words_of(PlantKind);
const Description& description_of(const TaskPoint*);
const Description& description_of(const CirclePath*);
const Description& description_of(const PressingPath*);
const Words& words_of(Touch);
const Description& description_of(const ToolLimits*);
const Description& description_of(const PlanLimits*);
const Description& description_of(const TaskTarget*);
const Description& description_of(const PressedSurface*);
const Description& description_of(const PressingTask*);
const Description& description_of(const ReachOptions*);
const Words& words_of(ReachProblem);
const Description& description_of(const ReachReport*);
const Description& description_of(const PostureLimits*);
const Description& description_of(const PostureOptions*);
const Description& description_of(const FoundPosture*);
const Description& description_of(const Standing*);

}  // namespace burnish
