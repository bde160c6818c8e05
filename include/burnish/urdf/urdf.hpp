// Reading URDF.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Reads a URDF file: from a disk, or once from a pipe or /dev/stdin. Throws Error when the file is
/// missing, malformed or describes no tree; it names the file and lists all problems in it, each
/// with its line and its link or joint. What is odd but usable is in the result's `warnings`; what
/// dynamics does not need, such as colours, stops nothing.
TreeSpec read_urdf(const std::filesystem::path& file);

/// The same from a string; `source` stands for the file's name in error sentences, and its stem for
/// the name of a robot that has none.
TreeSpec parse_urdf(const std::string& xml, const std::string& source = "<string>");

}  // namespace burnish
