// Texts of the bundled task files at build time, so that experiments need no files.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"

namespace burnish::polishing {

/// Returns the names (without extension) and the texts of the files in tasks/polishing.
const std::vector<std::pair<std::string_view, std::string_view>>& shipped_task_texts();

/// Returns the names (without extension) and the texts of the files in tasks/stand.
const std::vector<std::pair<std::string_view, std::string_view>>& shipped_stand_texts();

/// Returns the text of public_robots.yaml, the list in this folder.
std::string_view public_robots_text();

/// Returns a bundled polishing task. Throws Error for an unknown name.
Task shipped_task(const std::string& name);

}  // namespace burnish::polishing
