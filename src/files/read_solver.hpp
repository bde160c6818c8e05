// Reads solver options and the solver's initial guess from a problem file.
#pragma once

#include "burnish/files/problem_file.hpp"
#include "files/reader.hpp"

namespace burnish::files {

DdpOptions read_solver(const Reader& reader);
/// Reads the key `guess`. `folder` is the folder of the problem file.
WarmStart read_guess(const Reader& reader, const std::filesystem::path& folder);

}  // namespace burnish::files
