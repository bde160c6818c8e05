// Task of pressing at a point while other joints move aside, and its runs.
#include "bind_task.hpp"
#include "specs_press_hold.hpp"
#ifdef BURNISH_HAS_RECORD
#include "press_hold/record.hpp"
#endif

namespace burnish::python {

// Docstrings.

constexpr const char* hold_check_reach_doc =
    R"(Checks whether the arm can approach and press at the point, by statics.

The motion aside is not checked.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).

Returns
-------
ReachReport)";

constexpr const char* fit_to_robot_doc = R"(Adapts a task to another robot.

A missing posture is searched for. If the robot has no joint of `aside`, its third joint from
the base moves instead.

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

using HoldTask =
    TaskTypes<press_hold::Task, press_hold::Setting, press_hold::RunSpec, press_hold::RunResult>;

void bind_press_hold(py::module_& m) {
  const TaskName name{
      .task = "press_hold",
      .prefix = "hold_",
      .result = "HoldResult",
      .outcome = "Sentence with the outcome: success, or the fault.",
      .setting = "If the robot, posture, tool or a joint is unknown, or no posture is found.",
      .refused = "the arm cannot reach the point, or this build does not have the plant."};
  bind_task<HoldTask>(m, name, [](const auto& see) {
    using R = press_hold::RunResult;
    see("metrics", &R::metrics,
        "Metrics from 0.2 s after the ramp to the end of the hold; None if the hold was not "
        "reached.");
    see("hold", &R::hold,
        "HoldFigures from the end of the ramp to the end of the hold; None if the hold was not "
        "reached.");
  });
  m.def(
      "hold_check_reach",
      [](const press_hold::Task& task, const std::optional<press_hold::Setting>& setting) {
        return check_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      hold_check_reach_doc);
  m.def(
      "hold_fit_to_robot",
      [](press_hold::Task task, const std::optional<Robot>& robot) {
        const std::vector<std::string> changes =
            fit_to_robot(task, robot ? *robot : load_task_robot(task));
        return std::pair(task, changes);
      },
      py::arg("task"), py::arg("robot") = py::none(), py::call_guard<py::gil_scoped_release>(),
      fit_to_robot_doc);
  m.def(
      "hold_phase_names", [] { return press_hold::phase_names(); },
      "Returns the names of the phases: approach, ramp, aside, hold, retreat. The index of a name "
      "is the phase number in traces.");
}

}  // namespace burnish::python
