// A task in closed loop with a plant, step by step until it is over, and what that leaves.
#pragma once

#include <optional>

#include "burnish/estimate/base_estimator.hpp"
#include "burnish/estimate/foot_contacts.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"

namespace burnish::pressing {

/// What is run. References outlive the run.
struct ClosedRun {
  Controller& controller;
  double period;  ///< s between its ticks
  const Model& model;
  const SceneSpec& scene;  ///< as the controller knows it
  const Disturbances& disturbances;
  const Eigen::VectorXd& q_start;  ///< nq, at rest
  double longest;                  ///< s that it may take, without what comes after a fault
  PlantKind plant = PlantKind::Ideal;
  /// What tells where a floating base is; without, it is known.
  std::optional<BaseEstimatorOptions> base_estimator = {};
  FootContactOptions foot_contacts = {};  ///< of that: when a foot stands
  bool support_sensors = true;            ///< what the robot stands on is measured
  /// The controller, where it is one, with the knots' step, delay (s) and at most the rate (Hz) of
  /// the plans that are recorded.
  MpcController* mpc = nullptr;
  double plan_step = 0.0, solver_delay = 0.0, plan_rate = 0.0;
  std::function<bool(double now, const Command& last)> goes_on = {};
  std::function<double()> end = {};  ///< s, about
  RunProgress progress = {};
  double after_fault = 0.0;  ///< s that the plant goes on after a fault, to see what becomes of it
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

/// What came in between: the plant's failure, the fault or the interruption ("in phase ...");
/// empty: none of them.
std::string trouble_of(const TaskRun& result, const RunEnd& end, const std::string& phase);

/// s that contact may come later than planned: longer than the controller waits (`limit`, s), if it
/// has a limit.
double patience(double limit);

}  // namespace burnish::pressing
