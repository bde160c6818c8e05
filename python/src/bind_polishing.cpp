// Bindings of the polishing task, its runs and experiments.
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

// Docstrings.

constexpr const char* put_on_doc =
    R"(Returns a copy of a task on a named surface, with its posture and normal.

The surface lies under the tool.

Parameters
----------
task : Task
surface : str
    One of named_surfaces().

Returns
-------
Task

Raises
------
Error
    If the surface is unknown; the message has the nearest name.)";

constexpr const char* disturbance_preset_doc = R"(Returns a preset of disturbances, with seed 0.

sensors: encoders with 17 bits, differentiated positions and forces filtered at 50 Hz, noise of
0.3 N and 0.05 Nm, 1 ms of delay. mismatch: sensors, masses 5 % above those of the controller,
surface friction 0.3. joint_friction: mismatch, 1 Nm of Coulomb friction and 1 Nms/rad of
viscous friction per joint.

Parameters
----------
name : str
    One of disturbance_presets().

Returns
-------
Disturbances

Raises
------
Error
    If the name is unknown; the message has the nearest name.)";

constexpr const char* write_task_doc = R"(Writes task_text() to a file.

Parameters
----------
task : Task
file : str or Path

Raises
------
Error
    If the file cannot be written.)";

constexpr const char* task_notes_doc =
    R"(Returns notes about settings that are possible but probably not intended.

Parameters
----------
task : Task
ideal_is_meant : bool
    If True, without a note that the plant equals the model of the controller.

Returns
-------
list of str)";

constexpr const char* fit_gains_doc =
    R"(Chooses missing gains: model_error.transient_scale and bandwidth, weights.position.

Start values are 6, 120 rad/s and 1e4 /m^2. weights.position is raised, by at most a factor of
ten, as far as the required margins allow. If margins are missed, transient_scale is lowered
first, then the bandwidth, then weights.position. model_error.lag and model_error.force_gain are
fitted too.

Parameters
----------
task : Task
setting : Setting
required : RequiredMargins, optional

Returns
-------
tuple of Task and FittedGains)";

constexpr const char* margins_doc =
    R"(Computes stability margins of the control loop with the disturbances `sensors`.

Parameters
----------
task : Task
setting : Setting

Returns
-------
TaskMargins or None
    None for robots on feet or with loops, surfaces that the robot carries, tasks without a
    force sensor, and if no plan is found at the start.)";

constexpr const char* make_setting_doc =
    R"(Resolves a task: loads its robot, and finds its start, surface and frames.

Parameters
----------
task : Task
robot : Robot, optional
    Robot in place of the robot of the task; requires `q_start`.
q_start : array_like, shape (nq,), optional
    Starting posture; requires `robot`.

Returns
-------
Setting

Raises
------
Error
    If the task is contradictory, or find_posture() finds no posture.)";

constexpr const char* task_point_doc = R"(Returns the targets of the tool at a time.

Parameters
----------
task : Task
setting : Setting
path : SurfacePath
time : float
    Time of the schedule [s].

Returns
-------
TaskPoint
    Target position and force.)";

constexpr const char* make_mpc_doc =
    R"(Makes the model predictive controller of a task. Missing gains are fitted with fit_gains().

Parameters
----------
task : Task
setting : Setting

Returns
-------
MpcSpec)";

constexpr const char* make_admittance_doc = R"(Makes the admittance controller of a task.

Parameters
----------
task : Task
setting : Setting

Returns
-------
AdmittanceSpec)";

constexpr const char* make_baseline_doc = R"(Makes the baseline controller of a task.

Parameters
----------
task : Task
setting : Setting

Returns
-------
ImpedanceSpec)";

constexpr const char* check_reach_doc =
    R"(Checks whether the robot can reach the surface and the whole path.

The check covers positions, joint limits, static torques, and collisions of the arm's skeleton
with the surface. It does not cover dynamics, shapes of links, and other collisions.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).
options : ReachOptions, optional

Returns
-------
ReachReport

Raises
------
Error
    If the path is invalid.)";

constexpr const char* check_home_doc =
    R"(Checks the motion from the home posture (Task.home) to the start.

The check covers collisions of the tool and the arm with the surface, and static torques.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).
options : ReachOptions, optional

Returns
-------
ReachReport
    Empty for a task without a home.)";

constexpr const char* free_homes_doc =
    R"(Finds postures of the robot from which its joints can move straight to the start of a task.

Parameters
----------
task : Task
setting : Setting, optional
    Default: make_setting(task).
options : ReachOptions, optional

Returns
-------
list of FreeHome
    Postures, the nearest first, without the start itself.)";

constexpr const char* pressing_axis_doc =
    R"(Returns the direction of the negative z axis of a tool in the world.

Parameters
----------
tool_placement : array_like, shape (4, 4)

Returns
-------
ndarray, shape (3,))";

constexpr const char* pressing_direction_doc =
    R"(Returns the direction in which the tool of a task presses, in the axes of the tool frame.

It is the direction of the task, or else z or -z for a frame of the robot's settings. For a link
or joint of the description, it is along the axis of the joint that carries the frame, away from
the robot.

Parameters
----------
task : Task
model : Model

Returns
-------
ndarray, shape (3,))";

constexpr const char* posture_options_doc =
    R"(Returns options of find_posture() with the limits of a task.

Parameters
----------
task : Task

Returns
-------
PostureOptions)";

constexpr const char* find_posture_doc =
    R"(Finds a posture for a task.

The tool is against the normal, joints are away from their limits, and the path is within reach. The
result is deterministic.

Parameters
----------
task : Task
robot : Robot, optional
    Default: the robot of the task.
options : PostureOptions, optional
    Default: posture_options(task).

Returns
-------
FoundPosture

Raises
------
Error
    If no posture is found.)";

constexpr const char* polishing_run_task_doc =
    R"(Runs a task in simulated time, to the end of its retreat. Ctrl-C interrupts the run.

Parameters
----------
spec : RunSpec

Returns
-------
RunResult
    Result. Faults are in the result, with the data recorded until then.

Raises
------
Error
    If the task is contradictory, the arm cannot reach, or this build does not have the plant.)";

constexpr const char* perform_experiment_doc = R"(Performs an experiment. Ctrl-C interrupts it.

Parameters
----------
name : str
    Name of an experiment.
spec : ExperimentSpec, optional
    Options. If its progress function returns False, the experiment ends with the present results.

Returns
-------
ExperimentReport

Raises
------
Error
    If the name, an override or a surface is unknown, before the first run.)";

using namespace polishing;

using Run = MadeRun<RunSpec, RunResult>;

/// Performs an experiment in another thread, while the calling thread handles signals, which only
/// the main thread of Python receives.
ExperimentReport perform(const std::string& name, const py::object& given) {
  const Experiment& experiment = experiment_named(name);
  ExperimentSpec spec;
  py::object progress = py::none();
  if (!given.is_none()) {
    progress = progress_of(given, "perform_experiment", "burnish.polishing", "ExperimentSpec");
    spec = py::cast<ExperimentSpec>(given);
  }
  std::atomic<bool> stop = false;
  std::optional<py::error_already_set> raised;  // used only with the GIL
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
  return py::make_tuple(run.spec, state_of(r), r.setting, r.reach, r.fitted, r.metrics, r.verdict,
                        r.rest);
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
  take(r.metrics);
  take(r.verdict);
  take(r.rest);
  return run;
}

void bind_result(py::module_& m) {
  py::class_<Run> run_class(m, "RunResult",
                            "Result of a run. Views of the columns of its trace keep the result "
                            "alive.");
  bind_task_run(
      run_class,
      "Sentence with the outcome: success, the fault, or the figures that violate the verdict "
      "(\"not polished: ...\"). It contains \"cut short\" if the duration was too short for the "
      "path.");
  run_class
      .def_property_readonly(
          "controller", [](const Run& self) { return self.spec.controller; }, "ControllerKind.")
      .def_property_readonly(
          "reach",
          [](const Run& self) {
            return self.spec.check_reach ? std::optional(self.result.reach) : std::nullopt;
          },
          "ReachReport of the check before the run; None without a check.")
      .def("__repr__", &repr_of)
      .def(py::pickle(&state_of_run, &run_of));
  add_result(run_class, "setting", &RunResult::setting, "Setting of the task, a copy.");
  run_class.def_property_readonly(
      "fitted", [](const Run& self) { return self.result.fitted; },
      "Sentence with the gains that fit_gains() chose; empty without fitted gains.");
  add_result(run_class, "metrics", &RunResult::metrics,
             "Metrics over the path after its start; None if the path was not reached.");
  add_result(run_class, "verdict", &RunResult::verdict,
             "VerdictFigures over the completed part of the path; None if the path was not "
             "reached.");
  add_result(run_class, "rest", &RunResult::rest,
             "RestFigures over the completed part of the path; None without a resting hand, or if "
             "the path was not reached.");
#ifdef BURNISH_HAS_RECORD
  const auto write = [](const Run& run, const std::string& name, const RunFilesOptions& options,
                        const std::filesystem::path& folder, PageWriter& pages) {
    PolishJob job;
    job.name = job.place = name;
    job.spec = run.spec;
    return pressing::write_run(recorded(job, run.result), options, folder, pages);
  };
  bind_write(run_class, write, "burnish polish");
#else
  bind_write(run_class, nullptr, "burnish polish");
#endif
}

void bind_task(py::module_& m) {
  py::class_<Path>(m, "SurfacePath", "Compiled PathSpec. Raises Error for an invalid path.")
      .def(py::init<const PathSpec&>(), py::arg("spec"))
      .def("at", &Path::at, py::arg("t"),
           "Returns the PlanarPoint at a time t since the start of the path [s]; the start for t "
           "< 0.")
      .def(
          "positions",
          [](const Path& path, const Eigen::Ref<const Eigen::VectorXd>& times) {
            RowMatrix points(times.size(), 2);
            for (Eigen::Index i = 0; i < times.size(); ++i)
              points.row(i) = path.at(times[i]).p.transpose();
            return points;
          },
          py::arg("t"), "Returns the positions (u, w) [m] at times t (n,) [s], shape (n, 2).")
      .def_property_readonly("duration", &Path::duration,
                             "Time until the last point of the path [s]; infinite for a path "
                             "without end.");
  m.def("named_surfaces", &named_surfaces,
        "Returns the named surfaces: table, board (in front of the robot), board_x (equal to "
        "board), board_y, board_minus_y, tilt_45.");
  m.def(
      "put_on",
      [](Task task, const std::string& surface) {
        put_on(task, surface);
        return task;
      },
      py::arg("task"), py::arg("surface"), put_on_doc);
  m.def("disturbance_presets", &disturbance_presets,
        "Returns the names of the presets: none, sensors, mismatch, joint_friction.");
  m.def("disturbance_preset", &disturbance_preset, py::arg("name"), disturbance_preset_doc);
  bind_task_file<Task>(m, "", &read_task, "Reads a task file.");
  m.def("write_task", &write_task, py::arg("task"), py::arg("file"), write_task_doc);
  m.def("task_notes", &task_notes, py::arg("task"), py::arg("ideal_is_meant") = false,
        task_notes_doc);
}

void bind_margins(py::module_& m) {
  m.def(
      "fit_gains",
      [](Task task, const Setting& setting, const std::optional<RequiredMargins>& required) {
        FittedGains fitted = fit_gains(task, setting, required.value_or(RequiredMargins{}));
        return std::pair(std::move(task), std::move(fitted));
      },
      py::arg("task"), py::arg("setting"), py::arg("required") = py::none(),
      py::call_guard<py::gil_scoped_release>(), fit_gains_doc);
  m.def(
      "margins", [](const Task& task, const Setting& setting) { return margins(task, setting); },
      py::arg("task"), py::arg("setting"), py::call_guard<py::gil_scoped_release>(), margins_doc);
}

void bind_setting(py::module_& m) {
  m.def(
      "make_setting",
      [](const Task& task, const std::optional<Robot>& robot,
         const std::optional<Eigen::VectorXd>& q_start) {
        if (robot.has_value() != q_start.has_value())
          throw Error(
              "make_setting: only one of robot and q_start is given; wanted both or neither");
        return robot ? make_setting(task, *robot, *q_start) : make_setting(task);
      },
      py::arg("task"), py::arg("robot") = py::none(), py::arg("q_start") = py::none(),
      py::call_guard<py::gil_scoped_release>(), make_setting_doc);
  m.def("task_point", &task_point, py::arg("task"), py::arg("setting"), py::arg("path"),
        py::arg("time"), task_point_doc);
  m.def("make_mpc", &make_mpc, py::arg("task"), py::arg("setting"), make_mpc_doc);
  m.def("make_admittance", &make_admittance, py::arg("task"), py::arg("setting"),
        make_admittance_doc);
  m.def("make_baseline", &make_baseline, py::arg("task"), py::arg("setting"), make_baseline_doc);
}

/// Returns a wrapper of `function` whose arguments `setting` and `options` are optional.
template <class Result>
auto of_setting(Result (*function)(const Task&, const Setting&, const ReachOptions&)) {
  return [function](const Task& task, const std::optional<Setting>& setting,
                    const std::optional<ReachOptions>& options) {
    return function(task, setting ? *setting : make_setting(task),
                    options.value_or(ReachOptions{}));
  };
}

void bind_reach(py::module_& m) {
  m.def("check_reach", of_setting(&check_reach), py::arg("task"), py::arg("setting") = py::none(),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(), check_reach_doc);
  m.def("check_home", of_setting(&check_home), py::arg("task"), py::arg("setting") = py::none(),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(), check_home_doc);
  m.def("free_homes", of_setting(&free_homes), py::arg("task"), py::arg("setting") = py::none(),
        py::arg("options") = py::none(), py::call_guard<py::gil_scoped_release>(), free_homes_doc);
}

void bind_postures(py::module_& m) {
  m.def("pressing_axis", &pressing_axis, py::arg("tool_placement"), pressing_axis_doc);
  m.def("pressing_direction", &pressing_direction, py::arg("task"), py::arg("model"),
        pressing_direction_doc);
  m.def("posture_options", &posture_options, py::arg("task"), posture_options_doc);
  m.def(
      "find_posture",
      [](const Task& task, const std::optional<Robot>& robot,
         const std::optional<PostureOptions>& options) {
        return find_posture(task, robot ? *robot : load_task_robot(task),
                            options ? *options : posture_options(task));
      },
      py::arg("task"), py::arg("robot") = py::none(), py::arg("options") = py::none(),
      py::call_guard<py::gil_scoped_release>(), find_posture_doc);
}

void bind_runs_and_experiments(py::module_& m) {
  m.def(
      "run_task", [](const py::object& spec) { return run_given<Run>(spec, "burnish.polishing"); },
      py::arg("spec"), polishing_run_task_doc);
  m.def(
      "experiments",
      [] {
        std::vector<NamedExperiment> all;
        for (const Experiment& experiment : experiments())
          all.push_back({experiment.name, experiment.summary});
        return all;
      },
      "Returns the experiments: paper, orientation, frames, seeds, robots, force_test, tick.");
  m.def("perform_experiment", &perform, py::arg("name"), py::arg("spec") = py::none(),
        perform_experiment_doc);
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
