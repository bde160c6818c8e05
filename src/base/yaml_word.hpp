// Quotes text for YAML files.
#pragma once

#include <string>

namespace burnish {

/// Returns a name or a path as a YAML value or key. The result has quotes if YAML could read the
/// bare text as another type. Bytes that are not UTF-8 are kept.
std::string yaml_word(const std::string& text);

}  // namespace burnish
