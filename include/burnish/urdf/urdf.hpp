// Reader of URDF files.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/base/error.hpp"
#include "burnish/model/tree_spec.hpp"

namespace burnish {

/// Reads a URDF file. The file is read once, so it can be a pipe or /dev/stdin. Throws Error if the
/// file is missing, is malformed or does not describe a tree. The Error names the file and lists
/// all problems, each with the line and the link or joint. Odd but usable content becomes a
/// sentence in `warnings` of the result. Content that dynamics does not need, such as colours,
/// never causes an Error.
TreeSpec read_urdf(const std::filesystem::path& file);

/// Reads URDF from the text `xml` and throws Error as read_urdf() does. Error messages refer to the
/// text by the name `source`. A robot without a name gets the stem of `source` as its name.
TreeSpec parse_urdf(const std::string& xml, const std::string& source = "<string>");

}  // namespace burnish
