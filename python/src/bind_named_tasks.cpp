// Tasks that a task file can select, and their runs, from the registrations of the tasks.
#include "bind_task.hpp"
#include "named_tasks.hpp"
#include "specs_model.hpp"
#include "specs_pressing.hpp"
#ifdef BURNISH_HAS_RECORD
#include "burnish/mpc/mpc.hpp"
#include "pressing/recorded_run.hpp"
#endif

namespace burnish::python {

namespace {

// Docstrings.

constexpr const char* task_setting_doc =
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
    If the robot, its posture, or a frame or joint of the task is unknown, or no start is found.)";

constexpr const char* task_controller_doc =
    R"(Makes the controller of a task, for a loop of your own.

Parameters
----------
task : Task
setting : Setting

Returns
-------
MpcController
    Controller. The phases of its schedule are phase_names().)";

constexpr const char* task_run_doc = R"(Runs a task in simulated time. Ctrl-C interrupts the run.

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
    If the task is contradictory, the robot cannot do it, or this build does not have the plant.)";

constexpr const char* task_refuse_doc = R"(Checks by statics whether the robot can do the task.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).

Raises
------
Error
    If a target is out of reach, or limits of joints, feet or torques do not allow the task.)";

constexpr const char* task_check_reach_doc =
    R"(Checks by statics whether the arm can approach and press at the point.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).

Returns
-------
ReachReport)";

constexpr const char* task_fit_to_robot_doc = R"(Adapts a task to another robot.

Parameters
----------
task : Task
robot : Robot, optional
    Default: the robot of the task.

Returns
-------
tuple of Task and list of str
    Adapted task, and a sentence for each change.

Raises
------
Error
    In the cases of make_setting().)";

template <class Task>
using RunOf = MadeRun<typename Task::RunSpec, typename Task::RunResult>;

/// Returns the state of a run for pickling.
template <class Of>
py::tuple state_of_named_run(const RunOf<Of>& run) {
  py::list values;
  Of::each_result(
      [&](const char*, auto member, const char*) { values.append(py::cast(run.result.*member)); });
  return py::make_tuple(run.spec, state_of(run.result), run.result.setting, values);
}

template <class Of>
RunOf<Of> named_run_of(const py::tuple& state) {
  RunOf<Of> run{py::cast<typename Of::RunSpec>(state[0]), {}};
  set_state(run.result, state[1]);
  run.result.setting = py::cast<typename Of::Setting>(state[2]);
  const py::list values = state[3];
  std::size_t next = 0;
  Of::each_result([&](const char*, auto member, const char*) {
    run.result.*member = py::cast<std::decay_t<decltype(run.result.*member)>>(values[next++]);
  });
  return run;
}

template <class Of>
void bind_named_result(py::module_& m, const std::string& task) {
  using Run = RunOf<Of>;
  py::class_<Run> of(
      m, (task + "_RunResult").c_str(),
      ("Result of a run of " + task + ". Views of the columns of its trace keep the result alive.")
          .c_str());
  bind_task_run(of, "Sentence with the outcome: success or the fault, with its main figures.");
  add_result(of, "setting", &Of::RunResult::setting, "Setting of the task, a copy.");
  Of::each_result([&](const char* entry, auto member, const char* text) {
    add_result(of, entry, member, text);
  });
  of.def("__repr__", [task](const Run& run) {
      return "<RunResult: " + task + " on " + name_of(run.spec.plant) + "; " + run.result.outcome +
             ">";
    }).def(py::pickle(&state_of_named_run<Of>, &named_run_of<Of>));
#ifdef BURNISH_HAS_RECORD
  const auto write = [](const Run& run, const std::string& as, const RunFilesOptions& options,
                        const std::filesystem::path& folder, PageWriter& pages) {
    const pressing::NamedRun<typename Of::RunSpec> named{.name = as, .spec = run.spec};
    return pressing::write_run(recorded(named, run.result), options, folder, pages);
  };
  bind_write(of, write, "burnish run");
#else
  bind_write(of, nullptr, "burnish run");
#endif
}

/// Binds the functions for settings, controllers and runs.
template <class Of>
void bind_named_functions(py::module_& m, const std::string& task) {
  using Task = typename Of::Task;
  using Setting = typename Of::Setting;
  const auto def = [&](const char* function, const auto& call, const auto&... more) {
    m.def((task + "_" + function).c_str(), call, more...);
  };
  const auto release = py::call_guard<py::gil_scoped_release>();
  const auto setting_of = [](const Task& of, const std::optional<Setting>& setting) {
    return setting ? *setting : make_setting(of);
  };
  def(
      "make_setting", [](const Task& of) { return make_setting(of); }, py::arg("task"), release,
      task_setting_doc);
  def(
      "make_controller",
      [](const Task& of, const Setting& setting) {
        return std::make_unique<BoundMpc>(make_mpc(of, setting));
      },
      py::arg("task"), py::arg("setting"), task_controller_doc);
  def(
      "refuse_out_of_reach",
      [setting_of](const Task& of, const std::optional<Setting>& setting) {
        refuse_out_of_reach(of, setting_of(of, setting));
      },
      py::arg("task"), py::arg("setting") = py::none(), release, task_refuse_doc);
  if constexpr (requires(Task of, Setting setting) { check_reach(of, setting); })
    def(
        "check_reach",
        [setting_of](const Task& of, const std::optional<Setting>& setting) {
          return check_reach(of, setting_of(of, setting));
        },
        py::arg("task"), py::arg("setting") = py::none(), release, task_check_reach_doc);
  if constexpr (requires(Task of, Robot robot) { fit_to_robot(of, robot); })
    def(
        "fit_to_robot",
        [](Task of, const std::optional<Robot>& robot) {
          const std::vector<std::string> changes =
              fit_to_robot(of, robot ? *robot : load_task_robot(of));
          return std::pair(of, changes);
        },
        py::arg("task"), py::arg("robot") = py::none(), release, task_fit_to_robot_doc);
  const std::string module = "burnish." + task;
  def(
      "run_task",
      [module](const py::object& spec) { return run_given<RunOf<Of>>(spec, module.c_str()); },
      py::arg("spec"), task_run_doc);
  def(
      "phase_names", [] { return Of::phases(); },
      "Returns the names of the phases. The index of a name is the phase number in traces.");
}

/// Returns what scripts/describe needs to make the module of a task.
template <class Of>
py::dict registration_entries() {
  py::list results;
  Of::each_result([&](const char* entry, auto member, const char* /*text*/) {
    using Member = std::decay_t<decltype(std::declval<typename Of::RunResult>().*member)>;
    results.append(py::make_tuple(entry, type_entries(type_of<Member>())));
  });
  py::dict entries;
  entries["name"] = Of::name;
  entries["does"] = Of::does;
  entries["file"] = Of::file;
  entries["results"] = results;
  return entries;
}

}  // namespace

void bind_named_tasks(py::module_& m) {
  each_named_task([&](const auto& registration) {
    using Of = std::decay_t<decltype(registration)>;
    using Task = typename Of::Task;
    const std::string task = Of::name;
    bind_named_result<Of>(m, task);
    const auto read = [](const std::filesystem::path& file,
                         const std::vector<std::string>& overrides) {
      const auto said = files::read_said<Task>(file, overrides);
      files::placed(said.texts, [&] { check_task(said.spec); });
      return said.spec;
    };
    bind_task_file<Task>(m, task + "_", read, "Reads a task file with `task: " + task + "`.");
    bind_named_functions<Of>(m, task);
  });
  m.def(
      "named_tasks",
      [] {
        py::list all;
        each_named_task([&](const auto& registration) {
          all.append(registration_entries<std::decay_t<decltype(registration)>>());
        });
        return all;
      },
      "Returns the tasks that a task file can select: name, purpose, example file, and the types "
      "of the members that only their results have.");
}

}  // namespace burnish::python
