// Runs a task in closed loop with a plant until the task ends, and records the run.
#pragma once

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// Inputs of run_closed_loop(). Referenced objects must outlive the run.
struct ClosedRun {
  Controller& controller;
  double period;  ///< Time between ticks of the controller [s].
  const Model& model;
  const SceneSpec& scene;  ///< Nominal scene, which the controller assumes.
  const Disturbances& disturbances;
  const Eigen::VectorXd& q_start;  ///< Configuration at the start (nq), at rest.
  /// Move from the robot's home posture to q_start; null: the run begins at q_start.
  const HomeMove* home = nullptr;
  double longest;  ///< Longest simulated time, without the time after a fault [s].
  PlantKind plant = PlantKind::Ideal;
  /// Standing of the task; null for a fixed base. It determines the hoist, the estimation of the
  /// base, the force sensors of the feet, and for how long a run continues after a fault.
  const Standing* standing = nullptr;
  MpcController* mpc = nullptr;  ///< The controller if it is an MpcController, else null.
  /// With MPC: step of the knots [s], delay of plans [s], highest rate of recorded plans [Hz].
  double plan_step = 0.0, solver_delay = 0.0, plan_rate = 0.0;
  std::function<bool(double now, const Command& last)> goes_on = {};
  std::function<double()> end = {};  ///< Approximate end of the run [s].
  RunProgress progress = {};
};

/// Returns the pushes, and adds a frame to each push without a frame: the frame of the tip or,
/// without a tool, the frame of the floating base.
std::vector<Push> with_frames(std::vector<Push> pushes, const Model& model, const SceneSpec& scene);

/// Throws EntryError for "disturbances" if a run would refuse them, such as a push on an unknown
/// frame or slippery ground under a frame that is not a support. `scene`: nominal scene.
void check_disturbances(const Model& model, const SceneSpec& scene,
                        const Disturbances& disturbances);

/// Time and phase at the first fault of a run, or at the end of a run without a fault.
struct RunEnd {
  double time = 0.0;  ///< Simulated time [s].
  int phase = 0;      ///< Phase of the last command.
};

/// Runs the loop until goes_on() returns false, the plant fails, or the progress function stops the
/// run. After a fault, the run continues for a limited time. Throws Error for an unavailable plant
/// and for invalid disturbances.
RunEnd run_closed_loop(const ClosedRun& run, TaskRun& result);

/// Returns a sentence about what ended the run early: a failure of the plant, a fault, or an
/// interruption ("in phase ..."). Empty if nothing did. After a fault of a standing robot, the
/// sentence says whether the robot fell.
std::string trouble_of(const TaskRun& result, const RunEnd& end, const std::string& phase);

/// Returns how late contact may be before the run ends [s]: 3 s, or `limit` if it is finite and
/// longer. `limit`: longest time for which the controller waits for contact [s].
double patience(double limit);

}  // namespace burnish::pressing
