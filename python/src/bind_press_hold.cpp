// The task of pressing at a point while the arm moves aside, and its runs.
#include "loop_parts.hpp"
#include "press_hold/descriptions.hpp"
#include "specs_press_hold.hpp"
#include "task_run.hpp"
#ifdef BURNISH_HAS_RECORD
#include "press_hold/record.hpp"
#endif

namespace burnish::python {

namespace {

using namespace press_hold;
using HoldRun = MadeRun<press_hold::RunSpec, press_hold::RunResult>;
using HoldTask = press_hold::Task;
using HoldSetting = press_hold::Setting;

py::tuple hold_state(const HoldRun& run) {
  const auto& r = run.result;
  return py::make_tuple(run.spec, state_of(r), r.setting, r.done, r.metrics, r.hold);
}

HoldRun hold_run_of(const py::tuple& state) {
  HoldRun run{py::cast<press_hold::RunSpec>(state[0]), {}};
  set_state(run.result, state[1]);
  run.result.setting = py::cast<HoldSetting>(state[2]);
  run.result.done = py::cast<bool>(state[3]);
  run.result.metrics = py::cast<std::optional<Metrics>>(state[4]);
  run.result.hold = py::cast<std::optional<HoldFigures>>(state[5]);
  return run;
}

void bind_hold_result(py::module_& m) {
  py::class_<HoldRun> of(m, "HoldResult",
                         "What came out of a run of press_hold. Its trace stays where it is: views "
                         "of its columns keep the result alive.");
  bind_task_run(of, "One sentence: that it held, or what came in between.");
  add_result(of, "setting", &press_hold::RunResult::setting,
             "Setting: the task with everything resolved; a copy.");
  add_result(of, "done", &press_hold::RunResult::done,
             "Whether the end was reached without fault.");
  add_result(of, "metrics", &press_hold::RunResult::metrics,
             "Metrics from 0.2 s after the ramp to the end of the hold; None if it was never "
             "reached.");
  add_result(of, "hold", &press_hold::RunResult::hold,
             "HoldFigures, from the end of the ramp to the end of the hold; None likewise.");
  of.def("__repr__", [](const HoldRun& run) {
      return "<RunResult: press_hold on " + name_of(run.spec.plant) + "; " + run.result.outcome +
             ">";
    }).def(py::pickle(&hold_state, &hold_run_of));
#ifdef BURNISH_HAS_RECORD
  const auto write = [](const HoldRun& run, const std::string& name, const RunFilesOptions& options,
                        const std::filesystem::path& folder, PageWriter& pages) {
    return write_run({.name = name, .spec = run.spec}, run.result, options, folder, pages);
  };
  bind_write(of, write, "burnish run");
#else
  bind_write(of, nullptr, "burnish run");
#endif
}

}  // namespace

void bind_press_hold(py::module_& m) {
  bind_hold_result(m);
  m.def("hold_read_task", &press_hold::read_task, py::arg("file"),
        py::arg("overrides") = std::vector<std::string>{},
        "Reads a file with `task: press_hold`; keys that it does not state keep their defaults. "
        "Overrides are applied after it, in order, each \"key.path=value\" with a value in YAML. "
        "Raises Error naming file (or override), line, key and what was wanted.");
  m.def(
      "hold_override_task",
      [](HoldTask task, const std::vector<std::string>& overrides) {
        override_task(task, overrides);
        return task;
      },
      py::arg("task"), py::arg("overrides"),
      "A copy of the task with overrides applied. Raises Error as read_task() does.");
  m.def(
      "hold_check_task", [](const HoldTask& task) { check_task(task); }, py::arg("task"),
      "Raises Error with a sentence for numbers out of range, and for those that are possible each "
      "but not together.");
  m.def(
      "hold_task_text", [](const HoldTask& task) { return task_text(task); }, py::arg("task"),
      "The task as a file, every key with its unit and meaning; reads back as it was.");
  m.def(
      "hold_task_units", [] { return file_of(static_cast<const HoldTask*>(nullptr)).units(); },
      "Units of the keys of task files that have one, by the keys' paths.");
  m.def(
      "hold_make_setting", [](const HoldTask& task) { return make_setting(task); }, py::arg("task"),
      py::call_guard<py::gil_scoped_release>(),
      "Setting of a task. Raises Error for a robot, posture, tool or joint that there is not, and "
      "for a posture that is to be searched where there is none.");
  m.def(
      "hold_check_reach",
      [](const HoldTask& task, const std::optional<HoldSetting>& setting) {
        return check_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "ReachReport: whether the arm can come down from the start and press at the point, by "
      "statics; it knows nothing of the way aside. setting: of the task if None.");
  m.def(
      "hold_make_controller",
      [](const HoldTask& task, const HoldSetting& setting) {
        return std::make_unique<BoundMpc>(make_mpc(task, setting));
      },
      py::arg("task"), py::arg("setting"),
      "MpcController of the task, for a loop of your own. Its schedule's phases are PHASES.");
  m.def(
      "hold_phase_names", [] { return press_hold::phase_names(); },
      "Of the schedule, as the numbers of a trace: approach, ramp, aside, hold, retreat.");
  m.def(
      "hold_run_task",
      [](const py::object& spec) { return run_given<HoldRun>(spec, "burnish.press_hold"); },
      py::arg("spec"),
      "Runs a task (RunSpec) to the end of its retreat in simulated time. What goes wrong on the "
      "way is in the result, with all that was recorded until then; Ctrl-C ends the run as in "
      "other Python code. Raises Error for a task that does not fit together, one that the arm "
      "cannot reach, and a plant that is not there.");
}

}  // namespace burnish::python
