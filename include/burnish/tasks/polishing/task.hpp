// The polishing task as a plain value: all that a task file may say, with its defaults.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/disturbances.hpp"
#include "burnish/sim/scene.hpp"
#include "burnish/tasks/polishing/force_profile.hpp"
#include "burnish/tasks/polishing/path.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "burnish/tasks/pressing/standing.hpp"

namespace burnish::polishing {

using burnish::HomeSpec;
using burnish::PostureLimits;

/// Axes that the contact and its force are written in.
/// @described polishing
enum class ForceAxes {
  /// the surface's own: x, y along it, z out of it (the paper's centred frame where the surface is
  /// aligned with the world)
  Surface,
  Local,  ///< the tool's: its axis that is closest to the normal at the start
  World,  ///< the world's: those of the surface at the start, which stay where they are
};

/// How the robot itself moves the frame that carries the surface: from where it starts by shift * s
/// and turn * s (a rotation vector), s = sin(2 pi frequency t) from contact on.
/// @described polishing
struct Waving {
  Eigen::Vector3d shift_world = Eigen::Vector3d::Zero();  ///< [x, y, z] {m}, world @key shift
  Eigen::Vector3d turn_world = Eigen::Vector3d::Zero();   ///< [x, y, z] {rad}, world @key turn
  double frequency = 0.3;                                 ///< [Hz], > 0
  double start_up = 1.0;                                  ///< [s] until the full way, > 0
  double position = 1e4;  ///< [1/m^2]: the frame's origin to where it shall be, >= 0
  double rotation = 1e3;  ///< [1/rad^2]: the frame's axes to what they shall be, >= 0
};

/// Cost weights, per second of horizon. Each is (what it buys): doubling it halves the error that
/// the others force on its term.
/// @described polishing
struct Weights {
  /// [1/rad^2]: joints to the start; more holds the elbow, costs path accuracy, >= 0
  double posture = 0.1;
  double velocity = 1.0;  ///< [s^2/rad^2]: joint speeds; more damps, and lags on fast paths, >= 0
  double torque = 1e-4;   ///< [1/Nm^2]: torques to those that hold the start, >= 0
  /// [1/m^2]: tool to the path, in the reach to the point above the surface; auto: fitted to the
  /// arm, >= 0 @code 1/m^2: tool to the path, in the reach to the point above the surface; none:
  /// fitted to the arm, see fit_gains() @word auto @after force
  std::optional<double> position = {};
  /// [s^2/m^2]: speed along the normal to that of approach and retreat, >= 0 @after position
  double approach = 1e2;
  /// [1/rad^2]: tool to its orientation at the start; less lets the wrist follow, >= 0 @after
  /// approach
  double rotation = 1.0;
  double force = 1.0;  ///< [1/N^2]: force along the normal to its target, >= 0 @after -
  /// [s]: what the end of the horizon costs, as a time at its running cost, >= 0
  double terminal = 0.1;
};

/// What "polished" asks for, of the plant's true force and place, from the end of the ramp to the
/// end of the path.
/// @described polishing
struct Verdict {
  double contact_share = 0.99;  ///< of the time in contact, at least; 0 to 1, 0 to 1
  /// of the force: rms error of its mean over 10 ms, at most; or never, > 0 or infinite @code of
  /// the force: rms error of its mean over 10 ms, at most; infinite: any
  double force_rmse = 0.1;
  /// of the path's length with the tip over its target, at least; 0 to 1, 0 to 1 @more Nearer to it
  /// than the tip's radius. A path without end is as long as Task::polish_duration makes it.
  double path_share = 0.99;
};

/// The polishing task: all that a task file may say, with its defaults.
/// @described polishing
struct Task {
  /// a robot's name, folder or settings file, with :variant
  std::string robot = "talos:right_arm";
  /// start of the arm, what its null space is drawn to; search: found for the surface @more Of the
  /// robot's settings, or find_posture()'s. Empty: the robot's default, or searched where it has
  /// none. So is a named surface's, where the robot has none of that name.
  std::string posture = {};
  /// joints whose rotor is missing get an armature of 2 ms * effort / velocity @more In plans and
  /// plant. Missing: torque noise alone drives the joint past its speed limit; without this a note
  /// names it.
  bool assume_rotors = false;
  PostureLimits search = {};  ///< What a posture that is searched keeps to. @after waving
  // @section tool
  /// Where a run begins, if not at its start: a posture, from which the joints move straight to the
  /// start\nin a phase `home`. @code where a run begins, if not at the start of the arm @after
  /// search
  HomeSpec home = {};
  Standing standing = {};     ///< What a robot whose base floats stands on. @after home
  std::string tool = "tool";  ///< its origin is the centre of a round tip @key frame
  // @section surface Or one word for posture, normal and point: table, board, board_x, board_y,
  // board_minus_y,\ntilt_45. The controller knows where it is; it knows nothing of friction and
  // stiffness.
  /// [x, y, z] that it presses along, in its frame; or auto: z or -z of a frame of robot.yaml, of
  /// others the last joint's axis, away from the arm, not zero @code that the tool presses along,
  /// in its frame, any length; without it see pressing_direction() @more a posture that is given
  /// must agree with it, within search.tilt @key axis @word auto
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< Radius of the round tip [m], > 0

  /// of the robot, that carries the surface, such as a plate in the other hand, in whose axes
  /// normal and point are then; or world @code of the robot, that carries the surface, such as a
  /// plate in the other hand; empty: the world @key frame @word world
  std::string surface_frame = {};
  /// How the robot moves the frame that carries the surface, where one does. @code of that frame
  /// @after shape
  Waving waving = {};
  /// [x, y, z] out of the material towards the robot, any length, world, not zero @code out of the
  /// surface, any length; in the axes of the frame that carries it @key normal
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// [x, y, z] of any point on it, {m}; or under_tool: clearance below the start @code a point of
  /// the surface, m, alike; without it `clearance` under the tool at the start @key point @word
  /// under_tool
  std::optional<Eigen::Vector3d> point_world = {};
  /// What the surface is about its point. The path is drawn on it as seen along the normal there.
  /// @code plane, or what the surface is about its point @after damping
  SurfaceShape shape = {};
  /// [m] that there is surface beyond the path, on all four sides; or endless, >= 0 or infinite
  /// @code m that there is surface beyond the path, on all four sides of a square about the path's
  /// origin; infinite: it has no end @word endless
  double extent = 0.1;
  /// Coulomb coefficient of the plant, unless disturbances.surface_friction says another, >= 0
  double friction = 0.0;
  double stiffness = 1e5;  ///< [N/m], of the plant, > 0
  double damping = 500.0;  ///< {Ns/m}, of the plant, >= 0

  double force = 30.0;  ///< [N], that the tool presses with, > 0 @after assume_rotors
  /// [N], at once where contact is made, so that the tool does not rebound, >= 0 @more the ramp
  /// starts there @after approach_speed
  double touch_force = 6.0;
  /// What the force does from when the path begins; until then it rises to `force`.
  ForceProfile force_profile = {};
  // @section phases Reach above the surface, approach until contact, ramp the force, polish,
  // retreat.
  /// In the plane of the surface, from the point under the start, beginning at rest. @after
  /// standing
  PathSpec path = {};
  double clearance = 0.02;        ///< [m] between tool and surface where the reach ends, > 0
  double reach_duration = 0.5;    ///< [s], > 0
  double approach_speed = 0.03;   ///< [m/s] towards the surface, > 0
  double ramp_duration = 0.5;     ///< [s] from contact to the full force, > 0
  double polish_duration = 12.6;  ///< [s] on the path, > 0
  double retreat_duration = 0.5;  ///< [s] back to the clearance, > 0
  /// What "polished" asks for, of the plant's true force and place, from the end of the ramp on.
  Verdict verdict = {};

  // @section controller The optimal control problem that is solved again and again, and the loop
  // around it.
  double horizon = 1.0;  ///< [s] that are planned ahead, > 0
  double step = 0.01;    ///< [s] between two knots of the plan, > 0
  /// of the plan: their steps grow from the first one, so that few look as far ahead; 0: all are
  /// alike, >= 0
  int knots = 0;
  double update_rate = 1000.0;  ///< [Hz], of new plans; divides the tick rate, > 0
  double tick_rate = 2000.0;    ///< [Hz], of torque commands, > 0
  /// fixed: plans are used solver_delay after their measurement; measured: the time that each takes
  /// passes, in simulations too; thread: they are made in a thread of their own
  PlanTiming timing = PlanTiming::Fixed;
  double solver_delay = 0.0;  ///< [s] from a measurement to the use of the plan made from it, >= 0
  /// Delay from command to torque that the controller assumes [s], 0 to 0.1 @more Rounded to ticks.
  /// Plans and feedback begin in the state that the torques already sent lead to.
  double command_delay = 0.0;
  /// Delay from measurement to tick that the controller assumes [s], 0 to 0.1
  double measurement_delay = 0.0;
  double slowdown = 1.0;  ///< of measured timing: a machine by this factor slower, > 0
  int iterations = 1;     ///< of the solver, per plan, >= 1
  StepUpdate solver = StepUpdate::MultipleShooting;  ///< multiple_shooting or rollout
  double contact_kd = 40.0;  ///< [1/s], damping of the contact constraint (Baumgarte), >= 0
  /// [m/s] of sliding below which the friction of plans fades: their steps bear no less, > 0
  double friction_speed = 0.1;
  /// [rad/s], torque lag that plans know of; 0: none; the plant's is in disturbances, >= 0
  double torque_cutoff = 0.0;
  /// of contact and force: surface, local (the tool's) or world
  ForceAxes axes = ForceAxes::Surface;
  /// between plans follow their Riccati gains, not just their torques @after solver
  bool feedback = true;
  /// What measurements say that the model gets wrong, given back to it before each plan. @note
  /// Bandwidth, boost, lag and force_gain that are none are fitted to the arm, see fit_gains().
  ModelErrorOptions model_error = {.calm = 0.25, .sliding_bandwidth = 360.0};
  /// What the tip's own path says of the surface, given to each plan: not with axes: local.
  SurfaceEstimateOptions surface_estimate = {};
  /// The coefficient of friction between tool and surface, given to each plan.
  FrictionEstimateOptions friction_estimate = {.enabled = false};
  SafetyLimits limits = {.torque_gap = 0.25};
  ToolLimits tool_limits = {};  ///< @key limits
  /// [N] that count as contact, > 0 or infinite @more Where the sensor's noise comes near it, which
  /// is found out in the reach, it is the mean over 5 ms that counts, against six of its own
  /// deviations.
  double contact_threshold = 2.0;
  // @section limits Beyond these a run is given up: the arm is braked and held (fallback), and
  // there is a report.\nEach may be never.
  /// false: the force is told from torques, encoders and velocities, against what they said in the
  /// air just before @after torque_cutoff
  bool force_sensor = true;
  /// What holds the arm after a fault: gravity compensation, a damper, and a spring that slips.
  Fallback fallback = {};
  /// Cost per second of squared error. What counts is how they compare: raise one, and its
  /// error\nshrinks at the expense of the others. @after axes
  Weights weights = {};
  // @section -
  /// What plans keep, whatever it costs. Each may be never. @after weights
  PlanLimits constraints = {};

  /// Gains of the controller `baseline`, an impedance with force feedback. @code of the controller
  /// `baseline`
  ImpedanceGains baseline = {};
  /// Gains of the controller `admittance`: force error to motion, inverse kinematics,
  /// joint\npositions that are held. @code of the controller `admittance`
  AdmittanceGains admittance = {};

  /// What the controller does not know. Or one word: none, sensors, mismatch, joint_friction;
  /// or\n`preset: word` and keys that differ from it. @code what the controller does not know
  Disturbances disturbances = {};
};

}  // namespace burnish::polishing
