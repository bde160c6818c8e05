// Texts as YAML reads them back.
#pragma once

#include <string>

namespace burnish {

/// A name or a path for a YAML file, as a value or a key: in quotes where it could be read as
/// something else. Bytes that are no UTF-8 stay as they are.
std::string yaml_word(const std::string& text);

}  // namespace burnish
