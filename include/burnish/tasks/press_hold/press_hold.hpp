// The task of pressing at a point while the rest of the arm moves aside: force and point are held,
// and the posture goes elsewhere in the null space.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/mpc/mpc.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/robots/robot.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/reach.hpp"

namespace burnish::press_hold {

/// The task of pressing at a point while the arm moves aside: all that a task file may say, with
/// its defaults.
/// @described press_hold
struct Task {
  std::string robot = "arm7";  ///< a robot's name, folder or settings file, with :variant
  /// where it starts; search: found for the surface @more Of the robot's settings. Empty: the
  /// robot's default, or searched where it has none.
  std::string posture = {};
  double force = 20.0;  ///< Normal force that the tool presses with [N], > 0
  /// {rad (m)}, offset of each joint from the start: {joint: way, ...}
  std::map<std::string, double> aside = {};

  // @section tool
  std::string tool = "tool";  ///< its origin is the centre of a round tip @key frame
  /// [x, y, z] that it presses along, in its frame; or auto: z or -z of a frame of robot.yaml, of
  /// others the last joint's axis, away from the arm, not zero @code that the tool presses along,
  /// in its frame, any length; without it see pressing_direction() @more a posture that is given
  /// must agree with it, within search.tilt @key axis @word auto
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< Radius of the round tip [m], > 0

  // @section surface The surface lies `clearance` from the tool at the start. The
  // controller knows its normal.
  /// [x, y, z] out of the material towards the robot, any length, world, not zero @code out of the
  /// surface, any length @key normal
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// [m] that there is surface beyond the point, on all four sides; or endless, > 0 or infinite
  /// @word endless
  double extent = 0.1;
  /// Coulomb coefficient of the plant, unless disturbances.surface_friction says another, >= 0
  double friction = 0.0;
  double stiffness = 1e5;     ///< [N/m], of the plant, > 0
  double damping = 500.0;     ///< {Ns/m}, of the plant, >= 0
  PostureLimits search = {};  ///< What a posture that is searched keeps to.

  // @section phases Approach until contact, ramp the force, move aside, hold, retreat.
  double clearance = 0.01;        ///< [m] between tool and surface at the start, > 0
  double approach_speed = 0.03;   ///< [m/s] towards the surface, > 0
  double touch_force = 5.0;       ///< [N], at once where contact is made, >= 0
  double ramp_duration = 0.5;     ///< [s] from touch_force to force, > 0
  double aside_duration = 2.0;    ///< [s] that the posture takes to go aside, > 0
  double hold_duration = 1.0;     ///< [s] that it stays there, > 0
  double retreat_duration = 0.5;  ///< [s] off the surface, by the clearance, > 0

  // @section controller
  double tick_rate = 1000.0;  ///< [Hz], of torque commands and of new plans, 100 to 1e4
  /// Delay from command to torque that the controller assumes [s], 0 to 0.1 @more Rounded to ticks.
  /// Plans and feedback begin in the state that the torques already sent lead to.
  double command_delay = 0.0;
  /// Delay from measurement to tick that the controller assumes [s], 0 to 0.1
  double measurement_delay = 0.0;
  /// [1/rad^2]: joints to where they shall be, beside 1e4 1/m^2 of the point, > 0
  double posture_weight = 1.0;

  PlanLimits constraints = {};  ///< What plans keep, whatever it costs. Each may be never.

  // @section limits Beyond these a run is given up: the arm is braked and held (fallback), and
  // there is a report.\nEach may be never.
  /// [m] that the tool may be off its point, along the surface, > 0 or infinite @after
  /// contact_threshold
  double slip = 0.01;
  SafetyLimits limits = {};
  ToolLimits tool_limits = {};  ///< @key limits
  /// [N] that count as contact, > 0 or infinite @more Where the sensor's noise comes near it, which
  /// is found out in the reach, it is the mean over 5 ms that counts, against six of its own
  /// deviations.
  double contact_threshold = 2.0;

  // @section -
  /// What the controller does not know. Or one word: none, sensors, mismatch, joint_friction;
  /// or\n`preset: word` and keys that differ from it. @code what the controller does not know
  Disturbances disturbances = {};
};

/// A file with `task: press_hold`. Keys that it does not state keep their defaults;
/// tasks/press_hold/arm7.yaml states all. `overrides` are applied after it, in order, each
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

/// A task with everything resolved: robot, start, surface, phases.
/// @described press_hold
struct Setting {
  Robot robot;                   ///< @required
  Eigen::VectorXd q_start;       ///< nq, where the posture's reference begins @required
  Eigen::VectorXd q_aside;       ///< nq, where it ends @required
  SceneSpec scene;               ///< as the controller knows it @required
  Eigen::Matrix3d surface_axes;  ///< columns: two tangents and the normal, world @required
  Eigen::Vector3d p_hold;        ///< of the tool in contact, m, world @required
  double touch = 0.0;            ///< [s] of the schedule
  double ramp_end = 0.0;         ///< [s] of the schedule
  double hold_end = 0.0;         ///< [s] of the schedule
};
/// The task's robot. Of a URDF file, which has no settings, only the joints that carry the tool
/// move: the others are held at zero. Throws Error as load_robot() does.
Robot load_task_robot(const Task& task);
/// Adapts a task that was written for another robot: a posture that `robot` does not have is
/// searched for, and where it has no joint of `aside`, its third joint from the base goes by the
/// first value there, or the other way where a limit is nearer. Returns a sentence for each change.
/// Throws Error as make_setting() does.
std::vector<std::string> fit_to_robot(Task& task, const Robot& robot);
/// Throws Error for a robot, posture, tool or joint that there is not, a base that floats free, a
/// posture that is to be searched where there is none, and one that would go beyond its limits.
Setting make_setting(const Task& task);
/// The same for a robot at hand, whatever the task says of it.
Setting make_setting(const Task& task, const Robot& robot);
/// Whether the arm can come down from the start and press at the point, by statics; see
/// polishing::check_reach(). It knows nothing of the way aside.
ReachReport check_reach(const Task& task, const Setting& setting, const ReachOptions& options = {});
/// Throws Error where that finds something in the way.
void refuse_out_of_reach(const Task& task, const Setting& setting);
MpcSpec make_mpc(const Task& task, const Setting& setting);

/// A run of a task.
/// @described press_hold
struct RunSpec {
  Task task;
  std::optional<Setting> setting = {};  ///< of the task, where there is one already
  /// MuJoCo where this build has it
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  bool check_reach = true;  ///< before anything moves; a problem is then an Error
  double plan_rate = 20.0;  ///< [Hz], at which plans are recorded; 0: none
  /// Called now and then with the simulated time and about when it will be over, s. Returning false
  /// stops the run.
  RunProgress progress = {};
};

/// Of the time from the end of the ramp to the end of the hold.
struct HoldFigures {
  /// rad, largest way of a joint from the ramp's end to the hold's (m where it slides)
  double moved_aside = 0.0;
  double slip = 0.0;  ///< m, farthest that the tool was off its point along the surface
};

struct RunResult : TaskRun {
  Setting setting;
  bool done = false;               ///< to the end without fault
  std::optional<Metrics> metrics;  ///< from 0.2 s after the ramp to the end of the hold
  std::optional<HoldFigures> hold;
};
/// Runs the task in simulated time. What goes wrong on the way is in the result, with all that was
/// recorded until then. Throws Error for a task that does not fit together, one that the arm cannot
/// reach, and a plant that is not there.
RunResult run_task(const RunSpec& spec);

/// Of the schedule, as the numbers of a trace: approach, ramp, aside, hold, retreat.
const std::vector<std::string>& phase_names();

}  // namespace burnish::press_hold
