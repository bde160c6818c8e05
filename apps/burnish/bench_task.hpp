// Durations of a task controller's computations on this machine. The parts of a plan are measured
// separately. Ticks are measured in real time, while another thread computes the plans.
#pragma once

#include <string>

#include "burnish/mpc/fault.hpp"
#include "burnish/tasks/polishing/task.hpp"

namespace burnish::app {

struct TaskBenchSpec {
  polishing::Task task = {};
  double seconds = 10.0;  ///< Duration of the path, in real time [s].
  int threads = 1;        ///< Number of threads that share the computation of a plan.
};

/// Statistics of measured durations.
struct Spread {
  long count = 0;
  double median = 0.0, p99 = 0.0, maximum = 0.0;  ///< Durations [s].
};

/// Durations of the computation of plans on the path. The plans are computed one after the other,
/// in simulated time.
struct PlanTimes {
  Spread whole = {}, expand = {}, backward = {}, trial = {};
  /// Mean number of Riccati recursions per plan; above one if constraints are active.
  double recursions = 0.0;
};

/// Results of a run in real time, on the path.
struct RealTime {
  long ticks = 0;
  long missed = 0;    ///< Number of ticks that were still running when the next tick was due.
  Spread tick = {};   ///< Duration of a tick, including the estimation of a floating base.
  Spread woken = {};  ///< Delay from the due time of a tick to its start.
  Spread plan = {};   ///< Duration of a plan in its own thread.
  Spread age = {};  ///< Age of the plan in use (time since its measurement), sampled at every tick.
  double plans_per_second = 0.0;
  /// Number of memory allocations; negative: not counted in this build.
  long tick_allocations = 0, plan_allocations = 0;
  double plant_share = 0.0;   ///< Fraction of the tick thread's time that the simulator uses.
  bool has_priority = false;  ///< True if the tick thread has real-time priority (SCHED_FIFO).
  double force_rmse = 0.0;    ///< RMS error of the simulated contact force [N].
  double path_rmse = 0.0;     ///< RMS error of the simulated position along the path [m].
  FaultReport fault = {};
};

struct TaskBenchReport {
  std::string robot = {};
  int nv = 0, nx = 0, nu = 0, knots = 0, threads = 1, pack_width = 1;
  int cores = 0;              ///< Number of cores that this process may use.
  double horizon = 0.0;       ///< Duration of the horizon [s].
  double tick_period = 1e-3;  ///< Period of the control ticks [s].
  PlanTimes plans = {};
  RealTime real = {};
};

/// Measures the computing times of the controller of `spec`. Throws Error for an inconsistent task,
/// and if the run in simulated time fails.
TaskBenchReport measure_task(const TaskBenchSpec& spec);

}  // namespace burnish::app
