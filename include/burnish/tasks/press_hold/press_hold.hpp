// Task: press at a point with a constant force while the arm moves to another posture in the null
// space of the contact.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc_spec.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::press_hold {

/// Task of pressing at a point while the rest of the arm moves aside. The members are the keys of a
/// task file, with their defaults.
/// @described press_hold
struct Task {
  /// Name, folder or settings file of the robot, optionally followed by `:variant`
  std::string robot = "arm7";
  /// Starting posture: a name from the robot's settings, or `search` (find one for the surface)
  /// @more If empty, the robot's default posture is used; if there is none, a posture is searched.
  std::string posture = {};
  double force = 20.0;  ///< Normal force that the tool presses with [N], > 0
  /// Offsets from the starting posture that move the arm aside [{rad (m)}]: {joint: offset, ...}
  std::map<std::string, double> aside = {};

  // @section tool
  /// Frame of the tool; its origin is the centre of the round tip @key frame
  std::string tool = "tool";
  /// Pressing direction [x, y, z] in the tool's frame (automatic: away from the arm), not zero
  /// @more If robot.yaml defines the tool's frame, the automatic direction is the frame's z or -z
  /// axis. Otherwise it is the axis of the last joint; see pressing_direction(). The vector need
  /// not have unit length. If a starting posture is stated, the angle between the pressing
  /// direction and the direction into the surface must be at most search.tilt.
  /// @key axis @word auto
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< Radius of the round tip [m], > 0

  // @section surface The surface lies at the distance `clearance` from the tool at the start. The
  // controller knows the surface's normal.

  /// Normal of the surface [x, y, z] in world axes, towards the robot, not zero
  /// @more The normal points out of the material. It need not have unit length.
  /// @key normal
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// Distance from the pressed point to the surface's four edges (`endless`: no edges) [m], > 0 or
  /// infinite
  /// @more The word `endless` stands for infinite; the surface is then a whole plane.
  /// @word endless
  double extent = 0.1;
  /// Coulomb friction coefficient, unless disturbances.surface_friction states another one, >= 0
  double friction = 0.0;
  double stiffness = 1e5;     ///< Stiffness of the surface in the plant [N/m], > 0
  double damping = 500.0;     ///< Damping of the surface in the plant [Ns/m], >= 0
  PostureLimits search = {};  ///< Requirements on a starting posture that is found by a search.

  // @section phases Approach until contact, ramp the force, move aside, hold, retreat.
  double clearance = 0.01;       ///< Distance between tool and surface at the start [m], > 0
  double approach_speed = 0.03;  ///< Speed towards the surface [m/s], > 0
  /// Pressing force of the tool right after contact [N], >= 0
  double touch_force = 5.0;
  double ramp_duration = 0.5;   ///< Duration of the ramp from touch_force to force [s], > 0
  double aside_duration = 2.0;  ///< Duration of the move aside [s], > 0
  double hold_duration = 1.0;   ///< Time for which the arm stays aside [s], > 0
  /// Duration of the retreat from the surface to the distance `clearance` [s], > 0
  double retreat_duration = 0.5;

  // @section controller
  double tick_rate = 1000.0;  ///< Rate of torque commands and of new plans [Hz], 100 to 1e4
  /// Assumed delay from a torque command to the torque in the joint [s], 0 to 0.1
  /// @more The delay is rounded to ticks. Plans and feedback start from a state that is predicted
  /// from the torques already sent.
  double command_delay = 0.0;
  /// Assumed delay from a measurement to the tick that receives it [s], 0 to 0.1
  double measurement_delay = 0.0;
  /// Weight on deviations of joint angles from the motion aside [1/rad^2], > 0
  /// @more For comparison, the weight on the tool's position is 1e4 1/m^2.
  double posture_weight = 1.0;

  PlanLimits constraints = {};  ///< Hard constraints of plans; `never` switches a constraint off.

  // @section limits Exceeding a limit ends the run and is reported as a fault.\nThe fallback
  // controller then brakes and holds the robot. `never` switches a limit off.

  /// Largest distance that the tool may slide away from the pressed point [m], > 0 or infinite
  /// @after contact_threshold
  double slip = 0.01;
  SafetyLimits limits = {};
  ToolLimits tool_limits = {};  ///< @key limits
  /// Normal force above which the tool counts as in contact [N], > 0 or infinite
  /// @more The noise of the force is measured in free air. If six standard deviations of the noise
  /// exceed the threshold, the force is averaged over 5 ms. For contact, the average must then
  /// exceed the threshold, and also six standard deviations of the noise that is left after
  /// averaging.
  double contact_threshold = 2.0;

  // @section -

  /// Disturbances that the controller does not know.\nIn a task file, one of the words none,
  /// sensors, mismatch and joint_friction can replace all keys.\nWith the key `preset` and one of
  /// these words, only keys that differ from the preset are needed.
  Disturbances disturbances = {};
};

/// Reads a task file, which has the key `task: press_hold`. Missing keys get their defaults;
/// tasks/press_hold/arm7.yaml states all keys. Then applies `overrides` in order. Each override is
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
/// delays that differ from the assumed delays, a surface friction without effect because
/// disturbances set another one, and a plant that equals the controller's model. If
/// `ideal_is_meant` is true, the sentence about the plant is left out.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

/// Task with all settings filled in: robot, start, surface, phases.
/// @described press_hold
struct Setting {
  Robot robot;  ///< Robot of the task @required
  /// Configuration at the start, nq entries; also the first reference of the joint angles
  /// @required
  Eigen::VectorXd q_start;
  /// Configuration with the arm moved aside, nq entries; also the last reference of the joint
  /// angles
  /// @required
  Eigen::VectorXd q_aside;
  SceneSpec scene;  ///< Tip and surface as the controller assumes them @required
  /// Axes of the surface in the world; the columns are two tangents and the normal
  /// @required
  Eigen::Matrix3d surface_axes;
  Eigen::Vector3d p_hold;  ///< Position of the tool in contact, in the world [m] @required
  double touch = 0.0;      ///< Schedule time of the planned contact [s]
  double ramp_end = 0.0;   ///< Schedule time at the end of the force ramp [s]
  double hold_end = 0.0;   ///< Schedule time at the end of the hold [s]
};
/// Loads the robot of the task. If the task names a URDF file, which has no settings, only the
/// joints that carry the tool move. All other joints are then held at zero. Throws Error in the
/// same cases as load_robot().
Robot load_task_robot(const Task& task);
/// Adapts a task that was written for another robot to `robot`, and returns a sentence for each
/// change. If `robot` does not have the task's posture, a posture is searched instead. If `robot`
/// has none of the joints in Task::aside, the third joint from the base moves aside instead, by the
/// first offset in Task::aside. The offset is reversed or shortened if it would violate a joint
/// limit. Throws Error in the same cases as make_setting().
std::vector<std::string> fit_to_robot(Task& task, const Robot& robot);
/// Fills in all settings of a task: loads the robot, finds the starting posture, places the
/// surface, and computes the times of the phases. Throws Error for an unknown robot, posture, tool
/// frame or joint, and for a floating base. Also throws Error if a search finds no posture, or if
/// an offset in `aside` would exceed a joint limit.
Setting make_setting(const Task& task);
/// Fills in all settings of a task for `robot`, which replaces the robot that the task names.
Setting make_setting(const Task& task, const Robot& robot);
/// Checks by statics whether the arm can move from the start to the surface and press there, with
/// the conditions of polishing::check_reach(). The move aside is not checked.
ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options = {});
/// Throws Error if check_reach() finds a problem.
void refuse_out_of_reach(const Task& task, const Setting& setting);
/// Returns the specification of the task's model predictive controller. Throws Error if the start
/// violates constraints.joint_margin.
MpcSpec make_mpc(const Task& task, const Setting& setting);

/// Options of run_task().
/// @described press_hold
struct RunSpec {
  Task task;
  /// Task with all settings filled in; none: computed by make_setting()
  std::optional<Setting> setting = {};
  /// Plant to simulate; by default MuJoCo, if this build has it
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  /// Check before the run by statics whether the robot can do the task; throw Error if it cannot
  bool check_reach = true;
  double plan_rate = 20.0;  ///< Recording rate of plans (0: no recording) [Hz]
  /// Callback that is called repeatedly with the simulated time and the run's expected end, in s
  /// @more If the callback returns false, the run stops.
  RunProgress progress = {};
};

/// Statistics of the move aside and of the hold after the move, from the end of the force ramp on.
struct HoldFigures {
  /// Largest displacement of a joint between the end of the ramp and the end of the hold [rad (m)].
  double moved_aside = 0.0;
  /// Largest distance that the tool slid away from the pressed point [m].
  double slip = 0.0;
};

/// Result of run_task().
struct RunResult : TaskRun {
  Setting setting;
  /// Metrics of the time from 0.2 s after the force ramp to 0.02 s before the retreat. None if the
  /// run ended less than about 0.5 s after the ramp.
  std::optional<Metrics> metrics;
  /// Statistics of the hold. None if the run ended less than about 0.5 s after the force ramp.
  std::optional<HoldFigures> hold;
};
/// Runs the task in simulated time. Faults and other problems are in the result, with the data
/// recorded until then. Throws Error for contradictory settings, a point out of the arm's reach, or
/// a plant that this build does not have.
RunResult run_task(const RunSpec& spec);

/// Returns the names of the phases: approach, ramp, aside, hold, retreat. The index of a name is
/// the phase number in traces.
const std::vector<std::string>& phase_names();

}  // namespace burnish::press_hold
