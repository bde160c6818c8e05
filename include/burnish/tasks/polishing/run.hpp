// A polishing task run from start to end: controller, plant, what stands between, and the score.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/report/metrics.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/pressing/plants.hpp"

namespace burnish::polishing {

/// What controls a run.
/// @described polishing
enum class ControllerKind {
  Mpc,         ///< model predictive control (MpcController)
  Baseline,    ///< impedance with force feedback, no optimisation (make_impedance_controller())
  Admittance,  ///< force error to joint positions that are held (make_admittance_controller())
};
std::string name_of(ControllerKind kind);  ///< "mpc", "baseline" or "admittance"
using burnish::has_mujoco;
using burnish::PlantKind;
using burnish::TickTimes;

/// A run of a task.
/// @described polishing
struct RunSpec {
  Task task;
  std::optional<Robot> robot = {};  ///< in place of the one that the task names
  ControllerKind controller = ControllerKind::Mpc;
  /// MuJoCo where this build has it
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  bool check_reach = true;  ///< before anything moves; a problem is then an Error
  ReachOptions reach = {};
  /// [Hz], at which plans of the MPC are recorded, at most 20 000 of them; 0: none
  double plan_rate = 20.0;
  /// Called now and then with the simulated time and about when it will be over, s. Returning false
  /// stops the run.
  RunProgress progress = nullptr;
};

/// What Verdict is about, as it was.
struct VerdictFigures {
  double contact_share = 0.0;  ///< share of the time on the path that was in contact
  /// N, root mean square error of the force's mean over 10 ms, on all of the path
  double force_rmse = 0.0;
  double path_share = 0.0;  ///< share of the path's length along which the tip was over its target
  /// Share of the path's length that Task::polish_duration allows; below 1 the run is cut short,
  /// and judged by as much of the path.
  double path_allowed = 1.0;
};

/// Its outcome: that it polished, what came in between, or which figures the verdict does not bear,
/// as "not polished: ...". Where the time was too short for the path, "cut short" says so.
struct RunResult : TaskRun {
  Setting setting;
  ReachReport reach;  ///< empty unless it was checked
  /// "model_error.boost 1 in place of 6, ...": what fit_gains() chose; empty if nothing
  std::string fitted;
  bool polished = false;  ///< to the end of its time without fault, as Task::verdict asks for
  std::optional<Metrics> metrics;  ///< over the path after its start; none if it was never reached
  /// What Task::verdict is about, over all of the path that there was; none if it was never
  /// reached.
  std::optional<VerdictFigures> verdict;
};

/// Runs the task to the end of its retreat (without a plan: of the path) in simulated time. What
/// goes wrong on the way is in the result, with all that was recorded until then. Throws Error for
/// a task that does not fit together, one that the arm cannot reach, and a plant that is not there.
RunResult run_task(const RunSpec& spec);

/// What is possible in a task, but probably not meant: sentences for the user before a run; none if
/// nothing is odd. `ideal_is_meant`: no sentence says that the plant is exactly what the controller
/// believes. Throws nothing for a task that check_task() accepts.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

}  // namespace burnish::polishing
