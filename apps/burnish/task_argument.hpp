// Task files on the command line, and names of their runs.
#pragma once

#include <string>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::app {

/// Name of a place to polish: that of the named surface, or where settings turn or bend it, of
/// what it became, such as "tilt_30_sphere".
std::string place_name(const std::string& surface, const polishing::Task& task);

/// Throws Error for a robot in the place of a task file; `option` is what takes one.
void refuse_robot(const std::string& file, const std::string& option);

}  // namespace burnish::app
