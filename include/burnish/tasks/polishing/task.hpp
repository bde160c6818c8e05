// The polishing task as a struct: all keys of a task file, with their defaults.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "burnish/mpc/mpc_spec.hpp"
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

/// Oscillation of a surface that is attached to a frame of the robot. At the time t after contact,
/// the frame has moved from its placement at the start by the translation shift * s and the
/// rotation vector turn * s, with s = sin(2 pi frequency t). The amplitude grows smoothly during
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
  /// Weight on the position error of the frame that carries the surface [1/m^2], >= 0
  double position = 1e4;
  /// Weight on the rotation error of the frame that carries the surface [1/rad^2], >= 0
  double rotation = 1e3;
};

/// Second hand of a standing robot. The hand rests on a plane that is fixed in the world. It is in
/// contact from the starting posture on, in all phases.
/// @described polishing
/// Plans keep the hand in place and bring its normal force to `force`. The force is measured by a
/// sensor in the hand, as for the feet.
struct RestingHand {
  /// Frame of the resting hand; its origin is the centre of the round tip (`none`: no hand rests)
  /// @word none
  std::string frame = {};
  double force = 20.0;  ///< Normal force that the hand rests with [N], > 0
  /// Normal of the plane [x, y, z] in world axes, towards the hand, not zero
  /// @more The normal points out of the material. It need not have unit length.
  /// @key normal
  Eigen::Vector3d normal_world = Eigen::Vector3d::UnitZ();
  double radius = 0.02;        ///< Radius of the round tip of the hand [m], > 0
  double friction = 0.5;       ///< Coulomb friction coefficient of the plane in the plant, >= 0
  double plan_friction = 0.2;  ///< Friction coefficient of the plane that plans assume, > 0
  double stiffness = 1e5;      ///< Stiffness of the plane in the plant [N/m], > 0
  /// Weight on errors of the normal force of the hand [1/N^2], >= 0
  /// @more A hundredth of this weight acts on the tangential force.
  double weight = 1.0;
  /// Largest distance that the hand may slide on the plane [m], > 0 or infinite
  /// @more A greater distance is a fault.
  double slip = 0.03;

  bool is_stated() const { return !frame.empty(); }
};

/// Cost weights. Each cost is integrated over the horizon, with time in s. Doubling the weight of a
/// term halves the part of its error that is caused by the other terms.
/// @described polishing
struct Weights {
  /// Weight on joint angles relative to the starting posture [1/rad^2], >= 0
  /// @more A larger weight keeps the elbow in place but costs accuracy.
  double posture = 0.1;
  /// Weight on joint velocities [s^2/rad^2], >= 0
  /// @more A larger weight damps more but lets the tool lag on fast paths.
  double velocity = 1.0;
  /// Weight on torques relative to the torques that hold the starting posture [1/Nm^2], >= 0
  double torque = 1e-4;
  /// Weight on the tool's distance from the path (automatic: fitted to the arm) [1/m^2], >= 0
  /// @more The function fit_gains() chooses the automatic weight. In the phase Reach, the weight is
  /// on the distance from a point above the surface.
  /// @word auto @after force
  std::optional<double> position = {};
  /// Weight on errors of the tool's normal speed in approach and retreat [s^2/m^2], >= 0
  /// @after position
  double approach = 1e2;
  /// Weight on the rotation of the tool from its orientation at the start [1/rad^2], >= 0
  /// @more With a smaller weight the wrist turns more.
  /// @after approach
  double rotation = 1.0;
  /// Weight on errors of the normal force [1/N^2], >= 0
  /// @after -
  double force = 1.0;
  /// Duration that multiplies the weights in the terminal cost [s], >= 0
  double terminal = 0.1;
};

/// Requirements on a run for the outcome "polished". They apply to the plant's true force and
/// position, from the end of the ramp to the end of the path.
/// @described polishing
struct Verdict {
  /// Smallest allowed time in contact, as a fraction of the whole time, 0 to 1
  double contact_share = 0.99;
  /// Allowed rms force error as a fraction of the task's force (`never`: no limit), > 0 or infinite
  /// @more The force is averaged over 10 ms. The word `never` stands for infinite. For a resting
  /// hand, the allowed error is this fraction of rest.force.
  double force_rmse = 0.1;
  /// Smallest allowed fraction of the path's length on which the tip is over its target, 0 to 1
  /// @more The tip is over its target if its distance to the target along the surface is at most
  /// the tip's radius. For a path without end, the length is the distance that the tool travels in
  /// Task.polish_duration.
  double path_share = 0.99;
};

/// Task of polishing a surface along a path. The members are the keys of a task file, with their
/// defaults.
/// @described polishing
struct Task {
  /// Name, folder or settings file of the robot, optionally followed by `:variant`
  std::string robot = "talos:right_arm";
  /// Starting posture: a name from the robot's settings, or `search` (find one for the surface)
  /// @more The starting posture is also the posture target in the null space. The search is made by
  /// find_posture(). If the name is empty, the robot's default posture is used; if there is none, a
  /// posture is searched. A posture is also searched if the robot lacks the posture that belongs to
  /// a named surface.
  std::string posture = {};
  /// Add a rotor inertia (armature) of 2 ms * effort / velocity to joints whose rotor is missing
  /// @more Effort and velocity are the limits of the joint. The armature is added in plans and
  /// plant. A rotor counts as missing if torque noise alone drives the joint beyond its speed
  /// limit. If assume_rotors is false, a note names the joints without a rotor.
  bool assume_rotors = false;
  /// Requirements on a starting posture that is found by a search.
  /// @after waving
  PostureLimits search = {};
  // @section tool

  /// Posture in which a run begins, if it differs from the starting posture of the task.\nThe
  /// joints first move straight to the starting posture, in a phase `home`.
  /// @after search
  HomeSpec home = {};
  Standing standing = {};  ///< Feet and ground of a robot with a floating base. @after home
  /// Frame of the tool; its origin is the centre of the round tip @key frame
  std::string tool = "tool";
  // @section surface The controller knows where the surface is, but not its friction and
  // stiffness.\nThe name of a surface can replace all keys, and sets posture, normal and point. The
  // names are\ntable, board, board_x, board_y, board_minus_y and tilt_45.

  /// Pressing direction [x, y, z] in the tool's frame (automatic: away from the arm), not zero
  /// @more If robot.yaml defines the tool's frame, the automatic direction is the frame's z or -z
  /// axis. Otherwise it is the axis of the last joint; see pressing_direction(). The vector need
  /// not have unit length. In a stated starting posture, the angle between the pressing direction
  /// and the direction into the surface must be at most search.tilt.
  /// @key axis @word auto
  std::optional<Eigen::Vector3d> tool_axis = {};
  double tip_radius = 0.02;  ///< Radius of the round tip [m], > 0

  /// Frame that carries the surface: world, or a frame of the robot such as its other hand
  /// @more An empty name also means the world. The surface may be a plate in the other hand. Normal
  /// and point of the surface are in the axes of this frame.
  /// @key frame @word world
  std::string surface_frame = {};
  /// Oscillation of the surface, if a frame of the robot carries it.
  /// @after shape
  Waving waving = {};
  /// Normal of the surface [x, y, z], towards the robot, not zero
  /// @more The normal is in the axes of `surface_frame`, and points out of the material. It need
  /// not have unit length.
  /// @key normal
  Eigen::Vector3d normal_base = Eigen::Vector3d::UnitZ();
  /// Position [x, y, z] of any point on the surface (under_tool: `clearance` below the tool) [m]
  /// @more The position is in the frame `surface_frame`. With `under_tool`, the point is below the
  /// tool's position at the start.
  /// @key point @word under_tool
  std::optional<Eigen::Vector3d> point_base = {};
  /// Shape of the surface: a plane, or a curved shape about `point`.\nThe path is projected onto
  /// the surface along the normal at `point`.
  /// @after damping
  SurfaceShape shape = {};
  /// Width of the surface beyond the path on all four sides (`endless`: no edges) [m], >= 0 or
  /// infinite
  /// @more The surface is a square about the path's origin. Its half side is the largest distance
  /// of the path from its origin, plus `extent`. The word `endless` stands for infinite; the
  /// surface is then a whole plane.
  /// @word endless
  double extent = 0.1;
  /// Coulomb friction coefficient, unless disturbances.surface_friction states another one, >= 0
  double friction = 0.0;
  double stiffness = 1e5;  ///< Stiffness of the surface in the plant [N/m], > 0
  double damping = 500.0;  ///< Damping of the surface in the plant [Ns/m], >= 0

  double force = 30.0;  ///< Normal force that the tool presses with [N], > 0 @after assume_rotors
  /// Pressing force of the tool right after contact [N], >= 0
  /// @more This force keeps the tool from rebounding. The ramp starts at this force.
  /// @after approach_speed
  double touch_force = 6.0;
  /// Target force as a function of the time on the path. Before the path, the force rises to
  /// `force`.
  ForceProfile force_profile = {};
  /// Second hand of a standing robot, which rests on a fixed plane in all phases.\nThe plane
  /// touches the hand in the starting posture.
  /// @after standing
  RestingHand rest = {};
  // @section phases Reach above the surface, approach until contact, ramp the force, polish,
  // retreat.

  /// Path in the plane of the surface. The path begins at rest at the point below the tool's
  /// position at the start.
  /// @after rest
  PathSpec path = {};
  /// Distance between tool and surface at the end of the phase Reach [m], > 0
  double clearance = 0.02;
  double reach_duration = 0.5;    ///< Duration of the phase Reach [s], > 0
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
  /// Number of knots in the plan (0: one knot per `step`), >= 0
  /// @more The steps between knots grow to cover the horizon. With 0, all steps are equal.
  int knots = 0;
  double update_rate = 1000.0;  ///< Rate of new plans, tick_rate divided by an integer [Hz], > 0
  double tick_rate = 2000.0;    ///< Rate of torque commands [Hz], > 0
  /// Rule for when a new plan is used: `fixed` (after solver_delay), `measured` (after its
  /// computing time) or `thread`
  /// @more With `measured`, a simulation delays the plan by its computing time. With `thread`,
  /// a separate thread computes plans, and a plan is used as soon as it is ready.
  PlanTiming timing = PlanTiming::Fixed;
  /// Time from a measurement to the use of the plan computed from the measurement [s], >= 0
  double solver_delay = 0.0;
  /// Assumed delay from a torque command to the torque in the joint [s], 0 to 0.1
  /// @more The delay is rounded to ticks. Plans and feedback start from a state that is predicted
  /// from the torques already sent.
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
  /// @more If the steps of plans are 10 ms, the value must be at least 0.1 m/s.
  double friction_speed = 0.1;
  /// Cutoff of the torque lag in plans (0: no lag) [rad/s], >= 0
  /// @more The key disturbances.torque_cutoff sets the lag of the plant.
  double torque_cutoff = 0.0;
  /// Axes of contact and force: `surface`, `local` (fixed to the tool) or `world`
  ForceAxes axes = ForceAxes::Surface;
  /// Apply the plan's Riccati feedback between plans; false: apply only the plan's torques
  /// @after solver
  bool feedback = true;
  /// Estimation of model errors from measurements. Each plan includes the estimate.
  /// @note If bandwidth, transient_scale, lag or force_gain have no value, fit_gains() fits them to
  /// the arm.
  ModelErrorOptions model_error = {.quiescent_scale = 0.25, .sliding_bandwidth = 360.0};
  /// Estimation of the surface from the motion of the tip. Plans use the estimate only if `axes` is
  /// `surface`.
  SurfaceEstimateOptions surface_estimate = {};
  /// Friction coefficient between tool and surface that plans assume, and its estimation.
  FrictionEstimateOptions friction_estimate = {.enabled = false};
  SafetyLimits limits = {.torque_gap = 0.25};
  ToolLimits tool_limits = {};  ///< @key limits
  /// Normal force above which the tool counts as in contact [N], > 0 or infinite
  /// @more The noise of the force is measured in free air. If six standard deviations of the noise
  /// exceed the threshold, the force is averaged over 5 ms. For contact, the average must then
  /// exceed the threshold, and also six standard deviations of the noise that is left after
  /// averaging.
  double contact_threshold = 2.0;
  // @section limits Exceeding a limit ends the run and is reported as a fault.\nThe fallback
  // controller then brakes and holds the robot. `never` switches a limit off.

  /// Use the force sensor; false: estimate the force from torques and joint motion
  /// @more The estimated force is relative to its value in free air just before contact.
  /// @after torque_cutoff
  bool force_sensor = true;
  /// Controller after a fault: gravity compensation, a damper, and a spring of limited torque.
  Fallback fallback = {};
  /// Cost weights; each cost is integrated over the horizon, with time in s. Only ratios of weights
  /// matter.\nA larger weight reduces the error of its own term and increases the errors of the
  /// other terms.
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

  /// Disturbances that the controller does not know.\nIn a task file, one of the words none,
  /// sensors, mismatch and joint_friction can replace all keys.\nWith the key `preset` and one of
  /// these words, only keys that differ from the preset are needed.
  Disturbances disturbances = {};
};

}  // namespace burnish::polishing
