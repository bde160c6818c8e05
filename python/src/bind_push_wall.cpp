// The task of pushing with both hands against a wall, and its runs.
#include "bind_task.hpp"
#include "specs_push_wall.hpp"
#ifdef BURNISH_HAS_RECORD
#include "push_wall/record.hpp"
#endif

namespace burnish::python {

using PushTask =
    TaskTypes<push_wall::Task, push_wall::Setting, push_wall::RunSpec, push_wall::RunResult>;

void bind_push_wall(py::module_& m) {
  const TaskName name{
      .task = "push_wall",
      .prefix = "push_",
      .result = "PushResult",
      .outcome = "One sentence: what it pushed with, or what came in between.",
      .setting =
          "a robot, posture, hand or foot that there is not, and for hands of which one has "
          "much farther to go than the other",
      .refused = "one that motors cannot bear, and a plant that is not there or has no feet"};
  bind_task<PushTask>(m, name, [](const auto& see) {
    using R = push_wall::RunResult;
    see("push", &R::push, "PushFigures; None where the hold did not come to its end.");
    see("limit", &R::limit, "Limit: what ended the search for the largest force.");
    see("limited_by", &R::limited_by,
        "The limits that plans kept nearest then, or which hand or foot slipped.");
  });
  m.def(
      "push_refuse_out_of_reach",
      [](const push_wall::Task& task, const std::optional<push_wall::Setting>& setting) {
        refuse_out_of_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "Raises Error where a motor cannot bear the force at the start, by statics. setting: of the "
      "task if None.");
  m.def(
      "push_phase_names", [] { return push_wall::phase_names(); },
      "Of the schedule, as the numbers of a trace: settle, approach, ramp, hold, lean, top, "
      "release, retreat.");
}

}  // namespace burnish::python
