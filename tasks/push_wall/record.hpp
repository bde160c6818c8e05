// Data of a push_wall run that its files and its HTML page contain.
#pragma once

#include "burnish/tasks/push_wall/push_wall.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::push_wall {

using RunName = pressing::NamedRun<RunSpec>;

pressing::RecordedRun recorded(const RunName& run, const RunResult& result);

}  // namespace burnish::push_wall
