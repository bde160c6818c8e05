// Run of a polishing task in simulation: controller, plant, disturbances, and the result.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "burnish/report/metrics.hpp"
#include "burnish/tasks/polishing/reach.hpp"
#include "burnish/tasks/pressing/plants.hpp"

namespace burnish::polishing {

/// Controller of a run.
/// @described polishing
enum class ControllerKind {
  Mpc,       ///< Model predictive control (MpcController)
  Baseline,  ///< Impedance with force feedback, no optimisation (make_impedance_controller())
  /// Admittance: the force error moves the targets of the joint positions
  /// (make_admittance_controller())
  Admittance,
};
std::string name_of(ControllerKind kind);  ///< Returns "mpc", "baseline" or "admittance".
using burnish::has_mujoco;
using burnish::PlantKind;
using burnish::TickTimes;

/// Options of run_task().
/// @described polishing
struct RunSpec {
  Task task;
  std::optional<Robot> robot = {};  ///< Robot to use instead of the robot that the task names
  ControllerKind controller = ControllerKind::Mpc;
  /// Plant to simulate; by default MuJoCo, if this build has it
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  /// Check before the run by statics whether the arm can do the task; throw Error if it cannot
  bool check_reach = true;
  ReachOptions reach = {};
  /// Recording rate of the plans of the MPC (0: no recording) [Hz]
  /// @more At most 20 000 plans are recorded.
  double plan_rate = 20.0;
  /// Callback that is called repeatedly with the simulated time and the run's expected end, in s
  /// @more If the callback returns false, the run stops.
  RunProgress progress = nullptr;
};

/// Results of a run that are compared with the requirements in Verdict.
struct VerdictFigures {
  double contact_share = 0.0;  ///< Time in contact, as a fraction of the time on the path.
  /// RMS error of the normal force, averaged over 10 ms, on the whole path [N].
  double force_rmse = 0.0;
  /// Fraction of the path's length on which the tip was over its target. The tip is over its target
  /// if its distance to the target along the surface is at most the tip's radius.
  double path_share = 0.0;
  /// Fraction of the path's length that can be travelled in Task::polish_duration. If the fraction
  /// is below 1, the run is cut short, and the required path_share is multiplied by this fraction.
  double path_allowed = 1.0;
};

/// Statistics of the hand that rests on a plane (Task::rest), over the time on the path. They are
/// computed from the plant's true force and position. The force is averaged over 10 ms.
struct RestFigures {
  double force_mean = 0.0;  ///< Mean normal force of the hand [N].
  double force_rmse = 0.0;  ///< RMS error of the normal force of the hand [N].
  double force_peak = 0.0;  ///< Largest error of the normal force of the hand [N].
  /// Largest distance that the hand slid on the plane since the start of the path [m]. Rolling of
  /// the round tip does not count.
  double slip = 0.0;
};

/// Result of run_task(). `succeeded` is true if three conditions are met: the tool followed the
/// path for the whole time on the path without a fault, the results meet the requirements in
/// Task::verdict, and no joint was more than 1e-3 rad (m) beyond its limits. `outcome` is one of
/// three texts: "polished: ...", the problem that ended the run, or "not polished: ..." with the
/// results that miss their requirements. If the time was too short for the path, "cut short: ..."
/// is added.
struct RunResult : TaskRun {
  Setting setting;
  ReachReport reach;  ///< Result of check_reach(); empty if the reach was not checked.
  /// Gains that fit_gains() changed, such as "model_error.transient_scale 1 in place of 6, ...";
  /// empty if there are none.
  std::string fitted;
  /// Metrics of the time on the path, without the start-up of a circle or spiral. None if the path
  /// was never reached.
  std::optional<Metrics> metrics;
  /// Results to compare with Task::verdict, over the part of the path that was run; none if the
  /// path was never reached.
  std::optional<VerdictFigures> verdict;
  /// Statistics of the resting hand; none without Task::rest, or if the path was never reached.
  std::optional<RestFigures> rest;
};

/// Runs the task in simulated time. An MPC run ends after the retreat, a run of the baseline or
/// admittance controller at the end of the path. Faults and other problems are in the result, with
/// the data recorded until then. Throws Error for contradictory settings, a path out of the arm's
/// reach, or a plant that this build does not have.
RunResult run_task(const RunSpec& spec);

/// Returns warnings for the user about settings that are possible but probably unintended, one
/// sentence each. One warning says that the plant equals the controller's model. If
/// `ideal_is_meant` is true, this warning is left out. Does not throw if check_task() accepts the
/// task.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

}  // namespace burnish::polishing
