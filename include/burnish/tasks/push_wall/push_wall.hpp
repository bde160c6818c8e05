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
struct Weights {
  double force = 1.0;      ///< 1/N^2: of each hand along the normal to its target
  double friction = 1e-2;  ///< 1/N^2: of each hand along the wall to none
  double position = 1e4;   ///< 1/m^2: hands to their places along the wall, while they do not hold
  double approach = 1e3;   ///< s^2/m^2: speed along the normal to that of approach and retreat
  /// 1/rad^2: hands to their axis along the normal at the start; what tilts costs torque of the
  /// wrists
  double inclination = 100.0;
  double posture = 0.1;       ///< 1/rad^2: joints to the start; more keeps the body from leaning
  double range = 1e3;         ///< 1/rad^2: joints off their limits, within range_margin of these
  double range_margin = 0.1;  ///< rad (m)
  double velocity = 5.0;      ///< s^2/rad^2: joint speeds
  double torque = 1e-4;       ///< 1/Nm^2: torques to those that hold the start
  double terminal = 0.1;  ///< s: what the end of the horizon costs, as a time at its running cost
};

/// The wall, a plane before the hands, and what plans keep of it.
struct Wall {
  Eigen::Vector3d normal_world = -Eigen::Vector3d::UnitX();  ///< out of the wall, any length
  double friction = 0.5;                                     ///< Coulomb coefficient of the plant
  double stiffness = 1e5;                                    ///< N/m, of the plant, under each hand
  double damping = 2e3;        ///< Ns/m, of the plant, under each hand
  double plan_friction = 0.2;  ///< coefficient that plans keep within
  double contact_kd = 40.0;    ///< 1/s, damping of the hands' constraint (Baumgarte)
};

/// How the largest force is looked for, and when the search is over; see Limit.
struct Lean {
  double rate = 10.0;  ///< N/s, of each hand
  /// N of each hand, where it ends at the latest; never: nine tenths of limits.force.
  double force_max = std::numeric_limits<double>::infinity();
  /// of the force, that the posture must be able to bear beyond it, at rest and within the limits
  /// that plans keep
  double reserve = 0.05;
  double give = 5.0;           ///< N that the mean of both hands over 0.1 s may be below the target
  double slip = 5e-3;          ///< m that a hand or foot may slide within a second; grounds creep
  double share = 0.95;         ///< of the force then, that is held afterwards
  double hold_duration = 2.0;  ///< s that this is held
};

/// What ended the search for the largest force.
enum class Limit {
  None,  ///< nothing: the search did not end
  Most,  ///< Lean::force_max was reached
  Bear,  ///< more than Lean::reserve beyond it the posture cannot bear
  Give,  ///< plans gave way: the hands fell behind the target
  Plan,  ///< plans could not keep all their limits
  Hand,  ///< a hand slipped
  Foot,  ///< a foot slipped
};
std::string name_of(Limit limit);

struct Task {
  std::string robot = "talos";  ///< a robot's name, folder or settings file, with :variant
  /// where it starts, of the robot's settings. Empty: the robot's default.
  std::string posture = {};
  double force = 50.0;  ///< N, that each hand presses with
  /// two frames, whose origins are the centres of balls
  std::vector<std::string> hands = {"left_tool", "tool"};
  double tip_radius = 0.02;  ///< m, of those balls

  Wall wall = {};
  Standing standing = {.feet = {"left_sole_link", "right_sole_link"}, .balance = 1e4};

  double clearance = 0.02;       ///< m between hands and wall at the start
  double settle_duration = 0.5;  ///< s of standing before
  double approach_speed = 0.04;  ///< m/s towards the wall
  double touch_force = 5.0;      ///< N of each hand, at once where both have contact
  double ramp_duration = 1.5;    ///< s from touch_force to force
  double hold_duration = 3.0;    ///< s that the force is held
  Lean lean = {};
  double release_duration = 5.0;  ///< s back to touch_force
  double retreat_duration = 1.0;  ///< s off the wall, by the clearance

  double tick_rate = 1000.0;    ///< Hz, of torque commands
  double update_rate = 200.0;   ///< Hz, of new plans; divides the tick rate
  double solver_delay = 0.005;  ///< s from a measurement to the use of the plan made from it
  /// s from a command to the torque that it makes, as far as it is known. Rounded to ticks. Plans
  /// and feedback begin in the state that the torques already sent lead to.
  double command_delay = 0.0;
  /// s from what is measured to the tick that has it, as far as it is known
  double measurement_delay = 0.0;
  double horizon = 1.0;  ///< s that are planned ahead
  double step = 0.01;    ///< s between the first two knots of the plan
  int knots = 30;        ///< of the plan; the steps grow so that they fill the horizon
  Weights weights = {};
  ModelErrorOptions model_error = {.bandwidth = 60.0, .boost = 2.0, .fading = 0.2};

  PlanLimits constraints = {};

  double force_limit = 400.0;      ///< N of a hand, mean over 5 ms
  double slip = 0.03;              ///< m that a hand or foot may have slid
  double sink = 0.25;              ///< m that the centre of mass may be below where it starts
  double late_contact = 3.0;       ///< s that contact may come late
  double contact_lost = 0.3;       ///< s that a hand may be without force while it is to press
  double contact_threshold = 2.0;  ///< N, mean over 10 ms, that count as contact of a hand
  SafetyLimits limits = {.torque_gap = 0.25};

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

/// The task with everything resolved.
struct Setting {
  Robot robot;
  Eigen::VectorXd q_start;  ///< nq
  /// As the controller knows it: feet and hands are its supports, in this order; its surface is the
  /// wall, and its tip a smaller ball in the second hand that never touches it.
  SceneSpec scene;
  Eigen::Matrix3d wall_axes;            ///< columns: two tangents and the normal, world
  Eigen::Matrix<double, 3, 2> p_hands;  ///< of the hands in contact, m, world; columns
  Eigen::Vector3d com;                  ///< centre of mass at the start, m, world
  /// m/N, world, level: how far the centre of mass goes per N of each hand so that the pressure
  /// under the feet stays where it is
  Eigen::Vector3d com_per_force;
  /// m that the pressure lies before the middle of the feet at the start, on the side of the wall
  double room = 0.0;
  double touch = 0.0, ramp_end = 0.0, hold_end = 0.0, lean_end = 0.0, top_end = 0.0,
         release_end = 0.0;  ///< s of the schedule
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

struct RunSpec {
  Task task;
  std::optional<Setting> setting = {};  ///< of the task, where there is one already
  PlantKind plant = PlantKind::Mujoco;  ///< the ideal plant has no feet to stand on
  bool check_reach = true;              ///< before anything moves; a problem is then an Error
  double plan_rate = 20.0;              ///< Hz, at which plans are recorded; 0: none
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
