// Reads a problem from parsed YAML.
#pragma once

#include "burnish/files/problem_file.hpp"
#include "files/reader.hpp"

namespace burnish::files {

/// Reads a problem file. Relative names of files start from `folder`. Throws Error with the place.
ProblemFile read_problem(const Reader& top, const std::filesystem::path& folder);

}  // namespace burnish::files
