// The files of a task that its file names: a task says what is its own (RecordedRun), and these
// write it, with all that runs of all tasks leave.
#pragma once

#include <map>

#include "pressing/record.hpp"
#include "record/figures_json.hpp"

namespace burnish::pressing {

/// A run that was made.
template <class RunSpec>
struct NamedRun {
  std::string name;          ///< on its page
  std::string command = {};  ///< that makes it again; empty: of its task.yaml
  RunSpec spec;
};

/// Figures of a task's own: a section of metrics.json, and entries of the page.
struct OwnFigures {
  std::string section;
  Json json = nullptr;
  std::vector<PageMetric> page = {};
};

/// What a task says of a run. References outlive it.
struct RecordedRun {
  // Of every task, by record_of().
  std::string task, name, command;
  PlantKind plant;
  Disturbances disturbances;  ///< of the task
  std::string robot_name;     ///< as the task has it
  std::string task_file;      ///< its text
  double deadline;            ///< s; infinite: none
  const TaskRun& run;
  bool done;
  const Robot& robot;
  const Eigen::VectorXd& q_start;  ///< nq
  const SceneSpec& scene;          ///< as the controller knows it

  // Of its own.
  std::string force = {};  ///< such as "30 N"; empty of what presses none
  Eigen::Matrix3d surface_axes =
      Eigen::Matrix3d::Identity();  ///< columns: two tangents and the normal, world
  Eigen::Vector3d origin_world =
      Eigen::Vector3d::Zero();                ///< m, that places along the surface are from
  std::vector<std::string> phase_names = {};  ///< of the numbers in its trace
  int phase = 0;                              ///< that has plots of its own
  std::string phase_title = {};               ///< "while it holds"
  double update_period = 0.0;                 ///< s, between two plans
  bool has_estimate = true;                   ///< of the force, by the controller
  std::optional<Metrics> metrics = {};
  OwnFigures figures = {};
  Json more = Json::object();                            ///< further entries of metrics.json
  std::map<std::string, Eigen::VectorXd> postures = {};  ///< nq, that the page can show
};

/// What is the same of all tasks. `task`: its name.
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
          .done = result.done,
          .robot = result.setting.robot,
          .q_start = result.setting.q_start,
          .scene = result.setting.scene};
}

/// `each` calls each_..._figure(see) of the task with what it is given.
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

/// Everything in numbers.
Json run_json(const RecordedRun& recorded);
RunPage make_run_page(const RecordedRun& recorded, int record_every);
/// See write_run_files().
std::vector<std::string> write_run(const RecordedRun& recorded, const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages);

}  // namespace burnish::pressing
