// How long the controller of a task takes on this machine: its plans by their parts, and ticks in
// real time with plans made in a thread beside them.
#pragma once

#include <string>

#include "burnish/mpc/fault.hpp"
#include "burnish/tasks/polishing/task.hpp"

namespace burnish::app {

struct TaskBenchSpec {
  polishing::Task task = {};
  double seconds = 10.0;  ///< s of the path, in real time
  int threads = 1;        ///< that share a plan
};

/// Of many times.
struct Spread {
  long count = 0;
  double median = 0.0, p99 = 0.0, maximum = 0.0;  ///< s
};

/// Plans one after the other in simulated time, of as many threads; those on the path.
struct PlanTimes {
  Spread whole = {}, expand = {}, backward = {}, trial = {};
  double recursions = 0.0;  ///< per plan, mean: more than one where limits push
};

/// On the path.
struct RealTime {
  long ticks = 0;
  long missed = 0;    ///< ticks that were not done when the next was due
  Spread tick = {};   ///< with the estimate of the base, where there is one
  Spread woken = {};  ///< from when a tick was due until it began
  Spread plan = {};   ///< from its start to its end, in its thread
  Spread age = {};    ///< of the plan in use, since its measurement, at every tick
  double plans_per_second = 0.0;
  /// Negative: not counted in this build.
  long tick_allocations = 0, plan_allocations = 0;
  double plant_share = 0.0;   ///< of the time, that the simulator had in the thread of the ticks
  bool has_priority = false;  ///< ticks go before all other threads (SCHED_FIFO)
  double force_rmse = 0.0;    ///< N, true
  double path_rmse = 0.0;     ///< m, true
  FaultReport fault = {};
};

struct TaskBenchReport {
  std::string robot = {};
  int nv = 0, nx = 0, nu = 0, knots = 0, threads = 1, pack_width = 1;
  int cores = 0;              ///< that this program may run on
  double horizon = 0.0;       ///< s
  double tick_period = 1e-3;  ///< s
  PlanTimes plans = {};
  RealTime real = {};
};

/// Throws Error for a task that does not fit together, and where the run failed in simulated time.
TaskBenchReport measure_task(const TaskBenchSpec& spec);

}  // namespace burnish::app
