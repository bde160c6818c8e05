// A task that its file names, as Python has it: reading, checking and writing its file, its setting
// and controller, its runs. What is the same of all tasks is here; each says its own.
#pragma once

#include "files/described_file.hpp"
#include "loop_parts.hpp"
#include "task_run.hpp"
#ifdef BURNISH_HAS_RECORD
#include "pressing/recorded_run.hpp"
#endif

namespace burnish::python {

/// What is said of a task.
struct TaskName {
  std::string task;     ///< "press_hold"
  std::string prefix;   ///< "hold_", of its functions in _core
  std::string result;   ///< "HoldResult", of its runs
  std::string outcome;  ///< what RunResult.outcome says
  std::string setting;  ///< for what a setting is refused
  std::string refused;  ///< for what a run is refused, beside a task that does not fit together
};

/// The types of a task, whose functions are found by them.
template <class TaskType, class SettingType, class RunSpecType, class RunResultType>
struct TaskTypes {
  using Task = TaskType;
  using Setting = SettingType;
  using Result = RunResultType;
  using Run = MadeRun<RunSpecType, RunResultType>;
};

/// `own` calls see(name, member, text) for what a result has of its own.
template <class Of, class Own>
py::tuple state_of_run(const typename Of::Run& run, const Own& own) {
  py::list values;
  own([&](const char*, auto member, const char*) { values.append(py::cast(run.result.*member)); });
  return py::make_tuple(run.spec, state_of(run.result), run.result.setting, run.result.done,
                        values);
}

template <class Of, class Own>
typename Of::Run run_of_state(const py::tuple& state, const Own& own) {
  typename Of::Run run{py::cast<decltype(Of::Run::spec)>(state[0]), {}};
  set_state(run.result, state[1]);
  run.result.setting = py::cast<typename Of::Setting>(state[2]);
  run.result.done = py::cast<bool>(state[3]);
  const py::list values = state[4];
  std::size_t next = 0;
  own([&](const char*, auto member, const char*) {
    run.result.*member = py::cast<std::decay_t<decltype(run.result.*member)>>(values[next++]);
  });
  return run;
}

template <class Of, class Own>
void bind_task_result(py::module_& m, const TaskName& name, const Own& own) {
  using Run = typename Of::Run;
  py::class_<Run> of(m, name.result.c_str(),
                     ("What came out of a run of " + name.task +
                      ". Its trace stays where it is: views of its columns keep the result alive.")
                         .c_str());
  bind_task_run(of, name.outcome.c_str());
  add_result(of, "setting", &Of::Result::setting,
             "Setting: the task with everything resolved; a copy.");
  add_result(of, "done", &Of::Result::done, "Whether the end was reached without fault.");
  own([&](const char* entry, auto member, const char* text) {
    add_result(of, entry, member, text);
  });
  of.def("__repr__",
         [task = name.task](const Run& run) {
           return "<RunResult: " + task + " on " + name_of(run.spec.plant) + "; " +
                  run.result.outcome + ">";
         })
      .def(py::pickle([own](const Run& run) { return state_of_run<Of>(run, own); },
                      [own](const py::tuple& state) { return run_of_state<Of>(state, own); }));
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

/// Its file. `reads`: what a file is, in a sentence's first half; `read`: reads one.
template <class Task, class Read>
void bind_task_file(py::module_& m, const std::string& prefix, const Read& read,
                    const std::string& reads) {
  const auto def = [&](const char* function, const auto& call, const auto&... more) {
    m.def((prefix + function).c_str(), call, more...);
  };
  const std::string text =
      reads +
      "; keys that it does not state keep their defaults. Overrides are applied after it, in "
      "order, each \"key.path=value\" with a value in YAML. Raises Error naming file (or "
      "override), line, key and what was wanted.";
  def("read_task", read, py::arg("file"), py::arg("overrides") = std::vector<std::string>{},
      text.c_str());
  def(
      "override_task",
      [](Task task, const std::vector<std::string>& overrides) {
        override_task(task, overrides);
        return task;
      },
      py::arg("task"), py::arg("overrides"),
      "A copy of the task with overrides applied. Raises Error as read_task() does.");
  def(
      "check_task", [](const Task& task) { check_task(task); }, py::arg("task"),
      "Raises Error with a sentence for numbers out of range, and for those that are possible each "
      "but not together.");
  def(
      "task_text", [](const Task& task) { return task_text(task); }, py::arg("task"),
      "The task as a file, every key with its unit and meaning; reads back as it was.");
  def(
      "task_units", [] { return file_of(static_cast<const Task*>(nullptr)).units(); },
      "Units of the keys of task files that have one, by the keys' paths.");
}

/// Its setting, controller and runs.
template <class Of>
void bind_task_functions(py::module_& m, const TaskName& name) {
  using Task = typename Of::Task;
  using Setting = typename Of::Setting;
  using Run = typename Of::Run;
  const auto def = [&](const char* function, const auto& call, const auto&... more) {
    m.def((name.prefix + function).c_str(), call, more...);
  };
  def(
      "make_setting", [](const Task& task) { return make_setting(task); }, py::arg("task"),
      py::call_guard<py::gil_scoped_release>(),
      ("Setting of a task. Raises Error for " + name.setting + ".").c_str());
  def(
      "make_controller",
      [](const Task& task, const Setting& setting) {
        return std::make_unique<BoundMpc>(make_mpc(task, setting));
      },
      py::arg("task"), py::arg("setting"),
      "MpcController of the task, for a loop of your own. Its schedule's phases are "
      "phase_names().");
  const std::string module = "burnish." + name.task;
  def(
      "run_task", [module](const py::object& spec) { return run_given<Run>(spec, module.c_str()); },
      py::arg("spec"),
      ("Runs a task (RunSpec) to its end in simulated time. What goes wrong on the way is in the "
       "result, with all that was recorded until then; Ctrl-C ends the run as in other Python "
       "code. Raises Error for a task that does not fit together, " +
       name.refused + ".")
          .c_str());
}

/// All of that; the module then knows it as a task that files name.
template <class Of, class Own>
void bind_task(py::module_& m, const TaskName& name, const Own& own) {
  bind_task_result<Of>(m, name, own);
  using Task = typename Of::Task;
  const auto read = [](const std::filesystem::path& file,
                       const std::vector<std::string>& overrides) {
    const auto said = files::read_said<Task>(file, overrides);
    files::placed(said.texts, [&] { check_task(said.spec); });
    return said.spec;
  };
  bind_task_file<Task>(m, name.prefix, read, "Reads a file with `task: " + name.task + "`");
  bind_task_functions<Of>(m, name);
  constexpr const char* all = "_named_tasks";
  if (!py::hasattr(m, all)) m.attr(all) = py::list();
  py::list(m.attr(all)).append(name.task);
}

}  // namespace burnish::python
