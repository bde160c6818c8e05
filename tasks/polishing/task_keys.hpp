// The keys of a task file: one table from which files are read and written.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/task.hpp"
#include "files/yaml_reader.hpp"

namespace burnish::polishing {

struct TaskKey {
  std::string name;
  std::string meaning;  ///< the comment behind it, with the unit
  std::function<void(Task&, const files::YamlReader&)> read;
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
std::vector<TaskSection> where_sections();       ///< robot, tool, surface, path, phases
std::vector<TaskSection> controller_sections();  ///< horizon, weights, model error, limits
TaskSection disturbances_section();

/// Reads what the file states, over the task.
void read_sections(Task& task, const files::YamlReader& file);

/// Values in YAML that read back as they were.
std::string yaml(double value);
std::string yaml(const std::string& text);  ///< in quotes where it could be read as something else
std::string yaml(const Eigen::Ref<const Eigen::VectorXd>& values);

/// The entry of a task that a chain of members leads to.
template <class... Members>
auto at(Members... members) {
  return [=](Task & task) -> auto& { return (task.*....*members); };
}

enum class Range { Any, NotNegative, Positive, PositiveOrNever, Share };

TaskKey number_key(const char* name, const char* meaning, Range range,
                   const std::function<double&(Task&)>& entry);
TaskKey count_key(const char* name, const char* meaning, int least,
                  const std::function<int&(Task&)>& entry);
TaskKey flag_key(const char* name, const char* meaning, const std::function<bool&(Task&)>& entry);
/// Not written while it is empty.
TaskKey text_key(const char* name, const char* meaning,
                 const std::function<std::string&(Task&)>& entry);

/// One of `words`, in the order of the enumeration's values.
template <class Entry>
TaskKey word_key(const char* name, const char* meaning, const std::vector<std::string>& words,
                 Entry entry) {
  return {name, meaning,
          [words, entry](Task& task, const files::YamlReader& reader) {
            auto& value = entry(task);
            const std::string word = reader.word(words);
            for (std::size_t i = 0; i < words.size(); ++i)
              if (words[i] == word) value = static_cast<std::decay_t<decltype(value)>>(i);
          },
          [words, entry](const Task& task) -> std::optional<std::string> {
            Task copy = task;
            return words[static_cast<std::size_t>(entry(copy))];
          }};
}

}  // namespace burnish::polishing
