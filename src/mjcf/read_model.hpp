// Entry point of the MJCF reader for a text in memory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "burnish/model/tree_spec.hpp"

namespace burnish::mjcf {

/// Reads a model from text, like read_mjcf(). Files that the text names are searched in `folder`;
/// without a folder, no file is opened.
TreeSpec read_model(const std::string& xml, const std::string& name,
                    std::optional<std::filesystem::path> folder);

}  // namespace burnish::mjcf
