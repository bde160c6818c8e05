// Task of standing on feet and swaying, and its runs.
#include "bind_task.hpp"
#include "specs_stand.hpp"
#ifdef BURNISH_HAS_RECORD
#include "stand/record.hpp"
#endif

namespace burnish::python {

// Docstrings.

constexpr const char* stand_refuse_doc =
    R"(Checks whether the feet can support the robot at the start and during the sway, by statics.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).

Raises
------
Error
    If the feet cannot support the robot within the limits of plans, or a target is out of reach.)";

using StandTask = TaskTypes<stand::Task, stand::Setting, stand::RunSpec, stand::RunResult>;

void bind_stand(py::module_& m) {
  const TaskName name{
      .task = "stand",
      .prefix = "stand_",
      .result = "StandResult",
      .outcome = "Sentence with the outcome: success, the fault, and whether the robot fell.",
      .setting =
          "If the robot, posture or a foot is unknown, no posture is found, or a sole does not lie "
          "on "
          "the ground.",
      .refused = "the feet cannot support the robot, or this build has no plant with feet."};
  bind_task<StandTask>(m, name, [](const auto& see) {
    using R = stand::RunResult;
    see("sway", &R::sway, "SwayFigures; None if the sway did not begin.");
    see("fell", &R::fell,
        "True if the robot had fallen when the run ended: its true centre of mass lost more than "
        "half of its height above the feet, or its base turned by more than 1 rad.");
  });
  m.def(
      "stand_refuse_out_of_reach",
      [](const stand::Task& task, const std::optional<stand::Setting>& setting) {
        refuse_out_of_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      stand_refuse_doc);
  m.def(
      "stand_phase_names", [] { return stand::phase_names(); },
      "Returns the names of the phases: settle, sway, rest. The index of a name is the phase "
      "number in traces.");
}

}  // namespace burnish::python
