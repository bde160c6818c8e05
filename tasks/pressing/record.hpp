// What runs of all tasks that press leave: the ticks' figures, plots, and their part of the page.
#pragma once

#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "record/run_files.hpp"

namespace burnish::pressing {

nlohmann::ordered_json ticks_json(const TaskRun& run);
/// Null of a robot that does not stand.
nlohmann::ordered_json standing_json(const TaskRun& run);

/// All files that write_run_files() may write of such a run.
std::vector<std::string> run_file_names();

/// What is plotted, which outlives the plots.
struct PlottedRun {
  std::string name;
  const TaskRun& run;
  const Model& model;
  Eigen::Matrix3d surface_axes;
  Eigen::Vector3d origin_world;  ///< m, that places along the surface are from
  int phase;                     ///< that has plots of its own
  std::string phase_title;       ///< "on the path"
  double update_period;          ///< s, between two plans
  bool has_estimate = true;      ///< of the force, by the controller
};
/// force.svg, path.svg, torques.svg, solver.svg.
std::vector<PlotFile> run_plots(const PlottedRun& run);

/// Outcome, fault, surface, plans and rows; the page has its robot and phases already. `scene`: as
/// the controller knows it.
void add_run(RunPage& page, const TaskRun& run, const SceneSpec& scene,
             const Disturbances& disturbances, int record_every);

}  // namespace burnish::pressing
