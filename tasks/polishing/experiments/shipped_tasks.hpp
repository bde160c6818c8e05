// Task files that come along, as they were when this program was built: experiments that repeat
// them look for no file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// Names of files in tasks/polishing, without ending, and their texts.
const std::vector<std::pair<std::string_view, std::string_view>>& shipped_task_texts();

/// Names of files in tasks/stand, without ending, and their texts.
const std::vector<std::pair<std::string_view, std::string_view>>& shipped_stand_texts();

/// The list public_robots.yaml beside this file.
std::string_view public_robots_text();

/// A polishing task of those that come along. Throws Error for a name that there is not.
Task shipped_task(const std::string& name);

}  // namespace burnish::polishing
