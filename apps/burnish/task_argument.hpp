// Task files on the command line, and names of their runs.
#pragma once

#include <string>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::app {

/// Name of the surface of a task, for its runs: `surface`, or a description of the surface if
/// settings change its normal or shape, such as "tilt_30_sphere".
std::string place_name(const std::string& surface, const polishing::Task& task);

/// Throws Error if `file` is a robot instead of a task file; the message names `option`, which
/// takes a robot.
void refuse_robot(const std::string& file, const std::string& option);

}  // namespace burnish::app
