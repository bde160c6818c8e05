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

/// How the trunk goes to and fro: a sine in each direction, begun and ended smoothly.
struct Sway {
  /// m, amplitudes of the centre of mass: x, y, z
  Eigen::Vector3d shift = Eigen::Vector3d(0.03, 0.02, 0.02);
  Eigen::Vector3d shift_rate = Eigen::Vector3d(0.5, 0.3, 0.7);  ///< Hz
  /// rad, amplitudes of the base: roll, pitch, yaw
  Eigen::Vector3d turn = Eigen::Vector3d(0.06, 0.06, 0.1);
  Eigen::Vector3d turn_rate = Eigen::Vector3d(0.4, 0.6, 0.3);  ///< Hz
  double rise = 1.5;                                           ///< s until it is that wide
  /// directions that the feet or the joints do not allow are left out, or made smaller; false: a
  /// sway that cannot be followed is refused
  bool fit = true;
};

/// Cost weights, per second of horizon.
struct Weights {
  double posture = 0.1;   ///< 1/rad^2: joints to the start
  double velocity = 0.1;  ///< s^2/rad^2: joint speeds
  double torque = 1e-4;   ///< 1/Nm^2: torques to those that hold the start
  double terminal = 0.1;  ///< s: what the end of the horizon costs, as a time at its running cost
};

struct Task {
  std::string robot = "quadruped";  ///< a robot's name, folder or settings file, with :variant
  /// where it starts, of the robot's settings; search: found, on bent legs. Empty: the robot's
  /// default, or searched where it has none.
  std::string posture = {};
  /// of the base's height above the feet with straight legs, that a searched posture is lower
  double crouch = 0.2;

  Standing standing = {.feet = {"fl_foot", "fr_foot", "rl_foot", "rr_foot"},
                       .half_x = 0.0,
                       .half_y = 0.0,
                       .radius = 0.018,
                       .balance = 1e4,
                       .base = 1e3};

  Sway sway = {};

  double settle_duration = 0.5;  ///< s of standing before it sways
  double sway_duration = 8.0;    ///< s that it sways
  double rest_duration = 1.0;    ///< s of standing afterwards

  double tick_rate = 1000.0;    ///< Hz, of torque commands
  double update_rate = 200.0;   ///< Hz, of new plans; divides the tick rate
  double solver_delay = 0.005;  ///< s from a measurement to the use of the plan made from it
  /// s from a command to the torque that it makes, as far as it is known. Rounded to ticks. Plans
  /// and feedback begin in the state that the torques already sent lead to.
  double command_delay = 0.0;
  /// s from what is measured to the tick that has it, as far as it is known
  double measurement_delay = 0.0;
  double horizon = 0.6;  ///< s that are planned ahead
  double step = 0.01;    ///< s between the first two knots of the plan
  int knots = 20;        ///< of the plan; the steps grow so that they fill the horizon
  Weights weights = {};
  ModelErrorOptions model_error = {.bandwidth = 60.0, .boost = 2.0, .fading = 0.2};

  PlanLimits constraints = {};

  double slip = 0.03;  ///< m that a foot may have slid; that a ball rolls is no sliding
  /// of the height of the centre of mass above the feet, that it may be below where it is to be
  double sink = 0.3;
  double tilt = 0.5;  ///< rad that the base may be turned off what it is to be
  SafetyLimits limits = {.torque_gap = 0.25};

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

/// The task with everything resolved.
struct Setting {
  Robot robot;
  /// The task's. Feet, with their sizes, are found where it states `auto`, or frames of which the
  /// robot has none; the frames that are added for them are in `robot`.
  Standing standing = {};
  std::vector<std::string> notes = {};  ///< sentences about what was found in place of what it says
  Eigen::VectorXd q_start;              ///< nq
  /// As the controller knows it: the feet are its supports; its surface is the ground, and its tip
  /// a small ball in the base that never touches it.
  SceneSpec scene;
  std::string base;  ///< a frame of the base's body
  /// axes that the sway is in, world: x forwards as the base is turned at the start, z up
  Eigen::Matrix3d heading;
  Eigen::Matrix3d R_base;  ///< axes of that frame at the start, world
  Eigen::Vector3d p_base;  ///< m, and its origin, world
  Eigen::Vector3d com;     ///< m, centre of mass at the start, world
  Sway sway = {};          ///< the task's, within what the feet allow where it is to fit
  double sway_end = 0.0;   ///< s of the schedule
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

struct RunSpec {
  Task task;
  std::optional<Setting> setting = {};  ///< of the task, where there is one already
  PlantKind plant = PlantKind::Mujoco;  ///< the ideal plant has no feet to stand on
  bool check_reach = true;              ///< before anything moves; a problem is then an Error
  double plan_rate = 20.0;              ///< Hz, at which plans are recorded; 0: none
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
