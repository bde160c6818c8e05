// Table of the tasks that a task file can select with its key `task`. The command `burnish run`,
// its help and its shell completion are made from this table. The types Task and RunSpec of an
// entry select overloads such as run_task().
#pragma once

#include <string>
#include <vector>

#include "press_hold/descriptions.hpp"
#include "push_wall/descriptions.hpp"
#include "stand/descriptions.hpp"

namespace burnish {

template <class TaskType, class RunSpecType>
struct NamedTask {
  using Task = TaskType;
  using RunSpec = RunSpecType;
  const char* name;
  const char* does;  ///< Summary that follows the name in help texts.
};

/// Calls see(NamedTask) for each task.
template <class See>
void each_named_task(const See& see) {
  see(NamedTask<press_hold::Task, press_hold::RunSpec>{
      "press_hold",
      "presses at a point and holds the force while the rest of the arm moves aside"});
  see(NamedTask<push_wall::Task, push_wall::RunSpec>{
      "push_wall", "pushes with both hands against a wall, and searches for the largest force"});
  see(NamedTask<stand::Task, stand::RunSpec>{
      "stand", "stands on its feet, sways with the trunk and comes back to rest"});
}

inline std::vector<std::string> task_names() {
  std::vector<std::string> names;
  each_named_task([&](const auto& task) { names.push_back(task.name); });
  return names;
}

}  // namespace burnish
