// YAML as a tree of nodes that can be walked: no aliases without end.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

namespace burnish {

/// Throws Error, calling the text `name`, where it is no YAML, is too large, or is endless or as
/// good as endless because aliases stand for what holds aliases.
YAML::Node parse_yaml(const std::string& text, const std::string& name);

}  // namespace burnish
