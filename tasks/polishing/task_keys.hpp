// The keys of a task file: one table from which files are read and written.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"
#include "files/reader.hpp"

namespace burnish::polishing {

struct TaskKey {
  std::string name;
  std::string meaning;  ///< the comment behind it, with the unit
  std::function<void(Task&, const document::Reader&)> read;
  /// The value in YAML, or nothing where the key is not written.
  std::function<std::optional<std::string>(const Task&)> write;
};

struct TaskSection {
  std::string name;  ///< empty: keys of the file itself
  std::string meaning;
  std::vector<TaskKey> keys;
  /// Key that a single word in place of the section's keys is the value of; or empty.
  std::string word_is = {};
};

/// In the order in which a file is written. Keys of a section are read in their order here.
const std::vector<TaskSection>& task_sections();

/// Reads what the file states, over the task.
void read_sections(Task& task, const document::Reader& file);

}  // namespace burnish::polishing
