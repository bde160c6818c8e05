// Record of a press_hold run, for the files of the run and its HTML page.
#pragma once

#include "burnish/tasks/press_hold/press_hold.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::press_hold {

using RunName = pressing::NamedRun<RunSpec>;

pressing::RecordedRun recorded(const RunName& run, const RunResult& result);

}  // namespace burnish::press_hold
