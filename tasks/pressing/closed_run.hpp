// A task in closed loop with a plant, step by step until it is over, and what that leaves.
#pragma once

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::pressing {

/// What is run. References outlive the run.
struct ClosedRun {
  Controller& controller;
  double period;  ///< s between its ticks
  const Model& model;
  const SceneSpec& scene;  ///< as the controller knows it
  const Disturbances& disturbances;
  const Eigen::VectorXd& q_start;  ///< nq, at rest
  /// From where the run begins in place of q_start; null: there.
  const HomeMove* home = nullptr;
  double longest;  ///< longest simulated time, without what follows a fault [s]
  PlantKind plant = PlantKind::Ideal;
  /// How the robot stands, where its task says so: what holds it at first, whether its base is
  /// estimated and its feet have sensors, and for how long a run goes on after a fault.
  const Standing* standing = nullptr;
  /// The controller, where it is one, with the knots' step, delay (s) and at most the rate (Hz) of
  /// the plans that are recorded.
  MpcController* mpc = nullptr;
  double plan_step = 0.0, solver_delay = 0.0, plan_rate = 0.0;
  std::function<bool(double now, const Command& last)> goes_on = {};
  std::function<double()> end = {};  ///< s, about
  RunProgress progress = {};
};

/// Where a run ended, or had a fault.
struct RunEnd {
  double time = 0.0;  ///< s
  int phase = 0;      ///< of the last command
};

/// Runs until goes_on() says no, the plant fails, a fault came and what comes after it is over, or
/// the progress function stops it.
/// Throws Error for a plant that is not there and disturbances that do not fit.
RunEnd run_closed_loop(const ClosedRun& run, TaskRun& result);

/// What came in between: the plant's failure, the fault with what became of a robot that stood, or
/// the interruption ("in phase ..."); empty: none of them.
std::string trouble_of(const TaskRun& result, const RunEnd& end, const std::string& phase);

/// s that contact may come later than planned: longer than the controller waits (`limit`, s), if it
/// has a limit.
double patience(double limit);

}  // namespace burnish::pressing
