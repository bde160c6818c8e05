// The task of standing: a robot on its feet whose trunk sways as it is told and comes back to rest.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::stand {

/// How the trunk goes to and fro: a sine in each direction, begun and ended smoothly. Axes are x
/// forwards as the base is turned at the start, y to its left, z up.
/// @described stand
struct Sway {
  /// [m], amplitudes of the centre of mass: x, y, z
  Eigen::Vector3d shift = Eigen::Vector3d(0.03, 0.02, 0.02);
  Eigen::Vector3d shift_rate = Eigen::Vector3d(0.5, 0.3, 0.7);  ///< [Hz], >= 0
  /// [rad], amplitudes of the base: roll, pitch, yaw
  Eigen::Vector3d turn = Eigen::Vector3d(0.06, 0.06, 0.1);
  Eigen::Vector3d turn_rate = Eigen::Vector3d(0.4, 0.6, 0.3);  ///< [Hz], >= 0
  double rise = 1.5;                                           ///< [s] until it is that wide, > 0
  /// directions that the feet or the joints do not allow are left out, or made smaller; false: a
  /// sway that cannot be followed is refused
  bool fit = true;
};

/// Cost weights, per second of horizon.
/// @described stand
struct Weights {
  double posture = 0.1;   ///< [1/rad^2]: joints to the start, >= 0
  double velocity = 0.1;  ///< [s^2/rad^2]: joint speeds, >= 0
  double torque = 1e-4;   ///< [1/Nm^2]: torques to those that hold the start, >= 0
  /// [s]: what the end of the horizon costs, as a time at its running cost, >= 0
  double terminal = 0.1;
};

/// The task of standing on feet and swaying: all that a task file may say, with its defaults.
/// @described stand
struct Task {
  std::string robot = "quadruped";  ///< a robot's name, folder or settings file, with :variant
  /// where it starts, of the robot's settings; search: found, on bent legs @more Empty: the robot's
  /// default, or searched where it has none.
  std::string posture = {};
  /// of the base's height above the feet with straight legs, that a searched posture is lower, 0 to
  /// below 1
  double crouch = 0.2;

  /// What the robot stands on.
  Standing standing = {.feet = {"fl_foot", "fr_foot", "rl_foot", "rr_foot"},
                       .half_x = 0.0,
                       .half_y = 0.0,
                       .radius = 0.018,
                       .balance = 1e4,
                       .base = 1e3};

  /// How the trunk goes to and fro: a sine in each direction, begun and ended smoothly.\nAxes are x
  /// forwards as the base is turned at the start, y to its left, z up. @code how the trunk goes to
  /// and fro
  Sway sway = {};

  // @section phases Stand, sway, come back and stand.
  double settle_duration = 0.5;  ///< [s] of standing before it sways, > 0
  double sway_duration = 8.0;    ///< [s] that it sways, > 0
  double rest_duration = 1.0;    ///< [s] of standing afterwards, > 0

  // @section controller
  double tick_rate = 1000.0;   ///< [Hz], of torque commands, 100 to 1e4
  double update_rate = 200.0;  ///< [Hz], of new plans; divides the tick rate, > 0
  /// [s] from a measurement to the use of the plan made from it, >= 0
  double solver_delay = 0.005;
  /// Delay from command to torque that the controller assumes [s], 0 to 0.1 @more Rounded to ticks.
  /// Plans and feedback begin in the state that the torques already sent lead to.
  double command_delay = 0.0;
  /// Delay from measurement to tick that the controller assumes [s], 0 to 0.1
  double measurement_delay = 0.0;
  double horizon = 0.6;  ///< [s] that are planned ahead, > 0
  double step = 0.01;    ///< [s] between the first two knots of the plan, > 0
  int knots = 20;        ///< of the plan; the steps grow so that they fill the horizon, >= 2
  // @section -
  Weights weights = {};  ///< Cost weights, per second of horizon.
  /// What is estimated of what the model gets wrong.
  ModelErrorOptions model_error = {.bandwidth = 60.0, .boost = 2.0, .fading = 0.2};

  PlanLimits constraints = {};  ///< What plans keep, whatever it costs. Each may be never.

  // @section limits Beyond these a run is given up: the robot is braked and held (fallback), and
  // there is a report.\nEach may be never.
  /// [m] that a foot may have slid; that a ball rolls is no sliding, > 0 or infinite
  double slip = 0.03;
  /// of the height of the centre of mass above the feet, that it may be below where it is to be, >
  /// 0 or infinite
  double sink = 0.3;
  double tilt = 0.5;  ///< [rad] that the base may be turned off what it is to be, > 0 or infinite
  SafetyLimits limits = {.torque_gap = 0.25};

  // @section -
  /// What the controller does not know. Or one word: none, sensors, mismatch, joint_friction;
  /// or\n`preset: word` and keys that differ from it. @code what the controller does not know
  Disturbances disturbances = {};
};

/// A file with `task: stand`. Keys that it does not state keep their defaults;
/// tasks/stand/quadruped.yaml states all. `overrides` are applied after it, in order, each
/// "key.path=value" with a value in YAML. Throws Error naming file (or override), line, key and
/// what was wanted.
Task read_task(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});
/// The same from a text; `name` stands for the file's in refusals.
Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides = {});
/// Applies overrides to a task. Throws Error as read_task() does.
void override_task(Task& task, const std::vector<std::string>& overrides);
/// Throws Error with a sentence for numbers out of range, and for those that are possible each but
/// not together.
void check_task(const Task& task);
/// The whole task as such a file, every key with its unit and meaning; reads back as it was.
std::string task_text(const Task& task);
/// Returns a sentence for each stated key that has no effect in this task, and one for a plant that
/// is exactly what the controller believes, unless that is meant.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

/// A task with everything resolved: robot, start, feet, trunk, phases.
/// @described stand
struct Setting {
  Robot robot;  ///< @required
  /// the task's, with feet that were found where it states auto, or frames of which the robot has
  /// none @required @note Frames that are added for feet are in `robot`.
  Standing standing = {};
  /// sentences about what was found in place of what it says @after sway
  std::vector<std::string> notes = {};
  Eigen::VectorXd q_start;  ///< nq @required
  /// as the controller knows it: the feet are its supports; its surface is the ground, and its tip
  /// a small ball in the base that never touches it @required
  SceneSpec scene;
  std::string base;  ///< a frame of the base's body @required
  /// axes that the sway is in, world: x forwards as the base is turned at the start, z up @required
  Eigen::Matrix3d heading;
  Eigen::Matrix3d R_base;  ///< axes of that frame at the start, world @required
  Eigen::Vector3d p_base;  ///< [m], and its origin, world @required
  Eigen::Vector3d com;     ///< [m], centre of mass at the start, world @required
  Sway sway = {};          ///< the task's, within what the feet allow where it is to fit
  double sway_end = 0.0;   ///< [s] of the schedule
};
/// The task's robot, whose base floats whatever its description says of it. Throws Error as
/// load_robot() does.
Robot load_task_robot(const Task& task);
/// Throws Error for a robot, posture or foot that there is not, a posture that is searched and not
/// found, and a sole that does not lie on the ground.
Setting make_setting(const Task& task);
/// The same for a robot at hand, whatever the task says of it.
Setting make_setting(const Task& task, const Robot& robot);

/// Where the trunk is to be.
struct Trunk {
  Eigen::Vector3d com;           ///< m, world
  Eigen::Vector3d com_velocity;  ///< m/s, world
  Eigen::Matrix3d base;          ///< axes of Setting::base, world
};
/// At a time of the schedule, s.
Trunk trunk_at(const Task& task, const Setting& setting, double time);

/// Throws Error where the feet, at rest and within the limits that plans keep, could not bear the
/// robot at the start or somewhere on its way, and where no posture has the trunk there. Of robots
/// with closed chains nothing is said.
void refuse_out_of_reach(const Task& task, const Setting& setting);
MpcSpec make_mpc(const Task& task, const Setting& setting);
/// Returns a sentence for everything that this robot is given other than the task says: directions
/// that its feet do not hold by themselves, parts of the sway, how it is held.
std::vector<std::string> setting_notes(const Task& task, const Setting& setting);

/// A run of a task.
/// @described stand
struct RunSpec {
  Task task;
  std::optional<Setting> setting = {};  ///< of the task, where there is one already
  PlantKind plant = PlantKind::Mujoco;  ///< the ideal plant has no feet to stand on
  bool check_reach = true;              ///< before anything moves; a problem is then an Error
  double plan_rate = 20.0;              ///< [Hz], at which plans are recorded; 0: none
  /// Called now and then with the simulated time and about when it will be over, s. Returning false
  /// stops the run.
  RunProgress progress = {};
};

/// Of the plant's true places, from where the sway begins to the end of the run or a fault.
struct SwayFigures {
  double com_rmse = 0.0;   ///< m, root mean square distance of the centre of mass from its way
  double com_peak = 0.0;   ///< m, largest distance of the centre of mass from its way
  double turn_rmse = 0.0;  ///< rad, root mean square angle of the base off its way
  double turn_peak = 0.0;  ///< rad, largest angle of the base off its way
  /// m, root mean square distance of the base from where the controller believes it to be
  double believed_place = 0.0;
  /// rad, root mean square angle of the base off what the controller believes
  double believed_turn = 0.0;
  /// m, farthest that a foot was off its start, along the ground; that a ball rolls is none
  double foot_slip = 0.0;
  /// m, of the centre of mass off its place at the start, when the run ends
  double com_end = 0.0;
};

struct RunResult : TaskRun {
  Setting setting;
  bool done = false;  ///< to the end without fault, and on its feet
  /// in truth, when the run ended: the centre of mass lost half of its height above the feet, or
  /// the base turned by more than 1 rad
  bool fell = false;
  std::optional<SwayFigures> sway;  ///< none where it did not come to sway
};
/// Runs the task in simulated time. What goes wrong on the way is in the result, with all that was
/// recorded until then. Throws Error for a task that does not fit together, one that the feet do
/// not bear, and a plant that is not there or has no feet.
RunResult run_task(const RunSpec& spec);

/// Of the schedule, as the numbers of a trace: settle, sway, rest.
const std::vector<std::string>& phase_names();

}  // namespace burnish::stand
