// Conversion between YAML or JSON text and trees of nodes.
#pragma once

#include <string>

#include "document/node.hpp"

namespace burnish::document {

/// Parses YAML. Messages call the text `name`. An empty text gives a Null node. Bytes that are not
/// UTF-8 are kept. Throws Error if the text
/// - is not valid YAML, is too large or nested too deep,
/// - has several documents or a key twice,
/// - has aliases that are recursive or expand to too many values.
Node parse_yaml(const std::string& text, const std::string& name);

/// Parses JSON. Messages call the text `name`. Throws Error if the text is not valid JSON, is too
/// large or nested too deep, has a key twice, or has a number too large for a double.
Node parse_json(const std::string& text, const std::string& name);

/// Writes a tree as JSON on one line. Bytes that are not UTF-8 are kept; the result is then not
/// valid JSON.
std::string json_text(const Node& node);
/// Writes a tree as YAML on one line. Quotes only texts that YAML could read as another kind of
/// value.
std::string yaml_text(const Node& node);
/// Writes the shortest text that reads back as the same value. Magnitudes from 1e-4 to 1e9 have no
/// exponent.
std::string number_text(double value);

/// Returns the kind of a YAML scalar without quotes. "inf" and "nan" are numbers.
Kind kind_of_plain(const std::string& text);

}  // namespace burnish::document
