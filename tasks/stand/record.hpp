// Data of a stand run that its files and its HTML page contain.
#pragma once

#include "burnish/tasks/stand/stand.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::stand {

using RunName = pressing::NamedRun<RunSpec>;

pressing::RecordedRun recorded(const RunName& run, const RunResult& result);

}  // namespace burnish::stand
