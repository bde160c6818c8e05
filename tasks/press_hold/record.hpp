// Data of a press_hold run that its files and its HTML page contain.
#pragma once

#include "burnish/tasks/press_hold/press_hold.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::press_hold {

using RunName = pressing::NamedRun<RunSpec>;

pressing::RecordedRun recorded(const RunName& run, const RunResult& result);

}  // namespace burnish::press_hold
