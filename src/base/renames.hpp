// Names from version 0.3 that have been replaced: keys of files, words, keywords and attributes of
// Python, columns of traces, and statistics of runs. Readers and the Python package reject an old
// name and state the new one. Reports of runs from version 0.3 accept old names.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace burnish {

/// A name of version 0.3 and the name that replaced it.
struct Rename {
  std::string_view old_name, new_name;
};

/// Returns all renames. An old name with two meanings occurs twice.
std::span<const Rename> renames();

/// Returns the name that replaced `old_name` and is one of `known`. Empty if there is no such name.
std::string_view replacement(std::string_view old_name, const std::vector<std::string>& known);

/// Returns the current name of a trace column or statistic that version 0.3 called `name`. Returns
/// `name` itself if it has not changed.
std::string_view current_column(std::string_view name);

/// Returns the current name of the task phase that version 0.3 called `name`. Returns `name` itself
/// if it has not changed.
std::string_view current_phase(std::string_view name);

}  // namespace burnish
