// What specifications and reports of runs hold; figures, by their table: pressing/figures.hpp.
#pragma once

#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "pressing/descriptions.hpp"

namespace burnish {

const Description& description_of(const TickTimes*);
const Words& words_of(ReachProblem);
const Description& description_of(const ReachOptions*);
const Description& description_of(const ReachReport*);
const Description& description_of(const HomeMove*);
const Description& description_of(const PostureOptions*);
const Description& description_of(const FoundPosture*);

}  // namespace burnish
