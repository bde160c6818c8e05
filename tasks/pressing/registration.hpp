// Parts that the structs Registration of all tasks have in common. The header NAME/descriptions.hpp
// of a task declares a struct Registration, which is derived from TaskTypes and has these members:
// - name: the word in the key `task` of task files, and name of the Python module;
// - does: what the task does, after its name in help texts;
// - file: a shipped task file, for examples;
// - phases(): names of the phases;
// - each_result(see): calls see(name, member, text) for each member of the result that only this
//   task has; Python shows these members.
// In addition, the header declares two functions: file_of() returns the description of the task
// file, and recorded() returns what the files and the page of a run contain. Programs also call
// these functions of every task: check_task(), task_text(), task_notes(), load_task_robot(),
// make_setting(), make_mpc(), refuse_out_of_reach() and run_task().
#pragma once

#include <string>
#include <vector>

#include "files/described_file.hpp"

namespace burnish::pressing {

template <class RunSpec>
struct NamedRun;
struct RecordedRun;

/// Types of a task. The type of an argument selects the function of the task, as an overload.
template <class TaskType, class SettingType, class RunSpecType, class RunResultType>
struct TaskTypes {
  using Task = TaskType;
  using Setting = SettingType;
  using RunSpec = RunSpecType;
  using RunResult = RunResultType;
};

}  // namespace burnish::pressing
