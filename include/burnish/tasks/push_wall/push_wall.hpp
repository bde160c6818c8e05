// The task of pushing with both hands against a wall: a robot on its feet presses two balls in its
// hands along the wall's normal, holds that, and leans to the largest force that it can hold.
#pragma once

#include <atomic>
#include <filesystem>
#include <limits>
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

namespace burnish::push_wall {

/// Cost weights, per second of horizon.
/// @described push_wall
struct Weights {
  double force = 1.0;      ///< [1/N^2]: of each hand along the normal to its target, >= 0
  double friction = 1e-2;  ///< [1/N^2]: of each hand along the wall to none, >= 0
  /// [1/m^2]: hands to their places along the wall, while they do not hold, >= 0
  double position = 1e4;
  /// [s^2/m^2]: speed along the normal to that of approach and retreat, >= 0
  double approach = 1e3;
  /// [1/rad^2]: hands to their axis along the normal at the start; what tilts costs torque of the
  /// wrists, >= 0
  double inclination = 100.0;
  double posture = 0.1;  ///< [1/rad^2]: joints to the start; more keeps the body from leaning, >= 0
  double range = 1e3;    ///< [1/rad^2]: joints off their limits, within range_margin of these, >= 0
  double range_margin = 0.1;  ///< [rad (m)], >= 0
  double velocity = 5.0;      ///< [s^2/rad^2]: joint speeds, >= 0
  double torque = 1e-4;       ///< [1/Nm^2]: torques to those that hold the start, >= 0
  /// [s]: what the end of the horizon costs, as a time at its running cost, >= 0
  double terminal = 0.1;
};

/// A plane before the hands, and what plans keep of it. It lies `clearance` from the nearer hand at
/// the start.
/// @described push_wall
struct Wall {
  /// [x, y, z] out of the wall towards the robot, any length, world, not zero @code out of the
  /// wall, any length @key normal
  Eigen::Vector3d normal_world = -Eigen::Vector3d::UnitX();
  double friction = 0.5;       ///< Coulomb coefficient of the plant, >= 0
  double stiffness = 1e5;      ///< [N/m], of the plant, under each hand, > 0
  double damping = 2e3;        ///< {Ns/m}, of the plant, under each hand, > 0
  double plan_friction = 0.2;  ///< coefficient that plans keep within, > 0
  double contact_kd = 40.0;    ///< [1/s], damping of the hands' constraint (Baumgarte), >= 0
};

/// How the largest force is looked for, and when the search is over: where the posture could not
/// bear `reserve` more, where plans cannot keep their limits or give way, where a hand or a foot
/// slips, and at `force_max`.
/// @described push_wall
/// Limit says which of these ended it.
struct Lean {
  double rate = 10.0;  ///< [N/s], of each hand, > 0
  /// [N] of each hand, where it ends at the latest, > 0 or infinite @more never: nine tenths of
  /// limits.force.
  double force_max = std::numeric_limits<double>::infinity();
  /// of the force, that the posture must be able to bear beyond it, at rest and within the limits
  /// that plans keep, >= 0
  double reserve = 0.05;
  double give = 5.0;    ///< [N] that the mean of both hands over 0.1 s may be below the target, > 0
  double slip = 5e-3;   ///< [m] that a hand or foot may slide within a second; grounds creep, > 0
  double share = 0.95;  ///< of the force then, that is held afterwards, 0 to 1
  double hold_duration = 2.0;  ///< [s] that this is held, > 0
};

/// What ended the search for the largest force.
/// @described push_wall
enum class Limit {
  None,  ///< nothing: the search did not end
  Most,  ///< Lean.force_max was reached
  Bear,  ///< the posture could not bear Lean.reserve more
  Give,  ///< plans gave way: the hands fell behind the target
  Plan,  ///< plans could not keep all their limits
  Hand,  ///< a hand slipped
  Foot,  ///< a foot slipped
};
std::string name_of(Limit limit);

/// The task of pushing with both hands against a wall: all that a task file may say, with its
/// defaults.
/// @described push_wall
struct Task {
  std::string robot = "talos";  ///< a robot's name, folder or settings file, with :variant
  /// where it starts, of the robot's settings @more Empty: the robot's default.
  std::string posture = {};
  double force = 50.0;  ///< [N], that each hand presses with, > 0
  /// two frames, whose origins are the centres of balls
  std::vector<std::string> hands = {"left_tool", "tool"};
  double tip_radius = 0.02;  ///< [m], of those balls, > 0

  /// A plane, `clearance` before the nearer hand at the start. The controller knows its normal.
  Wall wall = {};
  /// What the robot stands on.
  Standing standing = {.feet = {"left_sole_link", "right_sole_link"}, .balance = 1e4};

  // @section phases Stand, approach until both hands have contact, ramp the force, hold it, lean to
  // the largest,\nhold that, release, retreat.
  double clearance = 0.02;       ///< [m] between hands and wall at the start, > 0
  double settle_duration = 0.5;  ///< [s] of standing before, > 0
  double approach_speed = 0.04;  ///< [m/s] towards the wall, > 0
  double touch_force = 5.0;      ///< [N] of each hand, at once where both have contact, > 0
  double ramp_duration = 1.5;    ///< [s] from touch_force to force, > 0
  double hold_duration = 3.0;    ///< [s] that the force is held, > 0
  /// How the largest force is looked for, and when the search is over. @after retreat_duration
  Lean lean = {};
  double release_duration = 5.0;  ///< [s] back to touch_force, > 0
  // @section -
  double retreat_duration = 1.0;  ///< [s] off the wall, by the clearance, > 0

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
  double horizon = 1.0;  ///< [s] that are planned ahead, > 0
  double step = 0.01;    ///< [s] between the first two knots of the plan, > 0
  int knots = 30;        ///< of the plan; the steps grow so that they fill the horizon, >= 2
  // @section -
  Weights weights = {};  ///< Cost weights, per second of horizon.
  /// What is estimated of what the model gets wrong.
  ModelErrorOptions model_error = {.bandwidth = 60.0, .boost = 2.0, .fading = 0.2};

  PlanLimits constraints = {};  ///< What plans keep, whatever it costs. Each may be never.

  // @section limits Beyond these a run is given up: the robot is braked and held (fallback), and
  // there is a report.\nEach may be never.
  double force_limit = 400.0;  ///< [N] of a hand, mean over 5 ms, > 0 or infinite @key force
  double slip = 0.03;          ///< [m] that a hand or foot may have slid, > 0 or infinite
  /// [m] that the centre of mass may be below where it starts, > 0 or infinite
  double sink = 0.25;
  double late_contact = 3.0;  ///< [s] that contact may come late, > 0 or infinite
  /// [s] that a hand may be without force while it is to press, > 0 or infinite
  double contact_lost = 0.3;
  double contact_threshold = 2.0;  ///< [N], mean over 10 ms, that count as contact of a hand, > 0
  SafetyLimits limits = {.torque_gap = 0.25};

  // @section -
  /// What the controller does not know. Or one word: none, sensors, mismatch, joint_friction;
  /// or\n`preset: word` and keys that differ from it. @code what the controller does not know
  Disturbances disturbances = {};
};

/// A file with `task: push_wall`. Keys that it does not state keep their defaults;
/// tasks/push_wall/talos.yaml states all. `overrides` are applied after it, in order, each
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
/// N of each hand, where the search for the largest force ends at the latest.
double force_max(const Task& task);
/// The whole task as such a file, every key with its unit and meaning; reads back as it was.
std::string task_text(const Task& task);
/// Returns a sentence for each stated key that has no effect in this task, and one for a plant that
/// is exactly what the controller believes, unless that is meant.
std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant = false);

/// A task with everything resolved: robot, start, wall, feet, hands, phases.
/// @described push_wall
struct Setting {
  Robot robot;              ///< @required
  Eigen::VectorXd q_start;  ///< nq @required
  /// as the controller knows it: feet and hands are its supports, in this order; its surface is the
  /// wall, and its tip a smaller ball that never touches it @required
  SceneSpec scene;
  Eigen::Matrix3d wall_axes;            ///< columns: two tangents and the normal, world @required
  Eigen::Matrix<double, 3, 2> p_hands;  ///< of the hands in contact, m, world; columns @required
  Eigen::Vector3d com;                  ///< centre of mass at the start, m, world @required
  /// m/N, world, level: how far the centre of mass goes per N of each hand so that the pressure
  /// under the feet stays where it is @required
  Eigen::Vector3d com_per_force;
  /// [m] that the pressure lies before the middle of the feet at the start, on the side of the wall
  double room = 0.0;
  double touch = 0.0;        ///< [s] of the schedule
  double ramp_end = 0.0;     ///< [s] of the schedule
  double hold_end = 0.0;     ///< [s] of the schedule
  double lean_end = 0.0;     ///< [s] of the schedule
  double top_end = 0.0;      ///< [s] of the schedule
  double release_end = 0.0;  ///< [s] of the schedule
};
/// The task's robot, its base floating. Throws Error as load_robot() does.
Robot load_task_robot(const Task& task);
/// Throws Error for a robot, posture, hand or foot that there is not, and for hands of which one is
/// not in the plane of the wall that the other comes to.
Setting make_setting(const Task& task);
/// The same for a robot at hand, whatever the task says of it.
Setting make_setting(const Task& task, const Robot& robot);
/// Throws Error where the start, statically, cannot bear the force: a motor beyond its limit with
/// the pressure of both hands' force at the start's posture.
void refuse_out_of_reach(const Task& task, const Setting& setting);

/// How far the search for the largest force has come: what plans are told by the task as it
/// watches. Of one controller at a time.
struct LeanState {
  std::atomic<double> reached{-1.0};  ///< N of each hand; negative: not ended
  std::atomic<int> limit{0};          ///< a Limit
  std::atomic<int> where{-1};         ///< which hand or foot slipped, or which limit of Bear
};
/// N that each hand is to press with at a time of the schedule, s.
double force_at(const Task& task, const Setting& setting, const LeanState& lean, double time);
MpcSpec make_mpc(const Task& task, const Setting& setting, std::shared_ptr<LeanState> lean = {});

/// A run of a task.
/// @described push_wall
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

/// Of the plant's true forces and places. Forces are means over 10 ms.
struct PushFigures {
  /// N, root mean square error of the worse hand's force (mean over 10 ms) while held
  double force_rmse = 0.0;
  double force_peak = 0.0;     ///< N, largest error of either hand's force then
  double force_mean = 0.0;     ///< N, mean force of both hands then
  double largest_force = 0.0;  ///< N, mean of the weaker hand while the largest force is held
  double largest_rmse = 0.0;   ///< N, root mean square error of the worse hand's force then
  double lean_force = 0.0;     ///< N, of each hand, asked for where the search ended
  double lean = 0.0;           ///< m, farthest that the centre of mass went to the wall
  /// m, farthest that a hand slid along the wall since the ramp began; rolling is none
  double hand_slip = 0.0;
  double foot_slip = 0.0;   ///< m, farthest that a foot was off its start, along the ground
  double sole_share = 0.0;  ///< largest way of the pressure off a sole's middle, of half its side
};

struct RunResult : TaskRun {
  Setting setting;
  bool done = false;                ///< to the end without fault
  std::optional<PushFigures> push;  ///< none where the hold did not come to its end
  Limit limit = Limit::None;        ///< that ended the search for the largest force
  std::string limited_by = {};      ///< the limits that plans kept nearest then, or who slipped
};
/// Runs the task in simulated time. What goes wrong on the way is in the result, with all that was
/// recorded until then. Throws Error for a task that does not fit together, and a plant that is not
/// there or has no feet.
RunResult run_task(const RunSpec& spec);

/// Of the schedule, as the numbers of a trace: settle, approach, ramp, hold, lean, top, release,
/// retreat.
const std::vector<std::string>& phase_names();

}  // namespace burnish::push_wall
