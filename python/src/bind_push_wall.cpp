// Task of pushing against a wall with both hands, and its runs.
#include "bind_task.hpp"
#include "specs_push_wall.hpp"
#ifdef BURNISH_HAS_RECORD
#include "push_wall/record.hpp"
#endif

namespace burnish::python {

// Docstrings.

constexpr const char* push_refuse_doc =
    R"(Checks whether the motors can produce the force at the start, by statics.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).

Raises
------
Error
    If a motor torque is too small.)";

using PushTask =
    TaskTypes<push_wall::Task, push_wall::Setting, push_wall::RunSpec, push_wall::RunResult>;

void bind_push_wall(py::module_& m) {
  const TaskName name{
      .task = "push_wall",
      .prefix = "push_",
      .result = "PushResult",
      .outcome = "Sentence with the outcome: the forces, or the fault.",
      .setting =
          "If the robot, posture, a hand or a foot is unknown, or the distances of the hands to "
          "the "
          "wall differ too much.",
      .refused = "a motor torque is too small, or this build has no plant with feet."};
  bind_task<PushTask>(m, name, [](const auto& see) {
    using R = push_wall::RunResult;
    see("push", &R::push, "PushFigures; None if the hold did not end.");
    see("limit", &R::limit, "Limit that ended the search for the largest force.");
    see("limited_by", &R::limited_by,
        "Names of the active constraints at the end of the search, or of the hand or foot that "
        "slipped.");
  });
  m.def(
      "push_refuse_out_of_reach",
      [](const push_wall::Task& task, const std::optional<push_wall::Setting>& setting) {
        refuse_out_of_reach(task, setting ? *setting : make_setting(task));
      },
      py::arg("task"), py::arg("setting") = py::none(), py::call_guard<py::gil_scoped_release>(),
      push_refuse_doc);
  m.def(
      "push_phase_names", [] { return push_wall::phase_names(); },
      "Returns the names of the phases: settle, approach, ramp, hold, lean, top, release, "
      "retreat. The index of a name is the phase number in traces.");
}

}  // namespace burnish::python
