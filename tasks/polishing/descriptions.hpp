// What the task's specifications hold.
#pragma once

#include "base/description.hpp"
#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

const Words& words_of(PathKind);
const Words& words_of(ForceAxes);
const Description& description_of(const PathSpec*);
const Description& description_of(const PlanarPoint*);
const Description& description_of(const Weights*);
const Description& description_of(const Verdict*);
const Description& description_of(const PostureLimits*);
const Description& description_of(const Task*);

}  // namespace burnish::polishing
