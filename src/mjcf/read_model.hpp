// The door of the reader of MJCF for those who have the text already.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "burnish/model/tree_spec.hpp"

namespace burnish::mjcf {

/// read_mjcf of a text. Files that it names are looked for in `folder`, or not at all.
TreeSpec read_model(const std::string& xml, const std::string& name,
                    std::optional<std::filesystem::path> folder);

}  // namespace burnish::mjcf
