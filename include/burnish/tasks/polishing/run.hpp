// A polishing task run from start to end: controller, plant, what stands between, and the score.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/base/trace.hpp"
#include "burnish/mpc/fault.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/report/plan_record.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/pressing/plants.hpp"

namespace burnish::polishing {

enum class ControllerKind {
  Mpc,       ///< model predictive control (MpcController)
  Baseline,  ///< impedance with force feedback, no optimisation (make_impedance_controller())
};
std::string name_of(ControllerKind kind);  ///< "mpc" or "baseline"
using burnish::has_mujoco;
using burnish::PlantKind;

struct RunSpec {
  Task task;
  std::optional<Robot> robot = {};  ///< in place of the one that the task names
  ControllerKind controller = ControllerKind::Mpc;
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  bool check_reach = true;  ///< before anything moves; a problem is then an Error
  ReachOptions reach = {};
  /// Hz, at which plans of the MPC are recorded, at most 20 000 of them; 0: none
  double plan_rate = 20.0;
  /// Called now and then with the simulated time and about when it will be over, s. Returning false
  /// stops the run.
  std::function<bool(double time, double end)> progress = nullptr;
};

/// What Verdict is about, as it was.
struct VerdictFigures {
  double contact_share = 0.0;  ///< of the time on the path
  double force_rmse = 0.0;     ///< N
  double path_share = 0.0;     ///< of the path's length
};

/// Wall clock of the controller's ticks after the first, s.
struct TickTimes {
  int count = 0;        ///< ticks that were timed: every nth of more than a million
  double period = 0.0;  ///< between two ticks: what they must stay below
  double median = 0.0, p99 = 0.0, maximum = 0.0, mean = 0.0;
  int late = 0;  ///< ticks that took longer than a period
};

struct RunResult {
  Setting setting;
  ReachReport reach;  ///< empty unless it was checked
  Trace trace;        ///< of every plant step, every nth beyond 100 s; see ClosedLoop
  PlanRecord plans;
  Status plant_status = Status::Ok;
  FaultReport fault;               ///< of the MPC; FaultKind::None without
  bool interrupted = false;        ///< by the progress function
  bool polished = false;           ///< to the path's end without fault, as Task::verdict asks for
  std::optional<Metrics> metrics;  ///< over the path after its start; none if it was never reached
  /// What Task::verdict is about, over all of the path that there was; none if it was never
  /// reached.
  std::optional<VerdictFigures> verdict;
  TickTimes ticks;          ///< after the first, which solves to its end
  double first_tick = 0.0;  ///< s of wall clock
  double wall_time = 0.0;   ///< s, of the simulation
  /// One sentence: that it polished, what came in between, or which figures the verdict does not
  /// bear, as "not polished: ..." or, where the time was too short for the path, "stopped early:
  /// ...".
  std::string outcome;
};

/// Runs the task to the end of its retreat (the baseline's: of the path) in simulated time. What
/// goes wrong on the way is in the result, with all that was recorded until then. Throws Error for
/// a task that does not fit together, one that the arm cannot reach, and a plant that is not there.
RunResult run_task(const RunSpec& spec);

/// What is possible in a task, but probably not meant: sentences for the user before a run on this
/// plant; none if nothing is odd. Throws nothing for a task that check_task() accepts.
std::vector<std::string> task_notes(const Task& task, PlantKind plant);

}  // namespace burnish::polishing
