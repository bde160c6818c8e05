// The polishing task as a struct: all keys of a task file, with their defaults.
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

/// Axes in which the contact and its force are expressed.
/// @described polishing
enum class ForceAxes {
  /// Axes of the surface: x and y along the surface, z out of the surface. If the surface is
  /// aligned with the world, this is the centred frame of Kleff et al.
  Surface,
  Local,  ///< Axes fixed to the tool, parallel to the surface's axes at the start
  World,  ///< Axes fixed to the world, parallel to the surface's axes at the start
};

/// Oscillation of a surface that is attached to a frame of the robot. The frame moves from its
/// placement at the start by the translation shift * s and the rotation vector turn * s. Here s =
/// sin(2 pi frequency t), where t is the time since contact. The amplitude grows smoothly during
/// start_up.
/// @described polishing
struct Waving {
  /// Amplitude of the translation, [x, y, z] in world axes [m]
  /// @key shift
  Eigen::Vector3d shift_world = Eigen::Vector3d::Zero();
  /// Amplitude of the rotation vector, [x, y, z] in world axes [rad]
  /// @key turn
  Eigen::Vector3d turn_world = Eigen::Vector3d::Zero();
  double frequency = 0.3;  ///< Frequency of the oscillation [Hz], > 0
  double start_up = 1.0;   ///< Time from contact to the full amplitude [s], > 0
  /// Weight on the distance of the frame's origin from its target [1/m^2], >= 0
  double position = 1e4;
  double rotation = 1e3;  ///< Weight on the angle between the frame and its target [1/rad^2], >= 0
};

/// Cost weights, per second of horizon. If the weight of a term is doubled, the other terms cause
/// half the error in that term.
/// @described polishing
struct Weights {
  /// Weight on joint angles relative to the start [1/rad^2], >= 0
  /// @more A larger weight keeps the elbow in place but costs accuracy.
  double posture = 0.1;
  /// Weight on joint velocities [s^2/rad^2], >= 0
  /// @more A larger weight damps more but lets the tool lag on fast paths.
  double velocity = 1.0;
  /// Weight on torques relative to the torques that hold the start [1/Nm^2], >= 0
  double torque = 1e-4;
  /// Weight on the tool's distance from the path (auto: fitted to the arm) [1/m^2], >= 0
  /// @code Weight on the tool's distance from the path (none: fitted to the arm) [1/m^2]
  /// @more fit_gains() fits the weight. During the reach, the target is the point above the
  /// surface.
  /// @word auto @after force
  std::optional<double> position = {};
  /// Weight on errors of the tool's normal speed in approach and retreat [s^2/m^2], >= 0
  /// @after position
  double approach = 1e2;
  /// Weight on the tool's orientation relative to the start [1/rad^2], >= 0
  /// @more With a smaller weight the wrist turns more.
  /// @after approach
  double rotation = 1.0;
  /// Weight on errors of the normal force [1/N^2], >= 0
  /// @after -
  double force = 1.0;
  /// Duration by which the weights are multiplied for the terminal cost [s], >= 0
  double terminal = 0.1;
};

/// Requirements on a run for the outcome "polished". They apply to the plant's true force and
/// position, from the end of the ramp to the end of the path.
/// @described polishing
struct Verdict {
  /// Smallest allowed fraction of the time in contact, 0 to 1
  double contact_share = 0.99;
  /// Largest allowed rms error of the force, as a fraction of the task's force; or never, > 0 or
  /// infinite
  /// @code Largest allowed rms error of the force, as a fraction of the task's force
  /// @more The force is averaged over 10 ms. The value never (infinite) allows any error.
  double force_rmse = 0.1;
  /// Smallest allowed fraction of the path's length on which the tip is over its target, 0 to 1
  /// @more The tip is over its target if their distance along the surface is at most the tip's
  /// radius. The length of a path without end is the length that the tool travels in
  /// Task.polish_duration.
  double path_share = 0.99;
};

/// Task of polishing a surface along a path: all keys of a task file, with their defaults.
/// @described polishing
struct Task {
  /// Name, folder or settings file of the robot, optionally with :variant
  std::string robot = "talos:right_arm";
  /// Starting posture, also the target of the null space (search: find one for the surface)
  /// @more The value is a posture's name in the robot's settings, or search, which calls
  /// find_posture(). If empty: the robot's default posture, or a search if the robot has none. If
  /// the robot does not have the posture of a named surface, that posture is searched, too.
  std::string posture = {};
  /// Add an armature of 2 ms * effort / velocity to joints whose rotor is missing
  /// @more Effort and velocity are the limits of the joint. The armature is added in plans and
  /// plant. A rotor counts as missing if torque noise alone drives the joint beyond its speed
  /// limit. If false, a note names these joints.
  bool assume_rotors = false;
  /// Requirements on a starting posture that is found by a search.
  /// @after waving
  PostureLimits search = {};
  // @section tool

  /// Posture where a run begins, if it differs from the start of the task.\nFrom there the joints
  /// move straight to the start, in a phase `home`.
  /// @after search
  HomeSpec home = {};
  Standing standing = {};  ///< Feet and ground of a robot with a floating base. @after home
  /// Frame of the tool; its origin is the centre of the round tip @key frame
  std::string tool = "tool";
  // @section surface The controller knows where the surface is, but not its friction and
  // stiffness.\nOne word can replace all keys and set posture, normal and point:\ntable, board,
  // board_x, board_y, board_minus_y, tilt_45.

  /// Pressing direction [x, y, z] in the tool's frame (auto: away from the arm), not zero
  /// @code Pressing direction in the tool's frame (none: away from the arm)
  /// @more The automatic direction is z or -z of a frame from robot.yaml, else the axis of the last
  /// joint; see pressing_direction(). The vector need not have unit length. A stated starting
  /// posture must agree with the direction within search.tilt.
  /// @key axis @word auto
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< Radius of the round tip [m], > 0

  /// Frame of the robot that carries the surface, such as its other hand; or world
  /// @code Frame of the robot that carries the surface, such as its other hand; empty: the world
  /// @more The surface may be a plate in that hand. Normal and point of the surface are in the axes
  /// of this frame.
  /// @key frame @word world
  std::string surface_frame = {};
  /// Oscillation of the frame that carries the surface, if it is a frame of the robot.
  /// @after shape
  Waving waving = {};
  /// Normal of the surface [x, y, z], towards the robot, not zero
  /// @more The normal is in the axes of the frame that carries the surface; without such a frame,
  /// in world axes. It points out of the material and need not have unit length.
  /// @key normal
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  /// Position [x, y, z] of any point on the surface [m]; or under_tool: `clearance` below the tool
  /// @code Position of any point on the surface [m]; none: `clearance` below the tool at the start
  /// @more The position is in the axes of the frame that carries the surface; without such a frame,
  /// in world axes. The value under_tool refers to the tool at the start.
  /// @key point @word under_tool
  std::optional<Eigen::Vector3d> point_world = {};
  /// Shape of the surface: a plane, or a curved shape about its point.\nThe path is projected onto
  /// the surface along the normal at that point.
  /// @after damping
  SurfaceShape shape = {};
  /// Width of the surface beyond the path on all four sides (or endless) [m], >= 0 or infinite
  /// @code Width of the surface beyond the path on all four sides [m]
  /// @more The surface is a square about the path's origin. The value endless (infinite) makes it a
  /// whole plane.
  /// @word endless
  double extent = 0.1;
  /// Coulomb friction coefficient (replaced by disturbances.surface_friction if stated), >= 0
  double friction = 0.0;
  double stiffness = 1e5;  ///< Stiffness of the surface in the plant [N/m], > 0
  double damping = 500.0;  ///< Damping of the surface in the plant [Ns/m], >= 0

  double force = 30.0;  ///< Normal force that the tool presses with [N], > 0 @after assume_rotors
  /// Force that the tool presses with as soon as contact is made [N], >= 0
  /// @more This force keeps the tool from rebounding. The ramp starts at this force.
  /// @after approach_speed
  double touch_force = 6.0;
  /// Target force as a function of the time on the path. Before the path, the force rises to
  /// `force`.
  ForceProfile force_profile = {};
  // @section phases Reach above the surface, approach until contact, ramp the force, polish,
  // retreat.

  /// Path in the plane of the surface. The path begins at rest at the point under the start.
  /// @after standing
  PathSpec path = {};
  double clearance = 0.02;  ///< Distance between tool and surface at the end of the reach [m], > 0
  double reach_duration = 0.5;    ///< Duration of the reach [s], > 0
  double approach_speed = 0.03;   ///< Speed towards the surface [m/s], > 0
  double ramp_duration = 0.5;     ///< Duration of the ramp from touch_force to force [s], > 0
  double polish_duration = 12.6;  ///< Time on the path [s], > 0
  /// Duration of the retreat from the surface to the distance `clearance` [s], > 0
  double retreat_duration = 0.5;
  /// Requirements for the outcome "polished".\nThey apply to the plant's true force and position,
  /// from the end of the ramp to the end of the path.
  Verdict verdict = {};

  // @section controller Optimal control problem that is solved at every update, and the control
  // loop around it.
  double horizon = 1.0;  ///< Duration that a plan covers [s], > 0
  double step = 0.01;    ///< Time between the first two knots of the plan [s], > 0
  /// Number of knots in the plan (0: one every `step`), >= 0
  /// @more The steps between knots grow to cover the horizon. With 0, all steps are equal.
  int knots = 0;
  double update_rate = 1000.0;  ///< Rate of new plans, tick_rate divided by an integer [Hz], > 0
  double tick_rate = 2000.0;    ///< Rate of torque commands [Hz], > 0
  /// When a new plan is used: fixed (after solver_delay), measured (after its computing time) or
  /// thread
  /// @more With measured, simulations delay the plan by its computing time, too. With thread, a
  /// separate thread computes plans, and a plan is used as soon as it is ready.
  PlanTiming timing = PlanTiming::Fixed;
  /// Time from a measurement to the use of the plan that starts from it [s], >= 0
  double solver_delay = 0.0;
  /// Assumed delay from a command to its torque [s], 0 to 0.1
  /// @more The delay is rounded to ticks. Plans and feedback start from the state that the torques
  /// already sent lead to.
  double command_delay = 0.0;
  /// Assumed delay from a measurement to the tick that receives it [s], 0 to 0.1
  double measurement_delay = 0.0;
  /// Factor on the measured computing time of plans, if timing is measured, > 0
  double slowdown = 1.0;
  int iterations = 1;  ///< Number of solver iterations per plan, >= 1
  /// Type of the solver's step: multiple_shooting or rollout
  StepUpdate solver = StepUpdate::MultipleShooting;
  double contact_kd = 40.0;  ///< Damping of the contact constraint (Baumgarte) [1/s], >= 0
  /// Sliding speed below which friction fades to zero in plans [m/s], > 0
  /// @more Plans with steps of 10 ms do not tolerate a smaller value than 0.1 m/s.
  double friction_speed = 0.1;
  /// Cutoff of the torque lag in plans (0: no lag) [rad/s], >= 0
  /// @more The lag of the plant is a key of disturbances.
  double torque_cutoff = 0.0;
  /// Axes of contact and force: surface, local (fixed to the tool) or world
  ForceAxes axes = ForceAxes::Surface;
  /// Apply the plan's Riccati feedback between plans; false: apply only the plan's torques
  /// @after solver
  bool feedback = true;
  /// Estimation of model errors from measurements. Each plan includes the estimate.
  /// @note Bandwidth, boost, lag and force_gain are fitted to the arm unless stated; see
  /// fit_gains().
  ModelErrorOptions model_error = {.calm = 0.25, .sliding_bandwidth = 360.0};
  /// Estimation of the surface from the path of the tip. Plans use the estimate only if `axes` is
  /// surface.
  SurfaceEstimateOptions surface_estimate = {};
  /// Friction coefficient between tool and surface that plans assume, and its estimation.
  FrictionEstimateOptions friction_estimate = {.enabled = false};
  SafetyLimits limits = {.torque_gap = 0.25};
  ToolLimits tool_limits = {};  ///< @key limits
  /// Normal force above which the tool counts as in contact [N], > 0 or infinite
  /// @more The noise of the force is measured in free air. If six standard deviations of the noise
  /// exceed the threshold, the mean force over 5 ms is used. Contact then requires that the mean
  /// exceeds both the threshold and six standard deviations of the mean.
  double contact_threshold = 2.0;
  // @section limits Exceeding a limit ends the run and is reported as a fault.\nThe fallback
  // controller then brakes and holds the robot. `never` switches a limit off.

  /// Use the force sensor; false: estimate the force from torques and joint motion
  /// @more The estimate is relative to the estimate in free air just before contact.
  /// @after torque_cutoff
  bool force_sensor = true;
  /// Controller after a fault: gravity compensation, a damper, and a spring of limited torque.
  Fallback fallback = {};
  /// Cost weights, per second of horizon. Only their ratios matter.\nA larger weight reduces the
  /// error of its own term and increases the errors of the other terms.
  /// @after axes
  Weights weights = {};
  // @section -

  /// Hard constraints of plans; `never` switches a constraint off.
  /// @after weights
  PlanLimits constraints = {};

  /// Gains of the controller `baseline`, an impedance with force feedback.
  ImpedanceGains baseline = {};
  /// Gains of the controller `admittance`: force loop, inverse kinematics and joint position loop.
  AdmittanceGains admittance = {};

  /// Disturbances that the controller does not know.\nOne word can replace all keys: none, sensors,
  /// mismatch or joint_friction.\nWith the key `preset` and one of these words, only keys that
  /// differ from the preset are needed.
  /// @code Disturbances that the controller does not know
  Disturbances disturbances = {};
};

}  // namespace burnish::polishing
