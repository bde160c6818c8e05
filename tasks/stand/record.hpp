// Record of a stand run, for the files of the run and its HTML page.
#pragma once

#include "burnish/tasks/stand/stand.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::stand {

using RunName = pressing::NamedRun<RunSpec>;

pressing::RecordedRun recorded(const RunName& run, const RunResult& result);

}  // namespace burnish::stand
