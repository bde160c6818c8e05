// The polishing task: what it is, its runs and experiments.
#include <atomic>
#include <chrono>
#include <future>

#include "bind_task.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "polishing/descriptions.hpp"
#include "specs_polishing.hpp"
#ifdef BURNISH_HAS_RECORD
#include "polishing/record/run_files.hpp"
#endif

namespace burnish::python {

namespace {

using namespace polishing;

using Run = MadeRun<RunSpec, RunResult>;

/// Signals reach Python's main thread alone, so the work is done by another while the caller looks
/// for them.
ExperimentReport perform(const std::string& name, const py::object& given) {
  const Experiment& experiment = experiment_named(name);
  ExperimentSpec spec;
  py::object progress = py::none();
  if (!given.is_none()) {
    progress = progress_of(given, "perform_experiment", "burnish.polishing", "ExperimentSpec");
    spec = py::cast<ExperimentSpec>(given);
  }
  std::atomic<bool> stop = false;
  std::optional<py::error_already_set> raised;  // touched with the GIL alone
  spec.stopped = [&stop] { return stop.load(); };
  spec.progress = nullptr;
  if (!progress.is_none())
    spec.progress = [&](double share, const std::string& what) {
      const py::gil_scoped_acquire acquire;
      if (stop) return;
      try {
        stop = !goes_on(progress(share, what));
      } catch (py::error_already_set& error) {
        raised = error;
        stop = true;
      }
    };
  ExperimentReport report;
  {
    const py::gil_scoped_release release;
    auto work = std::async(std::launch::async, [&] { return experiment.perform(spec); });
    while (work.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
      const py::gil_scoped_acquire acquire;
      if (!raised && PyErr_CheckSignals() != 0) {
        raised.emplace();
        stop = true;
      }
    }
    report = work.get();
  }
  if (raised) throw py::error_already_set(*raised);
  return report;
}

std::string repr_of(const Run& run) {
  std::string text = "<RunResult: " + name_of(run.spec.controller) + " on " +
                     name_of(run.spec.plant) + "; " + run.result.outcome;
  if (run.result.metrics) {
    char figures[80];
    std::snprintf(figures, sizeof figures, "; force error %.2f N, path error %.2f mm rms",
                  run.result.metrics->force_rmse, 1e3 * run.result.metrics->position_rmse);
    text += figures;
  }
  return text + ">";
}

py::tuple state_of_run(const Run& run) {
  const RunResult& r = run.result;
  return py::make_tuple(run.spec, state_of(r), r.setting, r.reach, r.fitted, r.polished, r.metrics,
                        r.verdict);
}

Run run_of(const py::tuple& state) {
  std::size_t next = 0;
  const auto take = [&](auto& entry) {
    entry = py::cast<std::decay_t<decltype(entry)>>(state[next++]);
  };
  Run run;
  RunResult& r = run.result;
  take(run.spec);
  set_state(r, state[next++]);
  take(r.setting);
  take(r.reach);
  take(r.fitted);
  take(r.polished);
  take(r.metrics);
  take(r.verdict);
  return run;
}

void bind_result(py::module_& m) {
  py::class_<Run> run_class(m, "RunResult",
                            "What came out of a run. Its trace stays where it is: views of its "
                            "columns keep the result alive.");
  bind_task_run(
      run_class,
      "One sentence: that it polished, what came in between, or which figures its "
      "verdict does not bear (\"not polished: ...\"); \"cut short\" where its time was too short "
      "for the path.");
  run_class
      .def_property_readonly(
          "controller", [](const Run& self) { return self.spec.controller; }, "ControllerKind.")
      .def_property_readonly(
          "reach",
          [](const Run& self) {
            return self.spec.check_reach ? std::optional(self.result.reach) : std::nullopt;
          },
          "ReachReport of the check before the run; None if there was none.")
      .def("__repr__", &repr_of)
      .def(py::pickle(&state_of_run, &run_of));
  add_result(run_class, "setting", &RunResult::setting,
             "Setting: the task with everything resolved; a copy.");
  add_result(run_class, "polished", &RunResult::polished,
             "Whether the path's end was reached without fault, as Task.verdict asks for.");
  run_class.def_property_readonly(
      "fitted", [](const Run& self) { return self.result.fitted; },
      "What fit_gains() chose, a sentence; empty if nothing.");
  add_result(run_class, "metrics", &RunResult::metrics,
             "Metrics over the path after its start; None if it was never reached.");
  add_result(run_class, "verdict", &RunResult::verdict,
             "VerdictFigures: what Task.verdict is about, over all of the path that there was; "
             "None if it was never reached.");
#ifdef BURNISH_HAS_RECORD
  const auto write = [](const Run& run, const std::string& name, const RunFilesOptions& options,
                        const std::filesystem::path& folder, PageWriter& pages) {
    return write_run({.name = name, .place = name, .spec = run.spec}, run.result, options, folder,
                     pages);
  };
  bind_write(run_class, write, "burnish polish");
#else
  bind_write(run_class, nullptr, "burnish polish");
#endif
}

void bind_task(py::module_& m) {
  py::class_<Path>(m, "SurfacePath",
                   "A PathSpec compiled. Raises Error for numbers that make no path.")
      .def(py::init<const PathSpec&>(), py::arg("spec"))
      .def("at", &Path::at, py::arg("t"), "PlanarPoint t s after its start; before, the start.")
      .def(
          "positions",
          [](const Path& path, const Eigen::Ref<const Eigen::VectorXd>& times) {
            RowMatrix points(times.size(), 2);
            for (Eigen::Index i = 0; i < times.size(); ++i)
              points.row(i) = path.at(times[i]).p.transpose();
            return points;
          },
          py::arg("t"), "(u, w) in m at times in s: (n,) gives (n, 2).")
      .def_property_readonly("duration", &Path::duration,
                             "s until its last point is reached; infinite for paths that go on.");
  m.def("named_surfaces", &named_surfaces,
        "NamedSurface of each: table, board (in front of the robot), board_x (the same), board_y, "
        "board_minus_y, tilt_45.");
  m.def(
      "put_on",
      [](Task task, const std::string& surface) {
        put_on(task, surface);
        return task;
      },
      py::arg("task"), py::arg("surface"),
      "A copy of the task with posture and normal of a named surface, which lies under the tool. "
      "Raises Error with the nearest known name.");
  m.def("disturbance_presets", &disturbance_presets, "none, sensors, mismatch, joint_friction.");
  m.def("disturbance_preset", &disturbance_preset, py::arg("name"),
        "Disturbances: none; sensors (17 bit encoders, differences and forces filtered at 50 Hz, "
        "0.3 N and 0.05 Nm of noise, 1 ms of delay); mismatch (the same, masses 5 % above the "
        "controller's, surface friction 0.3); joint_friction (the same, 1 Nm of Coulomb and 1 "
        "Nms/rad of viscous joint friction). Seed 0. Raises Error with the nearest known name.");
  bind_task_file<Task>(m, "", &read_task, "Reads a task file");
  m.def("write_task", &write_task, py::arg("task"), py::arg("file"),
        "Writes task_text(). Raises Error if the file cannot be written.");
  m.def("task_notes", &task_notes, py::arg("task"), py::arg("ideal_is_meant") = false,
        "Sentences on what is possible but probably not meant, before a run. ideal_is_meant: none "
        "says that the plant is exactly what the controller believes.");
}

void bind_margins(py::module_& m) {
  m.def(
      "fit_gains",
      [](Task task, const Setting& setting, const std::optional<RequiredMargins>& required) {
        FittedGains fitted = fit_gains(task, setting, required.value_or(RequiredMargins{}));
        return std::pair(std::move(task), std::move(fitted));
      },
      py::arg("task"), py::arg("setting"), py::arg("required") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "(Task, FittedGains): a copy of the task in which model_error.boost, model_error.bandwidth "
      "and weights.position have values where they were None: 6, 120 rad/s and 1e4 /m^2 at first. "
      "weights.position is raised to at most ten times that, as far as the required margins "
      "allow; where they are missed the boost is lowered, then the bandwidth, then "
      "weights.position. model_error.lag and model_error.force_gain are fitted along with them.");
  m.def(
      "margins", [](const Task& task, const Setting& setting) { return margins(task, setting); },
      py::arg("task"), py::arg("setting"), py::call_guard<py::gil_scoped_release>(),
      "TaskMargins behind the disturbances `sensors`; None for robots on their feet or with "
      "loops, plates that the robot carries, tasks without a force sensor, and where there is no "
      "plan from the start.");
}

void bind_setting(py::module_& m) {
  m.def(
      "make_setting",
      [](const Task& task, const std::optional<Robot>& robot,
         const std::optional<Eigen::VectorXd>& q_start) {
        if (robot.has_value() != q_start.has_value())
          throw Error("make_setting: robot and q_start come together; one of them is None");
        return robot ? make_setting(task, *robot, *q_start) : make_setting(task);
      },
      py::arg("task"), py::arg("robot") = py::none(), py::arg("q_start") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "Setting of a task; or for a robot at hand and a starting posture (nq,), whatever the task "
      "says of both. Raises Error for a task that does not fit together, and for a posture that is "
      "to be searched (find_posture()) where there is none.");
  m.def("task_point", &task_point, py::arg("task"), py::arg("setting"), py::arg("path"),
        py::arg("time"),
        "TaskPoint: where the tool shall be and how hard it shall press, at a time (s) of the "
        "schedule.");
  m.def("make_mpc", &make_mpc, py::arg("task"), py::arg("setting"),
        "MpcSpec: the task as an optimal control problem over time. Gains that the task does not "
        "state are fitted to the arm, see fit_gains().");
  m.def("make_admittance", &make_admittance, py::arg("task"), py::arg("setting"),
        "AdmittanceSpec: the admittance controller on the same task.");
  m.def("make_baseline", &make_baseline, py::arg("task"), py::arg("setting"),
        "ImpedanceSpec: the baseline on the same task.");
}

/// A function of a task whose setting and options may be left out.
template <class Result>
auto of_setting(Result (*function)(const Task&, const Setting&, const ReachOptions&)) {
  return [function](const Task& task, const std::optional<Setting>& setting,
                    const std::optional<ReachOptions>& options) {
    return function(task, setting ? *setting : make_setting(task),
                    options.value_or(ReachOptions{}));
  };
}

void bind_reach(py::module_& m) {
  m.def(
      "check_reach", of_setting(&check_reach), py::arg("task"), py::arg("setting") = py::none(),
      py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "ReachReport: walks from the start to the surface and along the whole path, and looks at "
      "position, joint limits, torques that hold the robot still, and the arm as a skeleton beside "
      "the surface. It knows no motion, no shapes of links, and no other collisions. setting: of "
      "the task if None. Raises Error for a path that is none.");
  m.def(
      "check_home", of_setting(&check_home), py::arg("task"), py::arg("setting") = py::none(),
      py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
      "ReachReport: walks along the move from where a run begins (Task.home) to its start, and "
      "looks at the tool and the arm beside the surface and at torques that hold the robot still. "
      "Empty where no home is stated. setting: of the task if None.");
  m.def("free_homes", of_setting(&free_homes), py::arg("task"), py::arg("setting") = py::none(),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(),
        "List[FreeHome]: postures of the robot from which its joints can move straight to the "
        "task's start, the nearest first; the start itself is left out. setting: of the task if "
        "None.");
}

void bind_postures(py::module_& m) {
  m.def("pressing_axis", &pressing_axis, py::arg("tool_placement"),
        "(3,), the direction of the -z of a tool at a placement (4, 4); see "
        "pressing_direction().");
  m.def(
      "pressing_direction", &pressing_direction, py::arg("task"), py::arg("model"),
      "(3,), the direction, in its own frame, that a task's tool presses in: what the task says; "
      "z or -z of a frame of the robot's settings; of a link or joint of the description along the "
      "axis of the joint that carries it, away from the robot.");
  m.def("posture_options", &posture_options, py::arg("task"),
        "PostureOptions with the limits that a task has for find_posture().");
  m.def(
      "find_posture",
      [](const Task& task, const std::optional<Robot>& robot,
         const std::optional<PostureOptions>& options) {
        return find_posture(task, robot ? *robot : load_task_robot(task),
                            options ? *options : posture_options(task));
      },
      py::arg("task"), py::arg("robot") = py::none(), py::arg("options") = py::none(),
      py::call_guard<py::gil_scoped_release>(),
      "FoundPosture: a posture from which the task can be done, the same one for the same input: "
      "tool against the normal, joints away from their limits, the whole path within reach. robot: "
      "the task's if None. options: posture_options(task) if None. Raises Error with one sentence "
      "if there is none.");
}

void bind_runs_and_experiments(py::module_& m) {
  m.def(
      "run_task", [](const py::object& spec) { return run_given<Run>(spec, "burnish.polishing"); },
      py::arg("spec"),
      "Runs a task (RunSpec) to the end of its retreat in simulated time. What goes wrong on the "
      "way is in the result, with all that was recorded until then; Ctrl-C ends the run as in "
      "other Python code. Raises Error for a task that does not fit together, one that the arm "
      "cannot reach, and a plant that is not there.");
  m.def(
      "experiments",
      [] {
        std::vector<NamedExperiment> all;
        for (const Experiment& experiment : experiments())
          all.push_back({experiment.name, experiment.summary});
        return all;
      },
      "Experiment of each: paper, orientation, frames, seeds, robots, force_test, tick.");
  m.def(
      "perform_experiment", &perform, py::arg("name"), py::arg("spec") = py::none(),
      "ExperimentReport of an experiment by its name, performed as an ExperimentSpec says. A "
      "progress function that returns False ends it with what there is until then; Ctrl-C ends it "
      "as in other Python code. Raises Error with the nearest known name, and for overrides and "
      "surfaces that there are not, before anything is run.");
  m.def("table_markdown", &markdown, py::arg("table"));
  m.def("table_csv", &csv, py::arg("table"));
}

}  // namespace

void bind_polishing(py::module_& m) {
  bind_task(m);
  bind_setting(m);
  bind_reach(m);
  bind_margins(m);
  bind_postures(m);
  bind_result(m);
  bind_runs_and_experiments(m);
}

}  // namespace burnish::python
