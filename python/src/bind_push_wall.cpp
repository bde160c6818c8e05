// The task of pushing with both hands against a wall, and its runs.
#include "loop_parts.hpp"
#include "push_wall/descriptions.hpp"
#include "specs_push_wall.hpp"
#include "task_run.hpp"
#ifdef BURNISH_HAS_RECORD
#include "push_wall/record.hpp"
#endif

namespace burnish::python {

namespace {

using namespace push_wall;
using PushRun = MadeRun<push_wall::RunSpec, push_wall::RunResult>;
using PushTask = push_wall::Task;
using PushSetting = push_wall::Setting;

py::tuple push_state(const PushRun& run) {
  const auto& r = run.result;
  return py::make_tuple(run.spec, state_of(r), r.setting, r.done, r.push, static_cast<int>(r.limit),
                        r.limited_by);
}

PushRun push_run_of(const py::tuple& state) {
  PushRun run{py::cast<push_wall::RunSpec>(state[0]), {}};
  set_state(run.result, state[1]);
  run.result.setting = py::cast<PushSetting>(state[2]);
  run.result.done = py::cast<bool>(state[3]);
  run.result.push = py::cast<std::optional<PushFigures>>(state[4]);
  run.result.limit = static_cast<Limit>(py::cast<int>(state[5]));
  run.result.limited_by = py::cast<std::string>(state[6]);
  return run;
}

void bind_push_result(py::module_& m) {
  py::class_<PushRun> of(m, "PushResult",
                         "What came out of a run of push_wall. Its trace stays where it is: views "
                         "of its columns keep the result alive.");
  bind_task_run(of, "One sentence: what it pushed with, or what came in between.");
  add_result(of, "setting", &push_wall::RunResult::setting,
             "Setting: the task with everything resolved; a copy.");
  add_result(of, "done", &push_wall::RunResult::done, "Whether the end was reached without fault.");
  add_result(of, "push", &push_wall::RunResult::push,
             "PushFigures; None where the hold did not come to its end.");
  add_result(of, "limit", &push_wall::RunResult::limit,
             "Limit: what ended the search for the largest force.");
  add_result(of, "limited_by", &push_wall::RunResult::limited_by,
             "The limits that plans kept nearest then, or which hand or foot slipped.");
  of.def("__repr__", [](const PushRun& run) {
      return "<RunResult: push_wall on " + name_of(run.spec.plant) + "; " + run.result.outcome +
             ">";
    }).def(py::pickle(&push_state, &push_run_of));
#ifdef BURNISH_HAS_RECORD
  const auto write = [](const PushRun& run, const std::string& name, const RunFilesOptions& options,
                        const std::filesystem::path& folder, PageWriter& pages) {
    return write_run({.name = name, .spec = run.spec}, run.result, options, folder, pages);
  };
  bind_write(of, write, "burnish run");
#else
  bind_write(of, nullptr, "burnish run");
#endif
}

}  // namespace

void bind_push_wall(py::module_& m) {
  bind_push_result(m);
  m.def("push_read_task", &push_wall::read_task, py::arg("file"),
        py::arg("overrides") = std::vector<std::string>{},
        "Reads a file with `task: push_wall`; keys that it does not state keep their defaults. "
        "Overrides are applied after it, in order, each \"key.path=value\" with a value in YAML. "
        "Raises Error naming file (or override), line, key and what was wanted.");
  m.def(
      "push_override_task",
      [](PushTask task, const std::vector<std::string>& overrides) {
        override_task(task, overrides);
        return task;
      },
      py::arg("task"), py::arg("overrides"),
      "A copy of the task with overrides applied. Raises Error as read_task() does.");
  m.def(
      "push_check_task", [](const PushTask& task) { check_task(task); }, py::arg("task"),
      "Raises Error with a sentence for numbers out of range, and for those that are possible each "
      "but not together.");
  m.def(
      "push_task_text", [](const PushTask& task) { return task_text(task); }, py::arg("task"),
      "The task as a file, every key with its unit and meaning; reads back as it was.");
  m.def(
      "push_task_units", [] { return file_of(static_cast<const PushTask*>(nullptr)).units(); },
      "Units of the keys of task files that have one, by the keys' paths.");
  m.def(
      "push_make_setting", [](const PushTask& task) { return make_setting(task); }, py::arg("task"),
      py::call_guard<py::gil_scoped_release>(),
      "Setting of a task. Raises Error for a robot, posture, hand or foot that there is not, and "
      "for "
      "hands of which one has much farther to go than the other.");
  m.def(
      "push_refuse_out_of_reach",
      [](const PushTask& task, const std::optional<PushSetting>& setting) {
        refuse_out_of_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "Raises Error where a motor cannot bear the force at the start, by statics. setting: of the "
      "task if None.");
  m.def(
      "push_make_controller",
      [](const PushTask& task, const PushSetting& setting) {
        return std::make_unique<BoundMpc>(make_mpc(task, setting));
      },
      py::arg("task"), py::arg("setting"),
      "MpcController of the task, for a loop of your own. Its schedule's phases are PHASES.");
  m.def(
      "push_phase_names", [] { return push_wall::phase_names(); },
      "Of the schedule, as the numbers of a trace: settle, approach, ramp, hold, lean, top, "
      "release, "
      "retreat.");
  m.def(
      "push_run_task",
      [](const py::object& spec) { return run_given<PushRun>(spec, "burnish.push_wall"); },
      py::arg("spec"),
      "Runs a task (RunSpec) to the end of its retreat in simulated time. What goes wrong on the "
      "way is in the result, with all that was recorded until then; Ctrl-C ends the run as in "
      "other Python code. Raises Error for a task that does not fit together, one that motors "
      "cannot bear, and a plant that is not there or has no feet.");
}

}  // namespace burnish::python
