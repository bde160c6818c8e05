// Parts that the registrations of all tasks have in common. The header NAME/descriptions.hpp of a
// task declares a struct Registration, which is derived from TaskTypes and has these members:
// - name: the word in the key `task` of task files, and name of the Python module;
// - does: what the task does, after its name in help texts;
// - file: a shipped task file, for examples;
// - phases(): names of the phases;
// - each_result(see): calls see(name, member, text) for each member of the result that only this
//   task has; Python shows these members.
// In addition, the header declares file_of(), recorded() and the descriptions of its figures.
#pragma once

#include <string>
#include <vector>

#include "files/described_file.hpp"

namespace burnish::pressing {

template <class RunSpec>
struct NamedRun;
struct RecordedRun;

/// Types of a task. Overloads on these types select the functions of the task.
template <class TaskType, class SettingType, class RunSpecType, class RunResultType>
struct TaskTypes {
  using Task = TaskType;
  using Setting = SettingType;
  using RunSpec = RunSpecType;
  using RunResult = RunResultType;
};

}  // namespace burnish::pressing
