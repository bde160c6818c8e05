// Reading URDF.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Reads a URDF file. Throws Error with one sentence naming the file, the element and the reason
/// when the file is missing, malformed or describes no tree of physical bodies.
TreeSpec read_urdf(const std::filesystem::path& file);

/// The same from a string; `source` stands for the file's name in error sentences.
TreeSpec parse_urdf(const std::string& xml, const std::string& source = "<string>");

}  // namespace burnish
