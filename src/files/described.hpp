// Described specifications as YAML: read strictly, written as they read back.
#pragma once

#include <optional>
#include <string>

#include "base/description.hpp"
#include "files/reader.hpp"

namespace burnish::files {

/// Refuses what the entry does not take, with the place.
void read_entry(const Field& field, void* spec, const Reader& reader);
/// The keys that are there; what no key can state is left as it is.
void read_described(const Description& description, void* spec, const Reader& reader);
/// On one line; nothing for an empty text, which is not written.
std::optional<std::string> entry_text(const Field& field, const void* spec);

}  // namespace burnish::files
