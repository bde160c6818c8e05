// Bindings of task files: reading, checking and writing.
#pragma once

#include "files/described_file.hpp"
#include "loop_parts.hpp"
#include "task_run.hpp"

namespace burnish::python {

// Docstrings.

inline constexpr const char* override_task_doc = R"(Returns a copy of a task with overrides.

Parameters
----------
task : Task
overrides : sequence of str
    Changes as for read_task().

Returns
-------
Task

Raises
------
Error
    If an override is invalid.)";

inline constexpr const char* check_task_doc = R"(Checks a task.

Parameters
----------
task : Task

Raises
------
Error
    If a number is out of range, or values contradict each other.)";

inline constexpr const char* task_text_doc =
    R"(Returns the text of a task file with all keys, their units and meanings.

Parameters
----------
task : Task

Returns
-------
str
    Text from which read_task() reads an equal task.)";

/// Binds the functions for task files. `read`: function that reads a file; `reads`: first sentence
/// of its docstring.
template <class Task, class Read>
void bind_task_file(py::module_& m, const std::string& prefix, const Read& read,
                    const std::string& reads) {
  const auto def = [&](const char* function, const auto& call, const auto&... more) {
    m.def((prefix + function).c_str(), call, more...);
  };
  const std::string text =
      reads +
      " Missing keys have their defaults.\n\n"
      "Parameters\n----------\nfile : str or Path\noverrides : sequence of str\n"
      "    Changes \"key.path=value\" with values in YAML, applied in order.\n\n"
      "Returns\n-------\nTask\n\n"
      "Raises\n------\nError\n"
      "    If the file or an override is invalid; the message has line, key and requirement.";
  def("read_task", read, py::arg("file"), py::arg("overrides") = std::vector<std::string>{},
      text.c_str());
  def(
      "override_task",
      [](Task task, const std::vector<std::string>& overrides) {
        override_task(task, overrides);
        return task;
      },
      py::arg("task"), py::arg("overrides"), override_task_doc);
  def(
      "check_task", [](const Task& task) { check_task(task); }, py::arg("task"), check_task_doc);
  def(
      "task_text", [](const Task& task) { return task_text(task); }, py::arg("task"),
      task_text_doc);
  def(
      "task_units", [] { return file_of(static_cast<const Task*>(nullptr)).units(); },
      "Returns the units of the keys of task files, by the paths of the keys.");
}

}  // namespace burnish::python
