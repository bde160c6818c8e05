// What is possible in a task, but probably not meant.
#pragma once

#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"

namespace burnish::polishing {

/// Sentences for the user before a run on this plant; none if nothing is odd. Throws nothing for a
/// task that check_task() accepts.
std::vector<std::string> task_notes(const Task& task, PlantKind plant);

}  // namespace burnish::polishing
