// A problem file behind its text.
#pragma once

#include "burnish/files/problem_file.hpp"
#include "files/reader.hpp"

namespace burnish::files {

/// `folder`: where relative names are looked up.
ProblemFile read_problem(const Reader& top, const std::filesystem::path& folder);

}  // namespace burnish::files
