// Names of version 0.3 that have changed since: keys of files, words, Python keywords, columns of
// traces and figures. Readers refuse an old name with the new one; pages of old runs are read.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace burnish {

/// A name of version 0.3 and the name that replaced it.
struct Rename {
  std::string_view old_name, new_name;
};

/// Returns all renames. An old name occurs twice if its meaning depended on the place.
std::span<const Rename> renames();

/// Returns the name that replaced `old_name` and is one of `known`. Empty: there is none.
std::string_view replacement(std::string_view old_name, const std::vector<std::string>& known);

/// Returns the current name of a trace column or figure of version 0.3. Returns `name` itself if it
/// has not changed.
std::string_view current_column(std::string_view name);

/// Returns the current name of a phase of a task of version 0.3. Returns `name` itself if it has
/// not changed.
std::string_view current_phase(std::string_view name);

}  // namespace burnish
