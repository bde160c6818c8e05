// Runs of tasks for Python: a specification and its result in one object.
#pragma once

#include "bind.hpp"
#include "specs_pressing.hpp"
#ifdef BURNISH_HAS_RECORD
#include "record/run_files.hpp"
#endif

namespace burnish::python {

/// Result of a run, and specification of the run.
template <class Spec, class Result>
struct MadeRun {
  Spec spec = {};
  Result result = {};
};

/// Returns whether a run continues, from the return value of a progress function; None means True.
/// Must be called with the GIL.
inline bool goes_on(const py::object& answer) { return answer.is_none() || py::cast<bool>(answer); }

/// Returns the entry `progress` of a spec, or None. Throws TypeError if `spec` is of another class
/// than `wanted`.
py::object progress_of(const py::object& spec, const char* what, const char* module,
                       const char* wanted);

/// Calls run_task() with the specification and its progress function, and handles signals.
template <class Run>
Run run_given(const py::object& given, const char* module) {
  const py::object progress = progress_of(given, "run_task", module, "RunSpec");
  Run run{py::cast<decltype(Run::spec)>(given), {}};
  run.spec.progress = [&progress](double time, double end) {
    const py::gil_scoped_acquire acquire;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return progress.is_none() || goes_on(progress(time, end));
  };
  {
    const py::gil_scoped_release release;
    run.result = run_task(run.spec);
  }
  run.spec.progress = nullptr;
  return run;
}

/// Data of a TaskRun, for pickling.
py::tuple state_of(const TaskRun& run);
void set_state(TaskRun& run, const py::tuple& state);

/// Binds a property that returns a copy of a member of the result.
template <class Run, class Member>
void add_result(py::class_<Run>& of, const char* name, Member member, const char* text) {
  of.def_property_readonly(
      name, [member](const Run& self) { return self.result.*member; }, text);
}

/// Binds the properties that runs of all tasks have.
template <class Run>
void bind_task_run(py::class_<Run>& of, const char* outcome) {
  of.def_property_readonly(
        "task", [](const Run& self) { return self.spec.task; }, "Task of the run, a copy.")
      .def_property_readonly(
          "plant", [](const Run& self) { return self.spec.plant; }, "PlantKind.")
      .def_property_readonly(
          "trace", [](const Run& self) -> const Trace& { return self.result.trace; },
          py::return_value_policy::reference_internal,
          "Trace of every plant step; of every nth step for runs longer than 100 s. The columns "
          "are those of ClosedLoop.")
      .def_property_readonly(
          "plans", [](const Run& self) { return arrays_of(self.result.plans); },
          "PlanRecord: recorded plans of the MPC, a copy.");
  add_result(of, "plant_status", &TaskRun::plant_status, "Most severe Status of the plant.");
  add_result(of, "fault", &TaskRun::fault,
             "FaultReport of the MPC; its kind is NONE without a fault.");
  add_result(of, "interrupted", &TaskRun::interrupted,
             "True if the progress function ended the run.");
  add_result(of, "succeeded", &TaskRun::succeeded,
             "True if the run reached its end and did what the task requires.");
  add_result(of, "standing", &TaskRun::standing, "StandingFigures of a standing robot, or None.");
  add_result(of, "ticks", &TaskRun::ticks,
             "TickTimes of the controller, without its first tick, which solves to convergence.");
  add_result(of, "first_tick", &TaskRun::first_tick, "Wall time of the first tick [s].");
  add_result(of, "wall_time", &TaskRun::wall_time, "Wall time of the simulation [s].");
  add_result(of, "outcome", &TaskRun::outcome, outcome);
}

/// Binds the method write(), which calls `write` with run, name, options, folder and pages.
template <class Run, class Write>
void bind_write(py::class_<Run>& of, const Write& write, const char* command) {
  const std::string text =
      std::string("Writes the files of `") + command +
      "` for a run.\n\n"
      "The files are metrics.json, task.yaml, trace.csv, and after a fault its report.\n\n"
      "Parameters\n----------\nfolder : str or Path\n    Folder, made if necessary.\n"
      "name : str\n    Name of the run on the page.\n"
      "page : bool\n    Whether to write run.html and run.json.\n"
      "plots : bool\n    Whether to write plots as SVG files, also if `page` is False.\n"
      "recording : bool\n    Whether to write run.mcap.\n"
      "record_every : int\n    Distance of rows in trace.csv, in rows of the trace.\n\n"
      "Returns\n-------\nlist of str\n    Names of the files.\n\n"
      "Raises\n------\nError\n"
      "    If a file cannot be written, or in a build without fmt or nlohmann-json.";
  of.def(
      "write",
      [write](const Run& run, const std::filesystem::path& folder, const std::string& name,
              bool page, bool plots, bool recording, int record_every) {
#ifdef BURNISH_HAS_RECORD
        PageWriter pages(page, recording);
        return write(run, name, RunFilesOptions{.record_every = record_every, .plots = plots},
                     folder, pages);
#else
        static_cast<void>(std::tie(run, folder, name, page, plots, recording, record_every));
        throw Error(
            "RunResult.write: this build lacks fmt or nlohmann-json; wanted a build with both "
            "libraries, or trace.write_csv() and write_task()");
        return std::vector<std::string>();
#endif
      },
      py::arg("folder"), py::kw_only(), py::arg("name") = "run", py::arg("page") = true,
      py::arg("plots") = false, py::arg("recording") = false, py::arg("record_every") = 10,
      py::call_guard<py::gil_scoped_release>(), text.c_str());
}

}  // namespace burnish::python
