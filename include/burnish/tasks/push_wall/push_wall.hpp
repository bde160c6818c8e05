// Task: a robot on its feet presses both hands against a wall, holds the force, and then searches
// for the largest force that it can hold.
#pragma once

#include <atomic>
#include <filesystem>
#include <limits>
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

namespace burnish::push_wall {

/// Cost weights. Each cost is integrated over the horizon, with time in s.
/// @described push_wall
struct Weights {
  /// Weight on errors of the normal force of each hand [1/N^2], >= 0
  double force = 1.0;
  double friction = 1e-2;  ///< Weight on the tangential force of each hand [1/N^2], >= 0
  /// Weight on position errors of the hands while they are not in contact [1/m^2], >= 0
  /// @more The weight applies to errors along the wall. Before the approach, the weight also
  /// applies to errors along the wall's normal.
  double position = 1e4;
  /// Weight on errors of the normal speed of the hands in approach and retreat [s^2/m^2], >= 0
  double approach = 1e3;
  /// Weight on the change of each hand's angle to the wall since the start [1/rad^2], >= 0
  /// @more A tilted hand needs more wrist torque.
  double inclination = 100.0;
  /// Weight on joint angles relative to the starting posture [1/rad^2], >= 0
  /// @more A larger weight hinders the body from moving towards the wall.
  double posture = 0.1;
  /// Weight on joint angles closer than range_margin to a position limit [1/rad^2], >= 0
  double range = 1e3;
  /// Distance from position limits below which the weight `range` acts [rad (m)], >= 0
  double range_margin = 0.1;
  double velocity = 5.0;  ///< Weight on joint velocities [s^2/rad^2], >= 0
  /// Weight on torques relative to the torques that hold the starting posture [1/Nm^2], >= 0
  double torque = 1e-4;
  /// Duration that multiplies the weights in the terminal cost [s], >= 0
  double terminal = 0.1;
};

/// Plane wall in front of the hands, with its contact parameters in the plant and in plans. At the
/// start the distance between the wall and the nearer hand is `clearance`.
/// @described push_wall
struct Wall {
  /// Normal of the wall [x, y, z] in world axes, towards the robot, not zero
  /// @more The normal points out of the wall. It need not have unit length.
  /// @key normal
  Eigen::Vector3d normal_world = -Eigen::Vector3d::UnitX();
  double friction = 0.5;       ///< Coulomb friction coefficient of the plant's wall, >= 0
  double stiffness = 1e5;      ///< Stiffness of the plant's wall at each hand [N/m], > 0
  double damping = 2e3;        ///< Damping of the plant's wall at each hand [Ns/m], > 0
  double plan_friction = 0.2;  ///< Friction coefficient that plans assume for the wall, > 0
  /// Baumgarte damping of the contact constraint of the hands in plans [1/s], >= 0
  double contact_kd = 40.0;
};

/// Search for the largest force. The force of both hands rises until a condition of the enumeration
/// Limit ends the search.
/// @described push_wall
struct ForceSearch {
  double rate = 10.0;  ///< Rate of increase of the force of each hand [N/s], > 0
  /// Force of each hand at which the search stops at the latest [N], > 0 or infinite
  /// @more With the value `never` (infinite), the search stops at nine tenths of limits.force.
  double force_max = std::numeric_limits<double>::infinity();
  /// Additional force that the posture must be able to support, as a fraction of the force, >= 0
  /// @more The check is static and uses the constraints of plans.
  double reserve = 0.05;
  /// Largest amount by which the force of the hands may fall below its target [N], > 0
  /// @more The force is the mean of both hands over 0.1 s.
  double force_tolerance = 5.0;
  /// Largest distance that a hand or foot may slide within about a second [m], > 0
  /// @more Slow creep, for example of feet on compliant ground, does not count.
  double slip = 5e-3;
  /// Force held after the search, as a fraction of the force where the search ended, 0 to 1
  double hold_fraction = 0.95;
  /// Time for which the reduced force is held after the search [s], > 0
  double hold_duration = 2.0;
};

/// Condition that ended the search for the largest force.
/// @described push_wall
enum class Limit {
  None,      ///< none: the search did not end
  ForceMax,  ///< the force reached ForceSearch.force_max
  Statics,   ///< the posture could not support the additional force of ForceSearch.reserve
  Tracking,  ///< the force of the hands fell behind its target
  Plan,      ///< plans could not satisfy all their constraints
  Hand,      ///< a hand slipped
  Foot,      ///< a foot slipped
};
std::string name_of(Limit limit);

/// Task of pushing with both hands against a wall. The members are the keys of a task file, with
/// their defaults.
/// @described push_wall
struct Task {
  /// Name, folder or settings file of the robot, optionally followed by `:variant`
  std::string robot = "talos";
  /// Starting posture, a name from the robot's settings
  /// @more If empty, the robot's default posture is used.
  std::string posture = {};
  double force = 50.0;  ///< Normal force that each hand presses with [N], > 0
  /// Frames of the two hands; their origins are the centres of the round tips
  std::vector<std::string> hands = {"left_tool", "tool"};
  double tip_radius = 0.02;  ///< Radius of the round tips of both hands [m], > 0

  /// Plane wall at the distance `clearance` from the nearer hand at the start. The controller knows
  /// the wall's normal.
  Wall wall = {};
  /// Feet and ground of a robot with a floating base.
  Standing standing = {.feet = {"left_sole_link", "right_sole_link"}, .balance = 1e4};

  // @section phases Stand, approach until both hands have contact, ramp the force, hold it, search
  // for the largest force,\nhold a fraction of the largest force, release, retreat.
  double clearance = 0.02;  ///< Distance between the nearer hand and the wall at the start [m], > 0
  double settle_duration = 0.5;  ///< Time to stand before the approach [s], > 0
  double approach_speed = 0.04;  ///< Speed towards the wall [m/s], > 0
  /// Pressing force of each hand right after both hands have contact [N], > 0
  double touch_force = 5.0;
  double ramp_duration = 1.5;  ///< Duration of the ramp from touch_force to force [s], > 0
  double hold_duration = 3.0;  ///< Time for which `force` is held before the search [s], > 0
  /// Search for the largest force, and the conditions that end the search.
  /// @after retreat_duration
  ForceSearch force_search = {};
  /// Duration of the release, a ramp of the force down to touch_force [s], > 0
  double release_duration = 5.0;
  // @section -

  /// Duration of the retreat from the wall to the distance `clearance` [s], > 0
  double retreat_duration = 1.0;

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
  double horizon = 1.0;  ///< Duration that a plan covers [s], > 0
  double step = 0.01;    ///< Time between the first two knots of the plan [s], > 0
  /// Number of knots in the plan, >= 2
  /// @more The steps between knots grow to cover the horizon.
  int knots = 30;
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

  /// Largest mean force of a hand over 5 ms [N], > 0 or infinite
  /// @key force
  double force_limit = 400.0;
  double slip = 0.03;  ///< Largest distance that a hand or foot may slide [m], > 0 or infinite
  /// Largest drop of the centre of mass below its height at the start [m], > 0 or infinite
  double sink = 0.25;
  /// Longest wait for contact after the planned time of contact [s], > 0 or infinite
  double late_contact = 3.0;
  /// Longest time without force at a hand that should press [s], > 0 or infinite
  double contact_lost = 0.3;
  /// Force of a hand, averaged over 10 ms, above which the hand counts as in contact [N], > 0
  /// @more Contact counts as lost if the force falls below half of this threshold.
  double contact_threshold = 2.0;
  SafetyLimits limits = {.torque_gap = 0.25};

  // @section -

  /// Disturbances that the controller does not know.\nIn a task file, one of the words none,
  /// sensors, mismatch and joint_friction can replace all keys.\nWith the key `preset` and one of
  /// these words, only keys that differ from the preset are needed.
  Disturbances disturbances = {};
};

/// Reads a task file, which has the key `task: push_wall`. Missing keys get their defaults;
/// tasks/push_wall/talos.yaml states all keys. Then applies `overrides` in order. Each override is
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
/// Returns the force of each hand at which the search for the largest force stops at the latest
/// [N].
double force_max(const Task& task);
/// Returns the text of a complete task file, with the unit and meaning of every key. Reading this
/// text returns the same task.
std::string task_text(const Task& task);
/// Returns warnings for the user about settings that are probably unintended, one sentence each:
/// delays that differ from the assumed delays, a wall friction without effect because disturbances
/// set another one, and a plant that equals the controller's model. If `ideal_is_meant` is true,
/// the sentence about the plant is left out.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

/// Task with all settings filled in: robot, start, wall, feet, hands, phases.
/// @described push_wall
struct Setting {
  Robot robot;              ///< Robot of the task, with a floating base @required
  Eigen::VectorXd q_start;  ///< Configuration at the start, nq @required
  /// Scene as the controller assumes it: the feet are supports on the ground, the hands on the wall
  /// @more The feet come before the hands. The robot has no tool
  /// @required
  SceneSpec scene;
  /// Axes of the wall in the world; the columns are two tangents and the normal
  /// @required
  Eigen::Matrix3d wall_axes;
  /// World positions of the two hands when they touch the wall [m]; one column per hand
  /// @required
  Eigen::Matrix<double, 3, 2> p_hands;
  Eigen::Vector3d com;  ///< Centre of mass at the start, in the world [m] @required
  /// Horizontal displacement of the centre of mass per force of each hand, in the world [m/N]
  /// @more With this displacement, the centre of pressure under the feet does not move when the
  /// force changes.
  /// @required
  Eigen::Vector3d com_per_force;
  /// Distance at the start from the middle of the feet to the centre of pressure, towards the wall
  /// [m]; 0 if the centre of pressure is farther from the wall than the middle
  double room = 0.0;
  double touch = 0.0;        ///< Schedule time of the planned contact [s]
  double ramp_end = 0.0;     ///< Schedule time at the end of the force ramp [s]
  double hold_end = 0.0;     ///< Schedule time when the hold ends and the search begins [s]
  double search_end = 0.0;   ///< Schedule time at the end of the search for the largest force [s]
  double top_end = 0.0;      ///< Schedule time at the end of the hold after the search [s]
  double release_end = 0.0;  ///< Schedule time at the end of the release [s]
};
/// Loads the robot of the task with a floating base. Throws Error in the same cases as
/// load_robot().
Robot load_task_robot(const Task& task);
/// Fills in all settings of a task: loads the robot, places the wall, the hands and the feet at the
/// starting posture, and computes the times of the phases. Throws Error for an unknown robot,
/// posture, hand or foot. Also throws Error if one hand is more than 5 cm farther from the wall
/// than the other.
Setting make_setting(const Task& task);
/// Fills in all settings of a task for `robot`, which replaces the robot that the task names.
Setting make_setting(const Task& task, const Robot& robot);
/// Checks by statics whether both hands can press with `task.force` in the starting posture. Throws
/// Error if a joint needs more torque than the constraints of plans allow.
void refuse_out_of_reach(const Task& task, const Setting& setting);

/// State of the search for the largest force. During control, the task writes the state, and the
/// targets of plans read it. Two controllers must not use the same state at the same time.
struct SearchState {
  /// Force of each hand where the search ended [N]; negative while the search has not ended.
  std::atomic<double> reached{-1.0};
  std::atomic<int> limit{0};  ///< Value of Limit that ended the search, as an int.
  /// For Limit::Hand and Limit::Foot: index of the hand or foot that slipped. For Limit::Statics:
  /// index of the constraint that the posture reached. Otherwise -1.
  std::atomic<int> where{-1};
};
/// Returns the target force of each hand [N] at the schedule time `time` [s]. `force_search`
/// contains the force at which the search ended.
double force_at(const Task& task, const Setting& setting, const SearchState& force_search,
                double time);
/// Returns the specification of the task's model predictive controller. `force_search` is the state
/// of the search for the largest force: the task writes this state, and the targets of plans read
/// it. If `force_search` is null, a new state is created. Throws Error if the start violates
/// constraints.joint_margin.
MpcSpec make_mpc(const Task& task, const Setting& setting,
                 std::shared_ptr<SearchState> force_search = {});

/// Options of run_task().
/// @described push_wall
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

/// Statistics of the push, from the true state of the plant. Forces are averaged over 10 ms.
/// Statistics of the hold begin 0.3 s after the force ramp.
struct PushFigures {
  /// RMS error of the normal force during the hold, for the hand with the larger error [N].
  double force_rmse = 0.0;
  /// Largest error of the normal force of either hand during the hold [N].
  double force_peak = 0.0;
  double force_mean = 0.0;  ///< Mean normal force of both hands during the hold [N].
  /// Mean force of the weaker hand during the hold after the search [N].
  double largest_force = 0.0;
  /// RMS force error during the hold after the search, for the hand with the larger error [N].
  double largest_rmse = 0.0;
  double search_force = 0.0;  ///< Target force of each hand where the search ended [N].
  /// Largest displacement of the centre of mass towards the wall [m].
  double com_displacement = 0.0;
  /// Largest distance that a hand slid along the wall since the beginning of the force ramp [m].
  /// Rolling of the round tip does not count.
  double hand_slip = 0.0;
  /// Largest distance that a foot moved along the ground from its position at the start [m].
  double foot_slip = 0.0;
  /// Largest offset of the centre of pressure from the middle of a sole, as a fraction of the
  /// sole's half side.
  double sole_share = 0.0;
};

/// Result of run_task().
struct RunResult : TaskRun {
  Setting setting;
  /// Statistics of the push. None if the run ended less than about 0.3 s after the force ramp.
  std::optional<PushFigures> push;
  Limit limit = Limit::None;  ///< Condition that ended the search for the largest force.
  /// For Limit::Hand and Limit::Foot: name of the hand or foot that slipped. For Limit::Statics:
  /// name of the constraint that the posture reached. For Limit::Plan and Limit::Tracking: names of
  /// up to three constraints that were active in the plan.
  std::string limited_by = {};
};
/// Runs the task in simulated time. Faults and other problems are in the result, with the data
/// recorded until then. Throws Error for contradictory settings, and for a plant that has no feet
/// or that this build does not have.
RunResult run_task(const RunSpec& spec);

/// Returns the names of the phases: settle, approach, ramp, hold, force_search, top, release,
/// retreat. The index of a name is the phase number in traces.
const std::vector<std::string>& phase_names();

}  // namespace burnish::push_wall
