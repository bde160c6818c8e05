// Writing of the files of a run. A task describes its run by a RecordedRun. From this description,
// the functions below make the contents that files of all tasks have in common.
#pragma once

#include <map>

#include "pressing/record.hpp"
#include "record/figures_json.hpp"

namespace burnish::pressing {

/// Specification of a run, and the name of the run.
template <class RunSpec>
struct NamedRun {
  std::string name;          ///< Title of the page.
  std::string command = {};  ///< Command that repeats the run; empty: `burnish run task.yaml`.
  RunSpec spec;
};

/// Statistics of one task only, as a section of metrics.json and as entries of the HTML page.
struct OwnFigures {
  std::string section;
  Json json = nullptr;
  std::vector<PageMetric> page = {};
};

/// Contents for the files of a run. Referenced objects must outlive the RecordedRun.
struct RecordedRun {
  // Members common to all tasks, set by record_of().
  std::string task, name, command;
  PlantKind plant;
  Disturbances disturbances;  ///< Disturbances of the task.
  std::string robot_name;     ///< Robot as named in the task file.
  std::string task_file;      ///< Text of the task file.
  double deadline;            ///< Deadline of plans [s]; infinite: none.
  const TaskRun& run;
  const Robot& robot;
  const Eigen::VectorXd& q_start;  ///< Starting posture (nq).
  const SceneSpec& scene;          ///< Nominal scene, which the controller assumes.

  // Members that each task sets.
  /// Facts about the run at the top of the page, such as the robot, by their names.
  std::vector<std::pair<std::string, std::string>> facts = {};
  /// Nominal surface that the page draws, in the world.
  SurfaceSpec surface = {};
  std::string surface_frame = {};  ///< Frame of the robot that carries the surface; empty: none.
  /// Axes of the surface in the world, as columns: two tangents and the normal.
  Eigen::Matrix3d surface_axes = Eigen::Matrix3d::Identity();
  /// Origin of the coordinates along the surface, in the world [m].
  Eigen::Vector3d origin_world = Eigen::Vector3d::Zero();
  /// Path that the page draws, in coordinates along the surface (first two axes) [m].
  Eigen::VectorXd path_u = Eigen::VectorXd::Zero(2), path_w = path_u;
  /// Names of the phases, by their number in the trace.
  std::vector<std::string> phase_names = {};
  int phase = 0;                 ///< Phase that has its own plots, for tasks with a tool.
  std::string phase_title = {};  ///< Title of the plots of `phase`, such as "while it holds".
  double update_period = 0.0;    ///< Time between two plans [s].
  bool plans = true;             ///< Whether the controller plans and estimates the force.
  std::optional<Metrics> metrics = {};
  OwnFigures figures = {};
  Json facts_json = Json::object();  ///< Further entries of metrics.json, after the task.
  Json more = Json::object();        ///< Further entries of metrics.json, after the metrics.
  /// Postures that the HTML page shows (nq), by name.
  std::map<std::string, Eigen::VectorXd> postures = {};
};

/// Returns a RecordedRun with the entries that all tasks have in common. `task`: name of the task.
template <class RunSpec, class RunResult>
RecordedRun record_of(const std::string& task, const NamedRun<RunSpec>& run,
                      const RunResult& result) {
  return {.task = task,
          .name = run.name,
          .command = run.command,
          .plant = run.spec.plant,
          .disturbances = run.spec.task.disturbances,
          .robot_name = run.spec.task.robot,
          .task_file = task_text(run.spec.task),
          .deadline = run.spec.task.limits.deadline,
          .run = result,
          .robot = result.setting.robot,
          .q_start = result.setting.q_start,
          .scene = result.setting.scene,
          .facts = {{"task", task},
                    {"robot", run.spec.task.robot},
                    {"plant", name_of(run.spec.plant)},
                    {"seed", std::to_string(run.spec.task.disturbances.seed)}}};
}

/// Returns `figures` (statistics) as JSON and as entries of the HTML page; both results are empty
/// without figures. `each(see)` must call see(entry, member) for each statistic.
template <class Figures, class Each>
OwnFigures own_figures(const std::string& section, const std::optional<Figures>& figures,
                       const Each& each) {
  OwnFigures own{.section = section};
  if (figures)
    each([&](const FigureEntry& entry, auto member) {
      own.json[entry.key()] = figure_json(*figures.*member);
      own.page.push_back(page_metric({entry, entry.name, entry.meaning, *figures.*member}));
    });
  return own;
}

/// Returns the content of metrics.json.
Json run_json(const RecordedRun& recorded);
RunPage make_run_page(const RecordedRun& recorded, int record_every);
/// Writes the files of a run, see write_run_files().
std::vector<std::string> write_run(const RecordedRun& recorded, const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages);

}  // namespace burnish::pressing
