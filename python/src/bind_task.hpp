// Bindings common to tasks: reading, checking and writing task files, setting, controller, runs.
#pragma once

#include "files/described_file.hpp"
#include "loop_parts.hpp"
#include "task_run.hpp"
#ifdef BURNISH_HAS_RECORD
#include "burnish/mpc/mpc.hpp"
#include "pressing/recorded_run.hpp"
#endif

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

inline const std::string task_setting_doc =
    R"(Resolves a task: loads its robot, and finds its start and frames.

Parameters
----------
task : Task

Returns
-------
Setting

Raises
------
Error
    )";

inline constexpr const char* task_controller_doc =
    R"(Makes the controller of a task, for a loop of your own.

Parameters
----------
task : Task
setting : Setting

Returns
-------
MpcController
    Controller. The phases of its schedule are phase_names().)";

inline const std::string task_run_doc =
    R"(Runs a task in simulated time. Ctrl-C interrupts the run.

Parameters
----------
spec : RunSpec

Returns
-------
RunResult
    Result. Faults are in the result, with the data recorded until then.

Raises
------
Error
    If the task is contradictory, )";

/// Names and texts of a task for its bindings.
struct TaskName {
  std::string task;     ///< Name of the task, such as "press_hold"
  std::string prefix;   ///< Prefix of the task's functions in _core, such as "hold_"
  std::string result;   ///< Class of the task's results, such as "HoldResult"
  std::string outcome;  ///< Docstring of RunResult.outcome
  std::string setting;  ///< Condition under which make_setting() raises Error
  /// Condition under which run_task() raises Error, in addition to a contradictory task
  std::string refused;
};

/// Types of a task. Overloads on these types select the functions of the task.
template <class TaskType, class SettingType, class RunSpecType, class RunResultType>
struct TaskTypes {
  using Task = TaskType;
  using Setting = SettingType;
  using Result = RunResultType;
  using Run = MadeRun<RunSpecType, RunResultType>;
};

/// Returns the state of a run for pickling. `own(see)` must call see(name, member, text) for each
/// entry of the result that only this task has.
template <class Spec, class Own>
py::tuple state_of_run(const typename Spec::Run& run, const Own& own) {
  py::list values;
  own([&](const char*, auto member, const char*) { values.append(py::cast(run.result.*member)); });
  return py::make_tuple(run.spec, state_of(run.result), run.result.setting, run.result.done,
                        values);
}

template <class Spec, class Own>
typename Spec::Run run_of_state(const py::tuple& state, const Own& own) {
  typename Spec::Run run{py::cast<decltype(Spec::Run::spec)>(state[0]), {}};
  set_state(run.result, state[1]);
  run.result.setting = py::cast<typename Spec::Setting>(state[2]);
  run.result.done = py::cast<bool>(state[3]);
  const py::list values = state[4];
  std::size_t next = 0;
  own([&](const char*, auto member, const char*) {
    run.result.*member = py::cast<std::decay_t<decltype(run.result.*member)>>(values[next++]);
  });
  return run;
}

template <class Spec, class Own>
void bind_task_result(py::module_& m, const TaskName& name, const Own& own) {
  using Run = typename Spec::Run;
  py::class_<Run> of(m, name.result.c_str(),
                     ("Result of a run of " + name.task +
                      ". Views of the columns of its trace keep the result alive.")
                         .c_str());
  bind_task_run(of, name.outcome.c_str());
  add_result(of, "setting", &Spec::Result::setting, "Setting of the task, a copy.");
  add_result(of, "done", &Spec::Result::done, "True if the run reached its end without a fault.");
  own([&](const char* entry, auto member, const char* text) {
    add_result(of, entry, member, text);
  });
  of.def("__repr__",
         [task = name.task](const Run& run) {
           return "<RunResult: " + task + " on " + name_of(run.spec.plant) + "; " +
                  run.result.outcome + ">";
         })
      .def(py::pickle([own](const Run& run) { return state_of_run<Spec>(run, own); },
                      [own](const py::tuple& state) { return run_of_state<Spec>(state, own); }));
#ifdef BURNISH_HAS_RECORD
  const auto write = [](const Run& run, const std::string& as, const RunFilesOptions& options,
                        const std::filesystem::path& folder, PageWriter& pages) {
    const pressing::NamedRun<decltype(run.spec)> named{.name = as, .spec = run.spec};
    return pressing::write_run(recorded(named, run.result), options, folder, pages);
  };
  bind_write(of, write, "burnish run");
#else
  bind_write(of, nullptr, "burnish run");
#endif
}

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

/// Binds the functions for settings, controllers and runs.
template <class Spec>
void bind_task_functions(py::module_& m, const TaskName& name) {
  using Task = typename Spec::Task;
  using Setting = typename Spec::Setting;
  using Run = typename Spec::Run;
  const auto def = [&](const char* function, const auto& call, const auto&... more) {
    m.def((name.prefix + function).c_str(), call, more...);
  };
  def(
      "make_setting", [](const Task& task) { return make_setting(task); }, py::arg("task"),
      py::call_guard<py::gil_scoped_release>(), (task_setting_doc + name.setting).c_str());
  def(
      "make_controller",
      [](const Task& task, const Setting& setting) {
        return std::make_unique<BoundMpc>(make_mpc(task, setting));
      },
      py::arg("task"), py::arg("setting"), task_controller_doc);
  const std::string module = "burnish." + name.task;
  def(
      "run_task", [module](const py::object& spec) { return run_given<Run>(spec, module.c_str()); },
      py::arg("spec"), (task_run_doc + name.refused).c_str());
}

/// Adds all bindings of a task, and adds its name to the list of tasks that task files can select.
template <class Spec, class Own>
void bind_task(py::module_& m, const TaskName& name, const Own& own) {
  bind_task_result<Spec>(m, name, own);
  using Task = typename Spec::Task;
  const auto read = [](const std::filesystem::path& file,
                       const std::vector<std::string>& overrides) {
    const auto said = files::read_said<Task>(file, overrides);
    files::placed(said.texts, [&] { check_task(said.spec); });
    return said.spec;
  };
  bind_task_file<Task>(m, name.prefix, read, "Reads a task file with `task: " + name.task + "`.");
  bind_task_functions<Spec>(m, name);
  constexpr const char* all = "_named_tasks";
  if (!py::hasattr(m, all)) m.attr(all) = py::list();
  py::list(m.attr(all)).append(name.task);
}

}  // namespace burnish::python
