// Records of runs of all tasks that press or stand: statistics of tick durations and of standing,
// plots, and the HTML page of a run.
#pragma once

#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "record/run_files.hpp"

namespace burnish::pressing {

nlohmann::ordered_json ticks_json(const TaskRun& run);
/// Returns the statistics of a standing robot as JSON; null for a robot that does not stand.
nlohmann::ordered_json standing_json(const TaskRun& run);

/// Returns the names of all files that write_run_files() may write for a run.
std::vector<std::string> run_file_names();

/// Inputs of run_plots(). Referenced objects must outlive the plots.
struct PlottedRun {
  std::string name;
  const TaskRun& run;
  const Model& model;
  Eigen::Matrix3d surface_axes;
  Eigen::Vector3d origin_world;  ///< Origin of coordinates along the surface [m].
  int phase;                     ///< Phase that has its own plots.
  std::string phase_title;       ///< Title of the plots of `phase`, such as "on the path".
  double update_period;          ///< Time between two plans [s].
  bool has_estimate = true;      ///< Whether the controller estimates the force.
};
/// Returns the plots torques.svg and solver.svg and, if the robot has a tool, force.svg and
/// path.svg.
std::vector<PlotFile> run_plots(const PlottedRun& run);

/// Adds outcome, fault, surface, plans and rows of the trace to the HTML page of a run. The page
/// must already contain robot and phases. `scene`: nominal scene, which the controller assumes.
/// `surface`: nominal surface to draw, in the world.
void add_run(RunPage& page, const TaskRun& run, const SceneSpec& scene, const SurfaceSpec& surface,
             const Disturbances& disturbances, int record_every);

}  // namespace burnish::pressing
