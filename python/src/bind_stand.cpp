// The task of standing on feet and swaying, and its runs.
#include "bind_task.hpp"
#include "specs_stand.hpp"
#ifdef BURNISH_HAS_RECORD
#include "stand/record.hpp"
#endif

namespace burnish::python {

using StandTask = TaskTypes<stand::Task, stand::Setting, stand::RunSpec, stand::RunResult>;

void bind_stand(py::module_& m) {
  const TaskName name{
      .task = "stand",
      .prefix = "stand_",
      .result = "StandResult",
      .outcome = "One sentence: how it stood, or what came in between and whether it fell.",
      .setting =
          "a robot, posture or foot that there is not, a posture that is searched and not found, "
          "and a sole that does not lie on the ground",
      .refused = "one that the feet do not bear, and a plant that is not there or has no feet"};
  bind_task<StandTask>(m, name, [](const auto& see) {
    using R = stand::RunResult;
    see("sway", &R::sway, "SwayFigures; None where it did not come to sway.");
    see("fell", &R::fell,
        "In truth, when the run ended: the centre of mass lost half of its height above the feet, "
        "or the base turned by more than 1 rad.");
  });
  m.def(
      "stand_refuse_out_of_reach",
      [](const stand::Task& task, const std::optional<stand::Setting>& setting) {
        refuse_out_of_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "Raises Error where the feet, at rest and within the limits that plans keep, could not bear "
      "the robot at the start or somewhere on its way, and where no posture has the trunk there. "
      "setting: of the task if None.");
  m.def(
      "stand_phase_names", [] { return stand::phase_names(); },
      "Of the schedule, as the numbers of a trace: settle, sway, rest.");
}

}  // namespace burnish::python
