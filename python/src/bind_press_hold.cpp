// The task of pressing at a point while the arm moves aside, and its runs.
#include "bind_task.hpp"
#include "specs_press_hold.hpp"
#ifdef BURNISH_HAS_RECORD
#include "press_hold/record.hpp"
#endif

namespace burnish::python {

using HoldTask =
    TaskTypes<press_hold::Task, press_hold::Setting, press_hold::RunSpec, press_hold::RunResult>;

void bind_press_hold(py::module_& m) {
  const TaskName name{
      .task = "press_hold",
      .prefix = "hold_",
      .result = "HoldResult",
      .outcome = "One sentence: that it held, or what came in between.",
      .setting =
          "a robot, posture, tool or joint that there is not, and for a posture that is to "
          "be searched where there is none",
      .refused = "one that the arm cannot reach, and a plant that is not there"};
  bind_task<HoldTask>(m, name, [](const auto& see) {
    using R = press_hold::RunResult;
    see("metrics", &R::metrics,
        "Metrics from 0.2 s after the ramp to the end of the hold; None if it was never reached.");
    see("hold", &R::hold,
        "HoldFigures, from the end of the ramp to the end of the hold; None likewise.");
  });
  m.def(
      "hold_check_reach",
      [](const press_hold::Task& task, const std::optional<press_hold::Setting>& setting) {
        return check_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "ReachReport: whether the arm can come down from the start and press at the point, by "
      "statics; it knows nothing of the way aside. setting: of the task if None.");
  m.def(
      "hold_fit_to_robot",
      [](press_hold::Task task, const std::optional<Robot>& robot) {
        const std::vector<std::string> changes =
            fit_to_robot(task, robot ? *robot : load_task_robot(task));
        return std::pair(task, changes);
      },
      py::arg("task"), py::arg("robot") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "The task, written for another robot, adapted to `robot`, its own if None; and a sentence "
      "for "
      "each change. A posture that the robot does not have is searched for. Where it has no joint "
      "of `aside`, its third joint from the base moves. Raises Error as make_setting() does.");
  m.def(
      "hold_phase_names", [] { return press_hold::phase_names(); },
      "Of the schedule, as the numbers of a trace: approach, ramp, aside, hold, retreat.");
}

}  // namespace burnish::python
