// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "pressing/descriptions.gen.hpp"
#include "pressing/figures.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const AdmittanceGains* /*of*/) {
  using S = AdmittanceGains;
  static const Description all =
      Describe<S>("sim", "AdmittanceGains",
                  "Gains of the admittance controller: an outer force loop and an inner joint "
                  "position loop. The inner loop uses the robot's mass matrix and gravity.")
          .field("rate", &S::rate,
                 "Rate of the outer loop [{Hz}]",
                 {.least = 0, .open = true})
          .more("The period is rounded to whole ticks, at least one.")
          .field("delay", &S::delay,
                 "Delay between the outer loop and the inner loop [{s}]",
                 {.least = 0, .most = 1})
          .more("The delay counts from the measurement of the outer loop and is rounded to ticks.")
          .field("force_cutoff", &S::force_cutoff,
                 "Cutoff of the low-pass filter on the measured force in the outer loop [{rad/s}]",
                 {.least = 0, .open = true})
          .field("mass", &S::mass,
                 "Mass of the admittance, as a multiple of the tool's inertia along the normal",
                 {.least = 0})
          .field("damping", &S::damping,
                 "Damping of the admittance, as a multiple of the tool's inertia along the normal"
                 " [{1/s}]",
                 {.least = 0, .open = true})
          .field("ki", &S::ki,
                 "Integral gain on the force error (0: no integral) [{1/s}]",
                 {.least = 0})
          .field("integral_limit", &S::integral_limit,
                 "Largest correction by the integral of the force error [{N}]",
                 {.least = 0})
          .field("path_gain", &S::path_gain,
                 "Gain from the position error along the surface to the tool's velocity [{1/s}]",
                 {.least = 0})
          .more("The error is the distance between the path and the tip at the commanded joint "
                "positions.")
          .field("ik_damping", &S::ik_damping,
                 "Damping of the inverse kinematics (damped least squares) [{m/rad}]",
                 {.least = 0, .open = true})
          .field("posture_gain", &S::posture_gain,
                 "Gain from the posture error to the joint velocities in the null space [{1/s}]",
                 {.least = 0})
          .field("joint_kp", &S::joint_kp,
                 "Proportional gain of the inner loop [{1/s^2}]",
                 {.least = 0})
          .field("joint_kd", &S::joint_kd,
                 "Derivative gain of the inner loop [{1/s}]",
                 {.least = 0})
          .field("joint_ki", &S::joint_ki,
                 "Integral gain of the inner loop (0: no integral) [{1/s^3}]",
                 {.least = 0})
          .field("joint_integral_limit", &S::joint_integral_limit,
                 "Largest correction of joint accelerations by the integral of the inner loop "
                 "[{rad/s^2}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const AdmittanceSpec* /*of*/) {
  using S = AdmittanceSpec;
  static const Description all =
      Describe<S>("sim", "AdmittanceSpec",
                  "Controller with two loops, as for arms with a position interface. The outer "
                  "loop turns the force error into a motion of the tool along the surface's "
                  "normal n. Inverse kinematics turn this motion into joint positions q_c, which "
                  "the inner loop tracks. Outer loop: the commanded speed v_n along n solves l "
                  "(mass dv_n/dt + damping v_n) = (f - f_path) + ki * integral of (f - f_path), "
                  "where f is the low-pass filtered force along n, and l the tool's inertia along"
                  " n. The tool's velocity is v_n n along n, and v_path + path_gain (p_path - p) "
                  "along the surface. f_path, p_path and v_path are the targets of force, "
                  "position and velocity, and p is the tip's position at q_c. Damped least "
                  "squares compute dq_c/dt from the tool's velocity. The inner loop computes, "
                  "`delay` later, the torques tau = M (joint_kp (q_c - q) + joint_kd (dq_c/dt - "
                  "v) + joint_ki * integral of (q_c - q)) + b. M is the mass matrix and b the "
                  "bias torques. Both integrals are bounded, restart at contact, and pause while "
                  "a torque is at its limit.")
          .field("path", &S::path,
                 "Approach, force and path of the tool")
          .field("gains", &S::gains,
                 "Gains of both loops");
  return all;
}

const Description& description_of(const HomeSpec* /*of*/) {
  using S = HomeSpec;
  static const Description all =
      Describe<S>("pressing", "HomeSpec",
                  "Home posture, in which a run begins. The robot moves from home to the start of"
                  " its task.")
          .field("posture", &S::posture,
                 "Named posture in which the run begins (`none`: the starting posture of the "
                 "task)")
          .word("none")
          .field("joints", &S::joints,
                 "Joint positions that differ from the named posture, in rad (m): {joint: "
                 "position, ...}")
          .more("If no posture is named, all other joints have their positions at the start of "
                "the task.")
          .field("speed_ratio", &S::speed_ratio,
                 "Highest joint speed of the move from home, as a fraction of the velocity limits",
                 {.least = 0.01, .most = 1})
          .field("duration", &S::duration,
                 "Duration of the move (automatic: as short as the limits allow, at least 1 s) "
                 "[{s}]",
                 {.least = 0, .open = true})
          .more("The limits are speed_ratio times the velocity limits and 0.8 times the effort "
                "limits.")
          .word("auto");
  return all;
}

const Description& description_of(const HomeMove* /*of*/) {
  using S = HomeMove;
  static const Description all =
      Describe<S>("pressing", "HomeMove",
                  "Move in joint space from home, where a run begins, to the start of the task. "
                  "The move leads through configurations called corners. The joints move straight"
                  " from each corner to the next and stop at each corner.")
          .field("corners", &S::corners,
                 "Configurations at the corners, nq each: home first, the start of the task last")
          .more("If a straight move would touch the surface, a corner in between lifts the tool "
                "off the surface.")
          .field("durations", &S::durations,
                 "Durations of the moves from each corner to the next [{s}]")
          .field("settle", &S::settle,
                 "Time at rest between the move and the task [{s}]")
          .field("farthest_joint", &S::farthest_joint,
                 "Name of the entry of v that moves farthest")
          .field("farthest", &S::farthest,
                 "Distance that the joint `farthest_joint` moves [{rad (m)}]");
  return all;
}

const Description& description_of(const ImpedanceGains* /*of*/) {
  using S = ImpedanceGains;
  static const Description all =
      Describe<S>("sim", "ImpedanceGains",
                  "Gains of the impedance controller. The gains act on the tool's position error "
                  "along the surface, on the force error along the normal, and on the posture "
                  "error.")
          .field("kp", &S::kp,
                 "Proportional gain on the position error along the surface [{1/s^2}]",
                 {.least = 0})
          .field("kd", &S::kd,
                 "Derivative gain on the position error along the surface [{1/s}]",
                 {.least = 0})
          .field("ki_position", &S::ki_position,
                 "Integral gain on the position error along the surface (0: no integral) "
                 "[{1/s^3}]",
                 {.least = 0})
          .field("position_integral_limit", &S::position_integral_limit,
                 "Largest correction by the integral of the position error [{m/s^2}]",
                 {.least = 0})
          .field("kd_normal", &S::kd_normal,
                 "Damping of the tool's velocity along the normal [{1/s}]",
                 {.least = 0})
          .field("ki", &S::ki,
                 "Integral gain on the force error (0: no force feedback) [{1/s}]",
                 {.least = 0})
          .field("integral_limit", &S::integral_limit,
                 "Largest correction by the integral of the force error [{N}]",
                 {.least = 0})
          .field("posture_kp", &S::posture_kp,
                 "Proportional gain on the posture error in the null space [{1/s^2}]",
                 {.least = 0})
          .field("posture_kd", &S::posture_kd,
                 "Derivative gain on the posture error in the null space [{1/s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const ImpedanceSpec* /*of*/) {
  using S = ImpedanceSpec;
  static const Description all =
      Describe<S>("sim", "ImpedanceSpec",
                  "Baseline controller without optimal control: an impedance of the tool in the "
                  "world. It has feedforward of the target force, integrals of the force and "
                  "position errors, and control of the posture in the null space. The controller "
                  "computes the acceleration a = a_path + kp e + kd de/dt + ki_position * "
                  "integral of e - kd_normal v_n n and the force f = f_path + ki * integral of "
                  "(f_path - f_measured). The tool's inertia and Jacobian turn a and f into "
                  "torques. Here n is the surface's normal, e the tool's position error along the"
                  " surface, and v_n the tool's velocity along n. a_path and f_path are the "
                  "targets of acceleration and force. All forces are along n. Both integrals are "
                  "bounded, restart at contact, and pause while a torque is at its limit.")
          .field("path", &S::path,
                 "Approach, force and path of the tool")
          .field("gains", &S::gains,
                 "Gains on position, force and posture")
          .field("friction", &S::friction,
                 "Friction coefficient that the feedforward of friction along the path assumes",
                 {.least = 0});
  return all;
}

const Words& words_of(PlantKind /*of*/) {
  static const Words all{
      "pressing",
      "PlantKind",
      "Kind of plant. A plant simulates a robot and the contacts of the robot.",
      {{"mujoco", "MuJoCo, a physics engine that shares no code with this library"},
       {"ideal", "contact dynamics of this library, with a rigid surface"}}};
  return all;
}

const Description& description_of(const TaskPoint* /*of*/) {
  using S = TaskPoint;
  static const Description all =
      Describe<S>("sim", "TaskPoint",
                  "Target of the tip at one time: motion of the origin of the tip's frame, and "
                  "force of the surface on the tip.")
          .field("p_world", &S::p_world,
                 "Position, world axes [{m}]")
          .field("v_world", &S::v_world,
                 "Velocity, world axes [{m/s}]")
          .field("a_world", &S::a_world,
                 "Acceleration, world axes [{m/s^2}]")
          .field("force", &S::force,
                 "Force along the surface's normal [{N}]")
          .field("normal_world", &S::normal_world,
                 "Unit normal of the surface at this point; zero: the controller's constant "
                 "normal is used");
  return all;
}

const Description& description_of(const CirclePath* /*of*/) {
  using S = CirclePath;
  static const Description all =
      Describe<S>("sim", "CirclePath",
                  "Circle in a plane. The path starts at the centre, at rest, and its radius "
                  "grows smoothly.")
          .field("center_world", &S::center_world,
                 "Centre of the circle, world axes [{m}]")
          .field("normal_world", &S::normal_world,
                 "Normal of the circle's plane, of any nonzero length")
          .field("radius", &S::radius,
                 "Final radius of the circle [{m}]")
          .field("rate", &S::rate,
                 "Angular rate about the normal [{rad/s}]")
          .field("start_up", &S::start_up,
                 "Time until the final radius is reached, positive [{s}]")
          .field("force", &S::force,
                 "Normal force to press with [{N}]");
  return all;
}

const Description& description_of(const PressingPath* /*of*/) {
  using S = PressingPath;
  static const Description all =
      Describe<S>("sim", "PressingPath",
                  "Task of a controller that makes no plans, in three phases: approach the "
                  "surface until contact, ramp up the force, then follow the path. These phases "
                  "are Approach, Ramp and Track in the enumeration Phase.")
          .field("tool", &S::tool,
                 "Frame of the tool; its origin follows the path")
          .field("normal_world", &S::normal_world,
                 "Normal of the surface, pointing towards the robot",
                 {.direction = true})
          .field("task", &S::task,
                 "Target of the tip as a function of the time since the end of the ramp, in s")
          .more("The function must not throw. During approach and ramp, the target is the start "
                "of the path.")
          .field("posture", &S::posture,
                 "Target posture for the motion in the null space, nq entries")
          .field("period", &S::period,
                 "Time between two ticks [{s}]",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "Speed of the approach, against the normal [{m/s}]",
                 {.least = 0})
          .field("contact_threshold", &S::contact_threshold,
                 "Measured normal force at which the approach ends [{N}]",
                 {.least = 0})
          .more("PressingTask describes how contact is detected.")
          .field("touch_force", &S::touch_force,
                 "Target force at contact, where the ramp starts [{N}]",
                 {.least = 0})
          .field("ramp", &S::ramp,
                 "Duration of the ramp from contact to the task's force [{s}]",
                 {.least = 0});
  return all;
}

const Words& words_of(Touch /*of*/) {
  static const Words all{
      "pressing",
      "Touch",
      "Contact between tool and surface that is expected in a phase.",
      {{"free", "no contact: a large force is a fault, a smaller force is sensor noise"},
       {"due", "the tool approaches until contact; the phase has SchedulePhase.until \"contact\""},
       {"wanted", "the tool presses"},
       {"leaving", "the tool leaves the surface; it counts as free when the force is gone, or after "
        "ToolLimits.release"}}};
  return all;
}

const Description& description_of(const ToolLimits* /*of*/) {
  using S = ToolLimits;
  static const Description all =
      Describe<S>("pressing", "ToolLimits",
                  "Limits on force and motion at the tool. A run is aborted if a limit is "
                  "exceeded. An infinite value switches a limit off.")
          .field("force", &S::force,
                 "Largest mean force at the tool over force_window [{N}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("A single sample of the force says little about a rigid impact: the sample is the"
                " impulse divided by the sampling time.")
          .field("force_window", &S::force_window,
                 "Averaging time of the force [{s}]",
                 {.least = 0})
          .more("The time is rounded to ticks, at least one.")
          .field("tool_speed", &S::tool_speed,
                 "Largest speed of the tool [{m/s}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("contact_lost", &S::contact_lost,
                 "Longest time without force in phases with contact [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("late_contact_travel", &S::late_contact_travel,
                 "Largest travel along the normal after the planned time of contact [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("A surface farther than this behind its assumed position is not reached. The "
                "travel counts from the time when the schedule's clock stops and waits for "
                "contact. The clock stops SchedulePhase.hold seconds before the planned contact.")
          .field("late_contact_time", &S::late_contact_time,
                 "Longest wait for contact after the planned time of contact [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The wait begins when the schedule's clock stops and waits for contact.")
          .field("unexpected_force", &S::unexpected_force,
                 "Largest mean force in free space over force_window [{N}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The limit applies to phases without contact. It also applies to a retreat after "
                "the force fell below the contact threshold, or after the time `release`. If six "
                "standard deviations of the mean's noise are above this limit, they are the limit"
                " instead.")
          .field("release", &S::release,
                 "Longest time until a retreating tool counts as free [{s}]",
                 {.least = 0, .open = true, .infinite = true});
  return all;
}

const Description& description_of(const PlanLimits* /*of*/) {
  using S = PlanLimits;
  static const Description all =
      Describe<S>("pressing", "PlanLimits",
                  "Hard constraints of plans. An infinite value switches a constraint off.")
          .field("joint_margin", &S::joint_margin,
                 "Smallest distance of joints from their position limits [{rad (m)}]",
                 {.least = 0, .infinite = true})
          .field("joint_speed", &S::joint_speed,
                 "Largest joint speed, as a fraction of the robot's velocity limits",
                 {.least = 0, .open = true, .infinite = true})
          .field("torque", &S::torque,
                 "Largest torque, as a fraction of the effort limits",
                 {.least = 0, .open = true, .infinite = true})
          .more("Torque commands obey this limit, too.")
          .field("force_band", &S::force_band,
                 "Largest deviation of the force from its target while pressing [{N}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The force itself is never negative, with or without this constraint.")
          .field("joint_torque_rate", &S::joint_torque_rate,
                 "Largest rate of torques, as a fraction of the effort limits per second [{1/s}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The constraint requires plans with a torque lag (torque_cutoff).");
  return all;
}

const Description& description_of(const TaskTarget* /*of*/) {
  using S = TaskTarget;
  static const Description all =
      Describe<S>("pressing", "TaskTarget",
                  "Recorded target of the tool at one time of the schedule. The recorded target "
                  "has no effect on the motion, which the costs of the problem determine.")
          .field("p_world", &S::p_world,
                 "Position of the tool in the frame ToolSpec.base (without such a frame: in the "
                 "world) [{m}]")
          .field("force", &S::force,
                 "Force along the normal (0: no contact) [{N}]")
          .more("Without contact, plans assume no friction.");
  return all;
}

const Description& description_of(const PressedSurface* /*of*/) {
  using S = PressedSurface;
  static const Description all =
      Describe<S>("pressing", "PressedSurface",
                  "Assumed position and shape of the surface under a round tip. The online "
                  "estimate of the surface starts from these assumptions.")
          .field("shape", &S::shape,
                 "Surface shape about `point_base`")
          .field("point_base", &S::point_base,
                 "Point on the surface [{m}]")
          .field("normal_base", &S::normal_base,
                 "Normal of the surface at `point_base`",
                 {.direction = true})
          .more("The normal need not have unit length.")
          .field("tip_radius", &S::tip_radius,
                 "Radius of the round tip [{m}]",
                 {.least = 0, .open = true})
          .field("estimate", &S::estimate,
                 "Options of the surface estimate");
  return all;
}

const Description& description_of(const PressingTask* /*of*/) {
  using S = PressingTask;
  static const Description all =
      Describe<S>("pressing", "PressingTask",
                  "Task of an MpcSpec that presses with a tool. The task raises the event "
                  "\"contact\" if the measured normal force exceeds both the contact threshold "
                  "and the noise of the sensor. The noise is estimated in free air.")
          .field("touch", &S::touch,
                 "Expected contact in each phase of the schedule")
          .field("target", &S::target,
                 "Target as a function of the time of the schedule, in s; required")
          .more("The function is called at each tick.")
          .field("limits", &S::limits,
                 "Limits on force and motion at the tool")
          .field("surface", &S::surface,
                 "Assumed surface, which is estimated during control; none: surface and normal "
                 "stay constant")
          .more("Plans use the assumed surface at first, and the estimated surface as soon as the"
                " tool slides. The constant surface and normal come from the specification.")
          .field("time_input", &S::time_input,
                 "Scalar input of the problem that receives the schedule's time of the previous "
                 "tick (empty: none)")
          .more("A signal that depends on this input can hide the future from plans.");
  return all;
}

const Description& description_of(const ReachOptions* /*of*/) {
  using S = ReachOptions;
  static const Description all =
      Describe<S>("pressing", "ReachOptions",
                  "Resolution and required margins of check_reach().")
          .field("spacing", &S::spacing,
                 "Distance between two checked points [{m}]")
          .field("tolerance", &S::tolerance,
                 "Largest position error of the tool [{m}]")
          .field("joint_margin", &S::joint_margin,
                 "Smallest distance of joints from their limits [{rad (m)}]")
          .field("torque_share", &S::torque_share,
                 "Largest static torque, as a fraction of the effort limits")
          .more("The rest of the torque is left for motion and feedback.")
          .field("link_radius", &S::link_radius,
                 "Radius of the segments that represent the arm in the collision check [{m}]")
          .more("See check_reach().");
  return all;
}

const Words& words_of(ReachProblem /*of*/) {
  static const Words all{
      "pressing",
      "ReachProblem",
      "Kind of problem that check_reach() finds.",
      {{"none"},
       {"position", "no posture brings the tool to the point, even without joint limits"},
       {"joint", "the tool reaches the point only with a joint beyond its limit"},
       {"torque", "holding the tool at the point needs more torque than a joint may use"},
       {"collision", "the arm or the tool would touch the surface where it must not"}}};
  return all;
}

const Description& description_of(const ReachReport* /*of*/) {
  using S = ReachReport;
  static const Description all =
      Describe<S>("pressing", "ReachReport",
                  "Result of a reach check: the first problem on the path of the tool, and the "
                  "smallest margins over all checked points.")
          .field("problem", &S::problem,
                 "Kind of the first problem")
          .field("text", &S::text,
                 "Problem in one sentence, with place, joint, value and allowed value; empty "
                 "without a problem")
          .field("s", &S::s,
                 "Distance along the path from its start to the problem [{m}]; negative if the "
                 "problem comes before the path")
          .more("The path of a task that holds a point has length zero.")
          .field("p_world", &S::p_world,
                 "Position of the tool at the problem, in the world [{m}]")
          .field("joint", &S::joint,
                 "Joint that causes the problem")
          .more("The name is empty for the kind `Position`, and if the tool's own link would "
                "touch the surface.")
          .field("value", &S::value,
                 "Value that violates `limit`")
          .more("The value depends on the kind of the problem. `Position`: position error of the "
                "tool, in m. `Joint`: position of the joint, in rad (m). `Torque`: torque of the "
                "joint, in Nm (N). `Collision`: distance from the surface, in m.")
          .field("limit", &S::limit,
                 "Allowed value, in the unit of `value`")
          .field("points", &S::points,
                 "Number of checked points")
          .field("path_length", &S::path_length,
                 "Length of the path [{m}]")
          .more("For a path that repeats itself, this is the length of one turn.")
          .field("joint_margin", &S::joint_margin,
                 "Smallest distance of a joint from its limit [{rad (m)}]")
          .field("tightest_joint", &S::tightest_joint,
                 "Joint with the smallest distance from its limit")
          .field("torque_share", &S::torque_share,
                 "Largest static torque, as a fraction of the joint's effort limit")
          .field("tightest_torque", &S::tightest_torque,
                 "Joint with the largest static torque, as a fraction of its effort limit")
          .field("force_per_torque", &S::force_per_torque,
                 "Standard deviation of the estimated force per standard deviation of joint "
                 "torques [{1/m}]")
          .more("The force along the normal is estimated from joint torques with independent "
                "errors. The value, in N per Nm, is the largest of all points on the surface. It "
                "matters for tasks without a force sensor.")
          .field("force_joint", &S::force_joint,
                 "Joint that contributes most to force_per_torque")
          .field("clearance", &S::clearance,
                 "Smallest distance between the surface and the arm, except the tool's link [{m}]")
          .more("The distance is infinite if only the tool's link moves.")
          .field("tightest_clearance", &S::tightest_clearance,
                 "Joint of the arm that comes closest to the surface");
  return all;
}

const Description& description_of(const PostureLimits* /*of*/) {
  using S = PostureLimits;
  static const Description all =
      Describe<S>("pressing", "PostureLimits",
                  "Conditions on a starting posture that find_posture() searches for.")
          .field("tilt", &S::tilt,
                 "Largest angle between tool axis and surface normal [{rad}]",
                 {.least = 0})
          .field("joint_margin", &S::joint_margin,
                 "Smallest distance of joints from their limits at the start [{rad}]",
                 {.least = 0})
          .more("The unit is m for prismatic joints.")
          .field("body_distance", &S::body_distance,
                 "Smallest distance of the last link from the robot's body [{m}]",
                 {.least = 0})
          .more("Parts that are close to each other along the arm may have a smaller distance.");
  return all;
}

const Description& description_of(const PostureOptions* /*of*/) {
  using S = PostureOptions;
  static const Description all =
      Describe<S>("pressing", "PostureOptions",
                  "Options of find_posture(): start points of the search and conditions on its "
                  "result.")
          .field("random_starts", &S::random_starts,
                 "Number of random start points")
          .more("The robot's named postures and the middle of the joint limits are start points "
                "too.")
          .field("seed", &S::seed,
                 "Seed of the random start points")
          .field("tilt_limit", &S::tilt_limit,
                 "Largest angle between the tool's pressing direction and the direction into the "
                 "surface [{rad}]")
          .field("joint_margin", &S::joint_margin,
                 "Smallest distance of joints from limits at the start [{rad (m)}]")
          .field("body_distance", &S::body_distance,
                 "Smallest distance between the last link and the robot's body [{m}]")
          .more("Three points between the last joint and the tool represent the last link. The "
                "body is represented by the lines between the earlier joints of the arm, and by "
                "the origins of all links that the last two joints do not carry. Between two "
                "places on the arm, a distance of `body_distance_fraction` times the arm's length"
                " between them is enough, as in a compact wrist. The test is coarse and does not "
                "replace a collision check.")
          .field("body_distance_fraction", &S::body_distance_fraction,
                 "Upper limit of body_distance for two places on the arm, as a fraction of the "
                 "arm's length between them")
          .more("With 0.55, two links of equal length may enclose an angle as small as 67 "
                "degrees.")
          .field("checked", &S::checked,
                 "Number of candidates whose whole path is checked, best first")
          .field("reach", &S::reach,
                 "Options of the reach check");
  return all;
}

const Description& description_of(const FoundPosture* /*of*/) {
  using S = FoundPosture;
  static const Description all =
      Describe<S>("pressing", "FoundPosture",
                  "Posture that find_posture() found.")
          .result()
          .field("q", &S::q,
                 "Configuration, nq")
          .field("score", &S::score,
                 "Score of the posture; lower is better")
          .field("tilt", &S::tilt,
                 "Angle between the tool's pressing direction and the direction into the surface "
                 "[{rad}]")
          .field("reach", &S::reach,
                 "Reach check of the task from this posture")
          .field("candidates", &S::candidates,
                 "Number of postures that met all conditions at the start");
  return all;
}

const Description& description_of(const Standing* /*of*/) {
  using S = Standing;
  static const Description all =
      Describe<S>("pressing", "Standing",
                  "Feet on level ground, at their positions in the starting posture. Plans keep "
                  "the feet still, and limit the tangential force and the centre of pressure of "
                  "each foot. The plant's ground can push a foot but not pull it, and has "
                  "friction.")
          .field("feet", &S::feet,
                 "Frames of the feet (`auto`: found in the robot's description; empty: the base "
                 "is fixed)")
          .more("With `auto`, the sizes of the feet also come from the description.")
          .word("auto")
          .field("half_x", &S::half_x,
                 "Half the length of a planar foot along x of its frame (0: point feet) [{m}]",
                 {.least = 0})
          .more("The origin of the frame is the middle of the foot's sole.")
          .field("half_y", &S::half_y,
                 "Half the width of a planar foot along y of its frame (0: point feet) [{m}]",
                 {.least = 0})
          .field("radius", &S::radius,
                 "Radius of a point foot [{m}]",
                 {.least = 0, .open = true})
          .field("friction", &S::friction,
                 "Coulomb friction coefficient of the plant's ground",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "Stiffness of the ground under each foot in the plant (automatic: from the "
                 "weight) [{N/m}]",
                 {.least = 0, .open = true})
          .more("With the automatic stiffness, the ground yields by 0.23 mm under the robot's "
                "weight (0.245 mm with point feet).")
          .word("auto")
          .field("damping", &S::damping,
                 "Damping of the ground under each foot in the plant (automatic: from the "
                 "stiffness) [{Ns/m}]",
                 {.least = 0, .open = true})
          .more("The automatic damping is the stiffness times 0.05 s (0.02 s with point feet).")
          .word("auto")
          .field("plan_friction", &S::plan_friction,
                 "Friction coefficient of the ground that plans assume",
                 {.least = 0, .open = true})
          .field("plan_sole", &S::plan_sole,
                 "Largest offset of the centre of pressure in plans, divided by the sole's half "
                 "sides",
                 {.least = 0, .most = 1})
          .field("min_load", &S::min_load,
                 "Smallest load of each foot in plans (automatic: 0.09 times the feet's mean "
                 "load) [{N}]",
                 {.least = 0})
          .word("auto")
          .field("balance", &S::balance,
                 "Weight on the distance of the centre of mass from its target [{1/m^2}]",
                 {.least = 0})
          .more("The target is the position at the start, unless the task moves the target.")
          .field("base", &S::base,
                 "Weight on the rotation of the base from its target [{1/rad^2}]",
                 {.least = 0})
          .more("The target is the orientation at the start, unless the task moves the target.")
          .field("momentum", &S::momentum,
                 "Weight on linear and angular centroidal momentum {per (kg m/s)^2 and (kg "
                 "m^2/s)^2}",
                 {.least = 0})
          .field("internal_forces", &S::internal_forces,
                 "Weight on tangential forces and yaw moments of each foot [{1/N^2}]",
                 {.least = 0})
          .more("This weight discourages internal forces between the feet.")
          .field("contact_kd", &S::contact_kd,
                 "Damping of the contact constraint of the feet (Baumgarte) [{1/s}]",
                 {.least = 0})
          .field("estimate", &S::estimate,
                 "Estimate the base's state from an inertial unit, joints and feet; false: "
                 "measure it directly")
          .field("imu_frame", &S::imu_frame,
                 "Frame of the inertial unit; empty: the body of the base")
          .field("fallback", &S::fallback,
                 "Gains that hold the robot at the start and after a fault")
          .more("These gains replace the fallback gains of the task. Light feet on compliant "
                "ground need low gains.")
          .field("hoist", &S::hoist,
                 "Time at the start in which a hoist transfers the weight to the feet [{s}]",
                 {.least = 0})
          .more("A time longer than `settle` is shortened to `settle`.")
          .field("slip", &S::slip,
                 "Reaction of plans to a slipping foot")
          .field("settle", &S::settle,
                 "Time for which the posture is held at the start [{s}]",
                 {.least = 0})
          .more("The estimate of the base settles in this time.")
          .field("force_sensors", &S::force_sensors,
                 "Whether the feet have sensors of force and moment")
          .field("after_fault", &S::after_fault,
                 "Time for which a run continues after a fault [{s}]",
                 {.least = 0})
          .more("The continued run shows whether the robot falls. The statistics of the task end "
                "at the fault.");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
