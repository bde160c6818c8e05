// Trees as text.
#pragma once

#include <string>

#include "document/node.hpp"

namespace burnish::document {

/// Throws Error, calling the text `name`, where it is no YAML, is too large or too deep, holds
/// several documents, states a key twice, or is endless or as good as endless because aliases stand
/// for what holds aliases. No text is an empty tree. Bytes that are no UTF-8 stay as they are.
Node parse_yaml(const std::string& text, const std::string& name);

/// Throws Error likewise. Numbers that are too large for a double are refused.
Node parse_json(const std::string& text, const std::string& name);

/// A tree in one line that is JSON and YAML alike: {"a": [1, 2]}. Bytes that are no UTF-8 stay.
std::string one_line(const Node& node);

/// What YAML takes a scalar without quotes for. "inf" and "nan" are numbers.
Kind kind_of_plain(const std::string& text);

}  // namespace burnish::document
