// Task: a robot stands on its feet, sways its trunk as prescribed, and comes to rest again.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::stand {

/// Sway of the trunk: a sine in each direction that begins and ends smoothly. The axes of the sway
/// are level: x points forwards (as the base does at the start), y to the left, and z up.
/// @described stand
struct Sway {
  /// Amplitudes of the motion of the centre of mass along x, y and z [m]
  Eigen::Vector3d shift = Eigen::Vector3d(0.03, 0.02, 0.02);
  /// Frequencies of the motion of the centre of mass along x, y and z [Hz], >= 0
  Eigen::Vector3d shift_rate = Eigen::Vector3d(0.5, 0.3, 0.7);
  /// Amplitudes of the rotation of the base in roll, pitch and yaw [rad]
  Eigen::Vector3d turn = Eigen::Vector3d(0.06, 0.06, 0.1);
  /// Frequencies of the rotation of the base in roll, pitch and yaw [Hz], >= 0
  Eigen::Vector3d turn_rate = Eigen::Vector3d(0.4, 0.6, 0.3);
  /// Time until the sway has its full amplitude [s], > 0
  /// @more At the end, the sway fades out in the same time.
  double rise = 1.5;
  /// Reduce amplitudes that feet or joints do not allow; false: reject such amplitudes with an
  /// error
  /// @more An amplitude is reduced to 0 if needed.
  bool fit = true;
};

/// Cost weights. Each cost is integrated over the horizon, with time in s.
/// @described stand
struct Weights {
  /// Weight on joint angles relative to the starting posture [1/rad^2], >= 0
  double posture = 0.1;
  double velocity = 0.1;  ///< Weight on joint velocities [s^2/rad^2], >= 0
  /// Weight on torques relative to the torques that hold the starting posture [1/Nm^2], >= 0
  double torque = 1e-4;
  /// Duration that multiplies the weights in the terminal cost [s], >= 0
  double terminal = 0.1;
};

/// Task of standing on the feet while the trunk sways. The members are the keys of a task file,
/// with their defaults.
/// @described stand
struct Task {
  /// Name, folder or settings file of the robot, optionally followed by `:variant`
  std::string robot = "quadruped";
  /// Starting posture: a name from the robot's settings, or `search` (find one with bent legs)
  /// @more If empty, the robot's default posture is used; if there is none, a posture is searched.
  std::string posture = {};
  /// Drop of the base in a searched posture, as a fraction of the base's height, 0 to below 1
  /// @more The base's height is measured from the feet, with straight legs.
  double crouch = 0.2;

  /// Feet and ground of a robot with a floating base.
  Standing standing = {.feet = {"fl_foot", "fr_foot", "rl_foot", "rr_foot"},
                       .half_x = 0.0,
                       .half_y = 0.0,
                       .radius = 0.018,
                       .balance = 1e4,
                       .base = 1e3};

  /// Sway of the trunk: a sine in each direction that begins and ends smoothly.\nThe axes are
  /// level: x points forwards (as the base does at the start), y to the left, z up.
  Sway sway = {};

  // @section phases Stand, sway, then stand in the starting posture again.
  double settle_duration = 0.5;  ///< Time to stand before the sway [s], > 0
  double sway_duration = 8.0;    ///< Duration of the sway [s], > 0
  double rest_duration = 1.0;    ///< Time to stand after the sway [s], > 0

  // @section controller
  double tick_rate = 1000.0;   ///< Rate of torque commands [Hz], 100 to 1e4
  double update_rate = 200.0;  ///< Rate of new plans, tick_rate divided by an integer [Hz], > 0
  /// Time from a measurement to the use of the plan computed from the measurement [s], >= 0
  double solver_delay = 0.005;
  /// Assumed delay from a torque command to the torque in the joint [s], 0 to 0.1
  /// @more The delay is rounded to ticks. Plans and feedback start from a state that is predicted
  /// from the torques already sent.
  double command_delay = 0.0;
  /// Assumed delay from a measurement to the tick that receives it [s], 0 to 0.1
  double measurement_delay = 0.0;
  double horizon = 0.6;  ///< Duration that a plan covers [s], > 0
  double step = 0.01;    ///< Time between the first two knots of the plan [s], > 0
  /// Number of knots in the plan, >= 2
  /// @more The steps between knots grow to cover the horizon.
  int knots = 20;
  // @section -
  /// Cost weights; each cost is integrated over the horizon, with time in s. Only ratios of weights
  /// matter.\nA larger weight reduces the error of its own term and increases the errors of the
  /// other terms.
  Weights weights = {};
  /// Estimation of model errors from measurements. Each plan includes the estimate.
  ModelErrorOptions model_error = {.bandwidth = 60.0, .transient_scale = 2.0, .decay_time = 0.2};

  PlanLimits constraints = {};  ///< Hard constraints of plans; `never` switches a constraint off.

  // @section limits Exceeding a limit ends the run and is reported as a fault.\nThe fallback
  // controller then brakes and holds the robot. `never` switches a limit off.

  /// Largest distance that a foot may slide [m], > 0 or infinite
  /// @more Rolling of point feet does not count.
  double slip = 0.03;
  /// Largest drop of the centre of mass below its target, divided by its height, > 0 or infinite
  /// @more The height of the centre of mass is measured from the feet.
  double sink = 0.3;
  /// Largest allowed angle between the base and its target [rad], > 0 or infinite
  double tilt = 0.5;
  SafetyLimits limits = {.torque_gap = 0.25};

  // @section -

  /// Disturbances that the controller does not know.\nIn a task file, one of the words none,
  /// sensors, mismatch and joint_friction can replace all keys.\nWith the key `preset` and one of
  /// these words, only keys that differ from the preset are needed.
  Disturbances disturbances = {};
};

/// Reads a task file, which has the key `task: stand`. Missing keys get their defaults;
/// tasks/stand/quadruped.yaml states all keys. Then applies `overrides` in order. Each override is
/// a text "key.path=value" with a value in YAML. Throws Error with the file (or override), line,
/// key and requirement.
Task read_task(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// Reads a task from the text of a task file, as read_task() does. Error messages use `name` as the
/// file's name.
Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides = {});
/// Applies `overrides` to a task in order. Each override is a text "key.path=value" with a value in
/// YAML. Throws Error with the override and the requirement.
void override_task(Task& task, const std::vector<std::string>& overrides);
/// Checks the settings of a task. Throws Error if a number is out of range or if settings
/// contradict each other. The message is one sentence.
void check_task(const Task& task);
/// Returns the text of a complete task file, with the unit and meaning of every key. Reading this
/// text returns the same task.
std::string task_text(const Task& task);
/// Returns warnings for the user about settings that are probably unintended, one sentence each:
/// delays that differ from the assumed delays, and a plant that equals the controller's model. If
/// `ideal_is_meant` is true, the sentence about the plant is left out.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

/// Task with all settings filled in: robot, start, feet, trunk, phases.
/// @described stand
struct Setting {
  Robot robot;  ///< Robot of the task @required
  /// Feet and ground that the robot stands on
  /// @more If the task states `auto`, or only frames that the robot lacks, detected feet replace
  /// the feet of the task.
  /// @required
  /// @note `robot` contains the frames added for detected feet.
  Standing standing = {};
  /// Settings of the task that were replaced for this robot, one sentence each
  /// @after sway
  std::vector<std::string> notes = {};
  Eigen::VectorXd q_start;  ///< Configuration at the start, nq @required
  /// Scene as the controller assumes it: the feet are supports on the ground
  /// @more The robot has no tool
  /// @required
  SceneSpec scene;
  /// Ground: a plane at the height of the lowest foot, in the middle of the feet
  SurfaceSpec ground = {};
  std::string base;  ///< Name of a frame on the body of the floating base @required
  /// Axes of the sway in the world, as columns: forwards (as the base points at the start), left,
  /// up
  /// @required
  Eigen::Matrix3d heading;
  Eigen::Matrix3d R_base;  ///< Axes of the frame `base` at the start, in the world @required
  Eigen::Vector3d p_base;  ///< Origin of the frame `base` at the start, in the world [m] @required
  Eigen::Vector3d com;     ///< Centre of mass at the start, in the world [m] @required
  /// Sway of the task; if Sway.fit is true, the amplitudes are reduced to what feet and joints
  /// allow
  Sway sway = {};
  double sway_end = 0.0;  ///< Schedule time at the end of the sway [s]
};
/// Loads the robot of the task with a floating base, even if the description of the robot fixes the
/// base. Joints outside the legs are locked if they are too light to be controlled. Throws Error in
/// the same cases as load_robot().
Robot load_task_robot(const Task& task);
/// Fills in all settings of a task: loads the robot, finds the feet and the starting posture, and
/// computes the starting position of the trunk and the times of the phases. Throws Error for an
/// unknown robot, posture or foot, and for a planar foot that does not lie flat on the ground. Also
/// throws Error if a search finds no posture.
Setting make_setting(const Task& task);
/// Fills in all settings of a task for `robot`, which replaces the robot that the task names.
Setting make_setting(const Task& task, const Robot& robot);

/// Target of the trunk at one time: centre of mass, and orientation of the base.
struct Trunk {
  Eigen::Vector3d com;           ///< Position of the centre of mass in the world [m].
  Eigen::Vector3d com_velocity;  ///< Velocity of the centre of mass in the world [m/s].
  Eigen::Matrix3d base;          ///< Axes of the frame Setting::base in the world.
};
/// Returns the target of the trunk at the schedule time `time` [s].
Trunk trunk_at(const Task& task, const Setting& setting, double time);

/// Checks by statics whether the robot can stand at the start and during the whole sway. Throws
/// Error if no posture brings the trunk to its target, or if feet and joints cannot support the
/// weight within the constraints of plans. Robots with closed kinematic chains are not checked.
void refuse_out_of_reach(const Task& task, const Setting& setting);
/// Returns the specification of the task's model predictive controller. Throws Error if the start
/// violates constraints.joint_margin.
MpcSpec make_mpc(const Task& task, const Setting& setting);
/// Returns sentences for the user about differences between the task and the run with this robot.
/// The sentences report replaced settings, a smaller sway, ground that is too stiff for the feet,
/// foot directions that are not constrained, a softer fallback controller, and less sensor noise.
std::vector<std::string> setting_notes(const Task& task, const Setting& setting);

/// Options of run_task().
/// @described stand
struct RunSpec {
  Task task;
  /// Task with all settings filled in; none: computed by make_setting()
  std::optional<Setting> setting = {};
  /// Plant to simulate; must not be ideal, because the ideal plant has no feet
  PlantKind plant = PlantKind::Mujoco;
  /// Check before the run by statics whether the robot can do the task; throw Error if it cannot
  bool check_reach = true;
  double plan_rate = 20.0;  ///< Recording rate of plans (0: no recording) [Hz]
  /// Callback that is called repeatedly with the simulated time and the run's expected end, in s
  /// @more If the callback returns false, the run stops.
  RunProgress progress = {};
};

/// Statistics of the sway, from the true state of the plant. They cover the time from the beginning
/// of the sway to the end of the run. If a fault occurs, they end at the fault.
struct SwayFigures {
  double com_rmse = 0.0;   ///< RMS distance between the centre of mass and its target [m].
  double com_peak = 0.0;   ///< Largest distance between the centre of mass and its target [m].
  double turn_rmse = 0.0;  ///< RMS angle between the base and its target [rad].
  double turn_peak = 0.0;  ///< Largest angle between the base and its target [rad].
  /// RMS distance between the true and the estimated position of the base [m].
  double position_estimate_rmse = 0.0;
  /// RMS angle between the true and the estimated orientation of the base [rad].
  double orientation_estimate_rmse = 0.0;
  /// Largest distance that a foot slid along the ground from its position at the start [m]. Rolling
  /// of point feet does not count.
  double foot_slip = 0.0;
  /// Distance between the centre of mass at the end of the run and at the start [m].
  double com_end = 0.0;
};

/// Result of run_task().
struct RunResult : TaskRun {
  Setting setting;
  /// True if the robot had fallen when the run ended. A robot has fallen if its true centre of mass
  /// lost more than half of its height above the feet, or if its base turned by more than 1 rad.
  bool fell = false;
  std::optional<SwayFigures> sway;  ///< Statistics of the sway; none if the sway did not begin.
};
/// Runs the task in simulated time. Faults and other problems are in the result, with the data
/// recorded until then. Throws Error for contradictory settings, for feet that cannot support the
/// robot, and for a plant that has no feet or that this build does not have.
RunResult run_task(const RunSpec& spec);

/// Returns the names of the phases: settle, sway, rest. The index of a name is the phase number in
/// traces.
const std::vector<std::string>& phase_names();

}  // namespace burnish::stand
