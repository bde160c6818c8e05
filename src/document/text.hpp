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

/// A tree in one line. Bytes that are no UTF-8 stay, which JSON does not know.
std::string json_text(const Node& node);
/// The same with quotes only where a text could be read as something else.
std::string yaml_text(const Node& node);
/// The shortest that reads back as it was: plain from 1e-4 to 1e9.
std::string number_text(double value);

/// What YAML takes a scalar without quotes for. "inf" and "nan" are numbers.
Kind kind_of_plain(const std::string& text);

}  // namespace burnish::document
