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
  std::string task, name, command;
  PlantKind plant;
  Disturbances disturbances;  ///< of the task
  std::string robot_name;     ///< as the task has it
  std::string force;          ///< such as "30 N"
  std::string task_file;      ///< its text
  const TaskRun& run;
  bool done;
  const Robot& robot;
  const Eigen::VectorXd& q_start;
  const SceneSpec& scene;        ///< as the controller knows it
  Eigen::Matrix3d surface_axes;  ///< columns: two tangents and the normal, world
  Eigen::Vector3d origin_world;  ///< m, that places along the surface are from
  std::vector<std::string> phase_names;
  int phase;                 ///< that has plots of its own
  std::string phase_title;   ///< "while it holds"
  double update_period;      ///< s, between two plans
  double deadline;           ///< s; infinite: none
  bool has_estimate = true;  ///< of the force, by the controller
  std::optional<Metrics> metrics = {};
  OwnFigures figures = {};
  Json more = Json::object();                            ///< further entries of metrics.json
  std::map<std::string, Eigen::VectorXd> postures = {};  ///< that the page can show
};

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
