// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "polishing/descriptions.hpp"
#include "polishing/figures.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::polishing {

const Description& description_of(const ForceProfile* /*of*/) {
  using S = ForceProfile;
  static const Description all =
      Describe<S>("polishing", "ForceProfile",
                  "Target of the normal force as a function of the time on the path.")
          .field("kind", &S::kind,
                 "Shape of the force over time: constant, steps, lines or sine")
          .field("points", &S::points,
                 "Points of steps and lines: [[time on the path in s, force in N], ...]")
          .more("The kind `steps` uses the task's force until the first point. The kind `lines` "
                "starts with a straight line from the task's force at time 0 to the first point.")
          .field("amplitude", &S::amplitude,
                 "Amplitude of the sine about the force of the task [{N}]",
                 {.least = 0})
          .field("frequency", &S::frequency,
                 "Frequency of the sine [{Hz}]",
                 {.least = 0, .open = true})
          .field("start", &S::start,
                 "Time on the path when the sine begins [{s}]",
                 {.least = 0})
          .more("Before this time the force is constant.")
          .field("preview", &S::preview,
                 "Whether plans use the future target force; false: plans assume a constant "
                 "target force")
          .more("The assumed constant is the target force at the present time.");
  return all;
}

const Words& words_of(ForceProfile::Kind /*of*/) {
  static const Words all{
      "polishing",
      "ForceProfileKind",
      "Shape of the target force over the time on the path.",
      {{"constant"},
       {"steps", "At the time of each point, the force jumps to the force of the point"},
       {"lines", "Straight lines between points"},
       {"sine", "Sine about the force of the task"}}};
  return all;
}

const Description& description_of(const RequiredMargins* /*of*/) {
  using S = RequiredMargins;
  static const Description all =
      Describe<S>("polishing", "RequiredMargins",
                  "Stability margins that a control loop must have with the gains from "
                  "fit_gains(). The loop already contains the usual delays and filters.")
          .field("delay", &S::delay,
                 "Extra delay of commands that the control loop must tolerate [{s}]",
                 {.least = 0})
          .field("gain", &S::gain,
                 "Factor on the torque of any one joint that the control loop must tolerate",
                 {.least = 0, .open = true})
          .more("The control loop must also tolerate the inverse of the factor.");
  return all;
}

const Description& description_of(const TaskMargins* /*of*/) {
  using S = TaskMargins;
  static const Description all =
      Describe<S>("polishing", "TaskMargins",
                  "Stability margins of the control loop of a polishing task at its starting "
                  "posture.")
          .result()
          .field("air", &S::air,
                 "Margins with the tool in free air")
          .field("contact", &S::contact,
                 "Margins with the tool on the surface");
  return all;
}

const Description& description_of(const FittedGains* /*of*/) {
  using S = FittedGains;
  static const Description all =
      Describe<S>("polishing", "FittedGains",
                  "Result of fit_gains().")
          .result()
          .field("meets", &S::meets,
                 "True if the required margins are met or cannot be computed")
          .field("changes", &S::changes,
                 "Gains that differ from their initial values, as a text; empty if there are none");
  return all;
}

const Words& words_of(PathKind /*of*/) {
  static const Words all{
      "polishing",
      "PathKind",
      "Shape of a path.",
      {{"circle"},
       {"spiral"},
       {"zigzag"},
       {"points"}}};
  return all;
}

const Description& description_of(const PathSpec* /*of*/) {
  using S = PathSpec;
  static const Description all =
      Describe<S>("polishing", "PathSpec",
                  "Path in the plane of a surface. Coordinates (u, w) are along the two tangents "
                  "of the surface. The path begins at rest at its centre (0, 0).")
          .field("kind", &S::kind,
                 "Shape of the path: circle, spiral, zigzag or points")
          .field("radius", &S::radius,
                 "Radius of the circle, or largest radius of the spiral [{m}]",
                 {.least = 0, .open = true})
          .field("rate", &S::rate,
                 "Angular rate of the circle or spiral [{rad/s}]")
          .field("start_up", &S::start_up,
                 "Time until a circle reaches its full radius, or a spiral its full rate of "
                 "growth [{s}]",
                 {.least = 0, .open = true})
          .field("pitch", &S::pitch,
                 "Mean distance between two turns of the spiral [{m}]",
                 {.least = 0, .open = true})
          .more("The mean is computed over all turns from the centre to the largest radius.")
          .field("width", &S::width,
                 "Length of the zigzag along the first tangent [{m}]",
                 {.least = 0, .open = true})
          .field("height", &S::height,
                 "Length of the zigzag along the second tangent [{m}]",
                 {.least = 0, .open = true})
          .field("rows", &S::rows,
                 "Number of lines of the zigzag",
                 {.least = 2})
          .field("speed", &S::speed,
                 "Highest speed along a straight line of the zigzag or between points [{m/s}]",
                 {.least = 0, .open = true})
          .field("points", &S::points,
                 "Points [[u, w], ...] along the two tangents [{m}]; in files also a CSV file "
                 "with columns u and w")
          .more("The path leads from the centre through the points in straight lines, and stops "
                "at each point.");
  return all;
}

const Description& description_of(const PlanarPoint* /*of*/) {
  using S = PlanarPoint;
  static const Description all =
      Describe<S>("polishing", "PlanarPoint",
                  "Coordinates (u, w) of a path at one time, with their first two time "
                  "derivatives.")
          .field("p", &S::p,
                 "Position (u, w) [{m}]")
          .field("v", &S::v,
                 "Velocity of (u, w) [{m/s}]")
          .field("a", &S::a,
                 "Acceleration of (u, w) [{m/s^2}]");
  return all;
}

const Description& description_of(const FreeHome* /*of*/) {
  using S = FreeHome;
  static const Description all =
      Describe<S>("polishing", "FreeHome",
                  "Named posture from which the joints can move straight to the start of a task "
                  "without a problem.")
          .result()
          .field("posture", &S::posture,
                 "Name of the posture in the robot's settings")
          .field("duration", &S::duration,
                 "Duration of the move [{s}]");
  return all;
}

const Words& words_of(ControllerKind /*of*/) {
  static const Words all{
      "polishing",
      "ControllerKind",
      "Controller of a run.",
      {{"mpc", "Model predictive control (MpcController)"},
       {"baseline", "Impedance with force feedback, no optimisation (make_impedance_controller())"},
       {"admittance", "Admittance: the force error moves the targets of the joint positions "
        "(make_admittance_controller())"}}};
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("polishing", "RunSpec",
                  "Options of run_task().")
          .field("task", &S::task)
          .field("robot", &S::robot,
                 "Robot to use instead of the robot that the task names")
          .field("controller", &S::controller)
          .field("plant", &S::plant,
                 "Plant to simulate; by default MuJoCo, if this build has it")
          .field("check_reach", &S::check_reach,
                 "Check before the run by statics whether the arm can do the task; throw Error if"
                 " it cannot")
          .field("reach", &S::reach)
          .field("plan_rate", &S::plan_rate,
                 "Recording rate of the plans of the MPC (0: no recording) [{Hz}]")
          .more("At most 20 000 plans are recorded.")
          .field("progress", &S::progress,
                 "Callback that is called repeatedly with the simulated time and the run's "
                 "expected end, in s")
          .more("If the callback returns false, the run stops.");
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("polishing", "Setting",
                  "Task with all settings filled in: robot, start, surface, path in the world, "
                  "phases.")
          .field("robot", &S::robot,
                 "Robot of the task")
          .required()
          .field("q_start", &S::q_start,
                 "Configuration at the start, nq")
          .required()
          .field("scene", &S::scene,
                 "Tip, surface and feet as the controller assumes them")
          .required()
          .field("surface_axes", &S::surface_axes,
                 "Axes of the surface in the world; the columns are two tangents and the normal")
          .required()
          .field("p_start", &S::p_start,
                 "Position of the tool at the start, in the world [{m}]")
          .required()
          .field("p_center", &S::p_center,
                 "Position of the tool when it touches the surface at the path's origin, in the "
                 "world [{m}]")
          .required()
          .field("reach_end", &S::reach_end,
                 "Schedule time at the end of the phase Reach [{s}]")
          .field("touch", &S::touch,
                 "Schedule time of the planned contact [{s}]")
          .field("ramp_end", &S::ramp_end,
                 "Schedule time when the ramp ends and the path begins [{s}]")
          .field("track_end", &S::track_end,
                 "Schedule time at the end of the path [{s}]")
          .field("assumed_rotors", &S::assumed_rotors,
                 "Rotor inertia that Task.assume_rotors added to joints, by joint name [{kg m^2 "
                 "(kg)}]")
          .field("home", &S::home,
                 "Move from Task.home to q_start; none if the run begins at q_start");
  return all;
}

const Words& words_of(ForceAxes /*of*/) {
  static const Words all{
      "polishing",
      "ForceAxes",
      "Axes in which the contact and its force are expressed.",
      {{"surface", "Axes of the surface: x and y along the surface, z out of the surface. If the surface is "
        "aligned with the world, this is the centred frame of Kleff et al."},
       {"local", "Axes fixed to the tool, parallel to the surface's axes at the start"},
       {"world", "Axes fixed to the world, parallel to the surface's axes at the start"}}};
  return all;
}

const Description& description_of(const Waving* /*of*/) {
  using S = Waving;
  static const Description all =
      Describe<S>("polishing", "Waving",
                  "Oscillation of a surface that is attached to a frame of the robot. At the time"
                  " t after contact, the frame has moved from its placement at the start by the "
                  "translation shift * s and the rotation vector turn * s, with s = sin(2 pi "
                  "frequency t). The amplitude grows smoothly during start_up.")
          .field("shift_world", &S::shift_world,
                 "Amplitude of the translation, [x, y, z] in world axes [{m}]")
          .key("shift")
          .field("turn_world", &S::turn_world,
                 "Amplitude of the rotation vector, [x, y, z] in world axes [{rad}]")
          .key("turn")
          .field("frequency", &S::frequency,
                 "Frequency of the oscillation [{Hz}]",
                 {.least = 0, .open = true})
          .field("start_up", &S::start_up,
                 "Time from contact to the full amplitude [{s}]",
                 {.least = 0, .open = true})
          .field("position", &S::position,
                 "Weight on the position error of the frame that carries the surface [{1/m^2}]",
                 {.least = 0})
          .field("rotation", &S::rotation,
                 "Weight on the rotation error of the frame that carries the surface [{1/rad^2}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const RestingHand* /*of*/) {
  using S = RestingHand;
  static const Description all =
      Describe<S>("polishing", "RestingHand",
                  "Second hand of a standing robot. The hand rests on a plane that is fixed in "
                  "the world. It is in contact from the starting posture on, in all phases.")
          .field("frame", &S::frame,
                 "Frame of the resting hand; its origin is the centre of the round tip (`none`: "
                 "no hand rests)")
          .word("none")
          .field("force", &S::force,
                 "Normal force that the hand rests with [{N}]",
                 {.least = 0, .open = true})
          .field("normal_world", &S::normal_world,
                 "Normal of the plane [x, y, z] in world axes, towards the hand",
                 {.direction = true})
          .more("The normal points out of the material. It need not have unit length.")
          .key("normal")
          .field("radius", &S::radius,
                 "Radius of the round tip of the hand [{m}]",
                 {.least = 0, .open = true})
          .field("friction", &S::friction,
                 "Coulomb friction coefficient of the plane in the plant",
                 {.least = 0})
          .field("plan_friction", &S::plan_friction,
                 "Friction coefficient of the plane that plans assume",
                 {.least = 0, .open = true})
          .field("stiffness", &S::stiffness,
                 "Stiffness of the plane in the plant [{N/m}]",
                 {.least = 0, .open = true})
          .field("weight", &S::weight,
                 "Weight on errors of the normal force of the hand [{1/N^2}]",
                 {.least = 0})
          .more("A hundredth of this weight acts on the tangential force.")
          .field("slip", &S::slip,
                 "Largest distance that the hand may slide on the plane [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("A greater distance is a fault.");
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("polishing", "Weights",
                  "Cost weights. Each cost is integrated over the horizon, with time in s. "
                  "Doubling the weight of a term halves the part of its error that is caused by "
                  "the other terms.")
          .field("force", &S::force,
                 "Weight on errors of the normal force [{1/N^2}]",
                 {.least = 0})
          .field("position", &S::position,
                 "Weight on the tool's distance from the path (automatic: fitted to the arm) "
                 "[{1/m^2}]",
                 {.least = 0})
          .more("The function fit_gains() chooses the automatic weight. In the phase Reach, the "
                "weight is on the distance from a point above the surface.")
          .word("auto")
          .field("approach", &S::approach,
                 "Weight on errors of the tool's normal speed in approach and retreat [{s^2/m^2}]",
                 {.least = 0})
          .field("rotation", &S::rotation,
                 "Weight on the rotation of the tool from its orientation at the start "
                 "[{1/rad^2}]",
                 {.least = 0})
          .more("With a smaller weight the wrist turns more.")
          .field("posture", &S::posture,
                 "Weight on joint angles relative to the starting posture [{1/rad^2}]",
                 {.least = 0})
          .more("A larger weight keeps the elbow in place but costs accuracy.")
          .field("velocity", &S::velocity,
                 "Weight on joint velocities [{s^2/rad^2}]",
                 {.least = 0})
          .more("A larger weight damps more but lets the tool lag on fast paths.")
          .field("torque", &S::torque,
                 "Weight on torques relative to the torques that hold the starting posture "
                 "[{1/Nm^2}]",
                 {.least = 0})
          .field("terminal", &S::terminal,
                 "Duration that multiplies the weights in the terminal cost [{s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const Verdict* /*of*/) {
  using S = Verdict;
  static const Description all =
      Describe<S>("polishing", "Verdict",
                  "Requirements on a run for the outcome \"polished\". They apply to the plant's "
                  "true force and position, from the end of the ramp to the end of the path.")
          .field("contact_share", &S::contact_share,
                 "Smallest allowed time in contact, as a fraction of the whole time",
                 {.least = 0, .most = 1})
          .field("force_rmse", &S::force_rmse,
                 "Allowed rms force error as a fraction of the task's force (`never`: no limit)",
                 {.least = 0, .open = true, .infinite = true})
          .more("The force is averaged over 10 ms. The word `never` stands for infinite. For a "
                "resting hand, the allowed error is this fraction of rest.force.")
          .field("path_share", &S::path_share,
                 "Smallest allowed fraction of the path's length on which the tip is over its "
                 "target",
                 {.least = 0, .most = 1})
          .more("The tip is over its target if its distance to the target along the surface is at"
                " most the tip's radius. For a path without end, the length is the distance that "
                "the tool travels in Task.polish_duration.");
  return all;
}

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("polishing", "Task",
                  "Task of polishing a surface along a path. The members are the keys of a task "
                  "file, with their defaults.")
          .field("robot", &S::robot,
                 "Name, folder or settings file of the robot, optionally followed by `:variant`")
          .field("posture", &S::posture,
                 "Starting posture: a name from the robot's settings, or `search` (find one for "
                 "the surface)")
          .more("The starting posture is also the posture target in the null space. The search is"
                " made by find_posture(). If the name is empty, the robot's default posture is "
                "used; if there is none, a posture is searched. A posture is also searched if the"
                " robot lacks the posture that belongs to a named surface.")
          .field("assume_rotors", &S::assume_rotors,
                 "Add a rotor inertia (armature) of 2 ms * effort / velocity to joints whose "
                 "rotor is missing")
          .more("Effort and velocity are the limits of the joint. The armature is added in plans "
                "and plant. A rotor counts as missing if torque noise alone drives the joint "
                "beyond its speed limit. If assume_rotors is false, a note names the joints "
                "without a rotor.")
          .field("force", &S::force,
                 "Normal force that the tool presses with [{N}]",
                 {.least = 0, .open = true})
          .group("", "tool")
          .field("tool", &S::tool,
                 "Frame of the tool; its origin is the centre of the round tip")
          .key("frame")
          .field("tool_axis", &S::tool_axis,
                 "Pressing direction [x, y, z] in the tool's frame (automatic: away from the arm)",
                 {.direction = true})
          .more("If robot.yaml defines the tool's frame, the automatic direction is the frame's z"
                " or -z axis. Otherwise it is the axis of the last joint; see "
                "pressing_direction(). The vector need not have unit length. In a stated starting"
                " posture, the angle between the pressing direction and the direction into the "
                "surface must be at most search.tilt.")
          .key("axis")
          .word("auto")
          .field("tip_radius", &S::tip_radius,
                 "Radius of the round tip [{m}]",
                 {.least = 0, .open = true})
          .group("The controller knows where the surface is, but not its friction and stiffness.\nThe"
             " name of a surface can replace all keys, and sets posture, normal and point. The "
             "names are\ntable, board, board_x, board_y, board_minus_y and tilt_45.", "surface")
          .field("surface_frame", &S::surface_frame,
                 "Frame that carries the surface: world, or a frame of the robot such as its "
                 "other hand")
          .more("An empty name also means the world. The surface may be a plate in the other "
                "hand. Normal and point of the surface are in the axes of this frame.")
          .key("frame")
          .word("world")
          .field("normal_base", &S::normal_base,
                 "Normal of the surface [x, y, z], towards the robot",
                 {.direction = true})
          .more("The normal is in the axes of `surface_frame`, and points out of the material. It"
                " need not have unit length.")
          .key("normal")
          .field("point_base", &S::point_base,
                 "Position [x, y, z] of any point on the surface (under_tool: `clearance` below "
                 "the tool) [{m}]")
          .more("The position is in the frame `surface_frame`. With `under_tool`, the point is "
                "below the tool's position at the start.")
          .key("point")
          .word("under_tool")
          .field("extent", &S::extent,
                 "Width of the surface beyond the path on all four sides (`endless`: no edges) "
                 "[{m}]",
                 {.least = 0, .infinite = true})
          .more("The surface is a square about the path's origin. Its half side is the largest "
                "distance of the path from its origin, plus `extent`. The word `endless` stands "
                "for infinite; the surface is then a whole plane.")
          .word("endless")
          .field("friction", &S::friction,
                 "Coulomb friction coefficient, unless disturbances.surface_friction states "
                 "another one",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "Stiffness of the surface in the plant [{N/m}]",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "Damping of the surface in the plant [{Ns/m}]",
                 {.least = 0})
          .field("shape", &S::shape,
                 "Shape of the surface: a plane, or a curved shape about `point`.\nThe path is "
                 "projected onto the surface along the normal at `point`.")
          .field("waving", &S::waving,
                 "Oscillation of the surface, if a frame of the robot carries it.")
          .field("search", &S::search,
                 "Requirements on a starting posture that is found by a search.")
          .field("home", &S::home,
                 "Posture in which a run begins, if it differs from the starting posture of the "
                 "task.\nThe joints first move straight to the starting posture, in a phase "
                 "`home`.")
          .field("standing", &S::standing,
                 "Feet and ground of a robot with a floating base.")
          .field("rest", &S::rest,
                 "Second hand of a standing robot, which rests on a fixed plane in all "
                 "phases.\nThe plane touches the hand in the starting posture.")
          .field("path", &S::path,
                 "Path in the plane of the surface. The path begins at rest at the point below "
                 "the tool's position at the start.")
          .field("force_profile", &S::force_profile,
                 "Target force as a function of the time on the path. Before the path, the force "
                 "rises to `force`.")
          .group("Reach above the surface, approach until contact, ramp the force, polish, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "Distance between tool and surface at the end of the phase Reach [{m}]",
                 {.least = 0, .open = true})
          .field("reach_duration", &S::reach_duration,
                 "Duration of the phase Reach [{s}]",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "Speed towards the surface [{m/s}]",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "Pressing force of the tool right after contact [{N}]",
                 {.least = 0})
          .more("This force keeps the tool from rebounding. The ramp starts at this force.")
          .field("ramp_duration", &S::ramp_duration,
                 "Duration of the ramp from touch_force to force [{s}]",
                 {.least = 0, .open = true})
          .field("polish_duration", &S::polish_duration,
                 "Time on the path [{s}]",
                 {.least = 0, .open = true})
          .field("retreat_duration", &S::retreat_duration,
                 "Duration of the retreat from the surface to the distance `clearance` [{s}]",
                 {.least = 0, .open = true})
          .field("verdict", &S::verdict,
                 "Requirements for the outcome \"polished\".\nThey apply to the plant's true "
                 "force and position, from the end of the ramp to the end of the path.")
          .group("Optimal control problem that is solved at every update, and the control loop around"
             " it.", "controller")
          .field("horizon", &S::horizon,
                 "Duration that a plan covers [{s}]",
                 {.least = 0, .open = true})
          .field("step", &S::step,
                 "Time between the first two knots of the plan [{s}]",
                 {.least = 0, .open = true})
          .field("knots", &S::knots,
                 "Number of knots in the plan (0: one knot per `step`)",
                 {.least = 0})
          .more("The steps between knots grow to cover the horizon. With 0, all steps are equal.")
          .field("update_rate", &S::update_rate,
                 "Rate of new plans, tick_rate divided by an integer [{Hz}]",
                 {.least = 0, .open = true})
          .field("tick_rate", &S::tick_rate,
                 "Rate of torque commands [{Hz}]",
                 {.least = 0, .open = true})
          .field("timing", &S::timing,
                 "Rule for when a new plan is used: `fixed` (after solver_delay), `measured` "
                 "(after its computing time) or `thread`")
          .more("With `measured`, a simulation delays the plan by its computing time. With "
                "`thread`, a separate thread computes plans, and a plan is used as soon as it is "
                "ready.")
          .field("solver_delay", &S::solver_delay,
                 "Time from a measurement to the use of the plan computed from the measurement "
                 "[{s}]",
                 {.least = 0})
          .field("command_delay", &S::command_delay,
                 "Assumed delay from a torque command to the torque in the joint [{s}]",
                 {.least = 0, .most = 0.1})
          .more("The delay is rounded to ticks. Plans and feedback start from a state that is "
                "predicted from the torques already sent.")
          .field("measurement_delay", &S::measurement_delay,
                 "Assumed delay from a measurement to the tick that receives it [{s}]",
                 {.least = 0, .most = 0.1})
          .field("slowdown", &S::slowdown,
                 "Factor on the measured computing time of plans, if timing is measured",
                 {.least = 0, .open = true})
          .field("iterations", &S::iterations,
                 "Number of solver iterations per plan",
                 {.least = 1})
          .field("solver", &S::solver,
                 "Type of the solver's step: multiple_shooting or rollout")
          .field("feedback", &S::feedback,
                 "Apply the plan's Riccati feedback between plans; false: apply only the plan's "
                 "torques")
          .field("contact_kd", &S::contact_kd,
                 "Damping of the contact constraint (Baumgarte) [{1/s}]",
                 {.least = 0})
          .field("friction_speed", &S::friction_speed,
                 "Sliding speed below which friction fades to zero in plans [{m/s}]",
                 {.least = 0, .open = true})
          .more("If the steps of plans are 10 ms, the value must be at least 0.1 m/s.")
          .field("torque_cutoff", &S::torque_cutoff,
                 "Cutoff of the torque lag in plans (0: no lag) [{rad/s}]",
                 {.least = 0})
          .more("The key disturbances.torque_cutoff sets the lag of the plant.")
          .field("force_sensor", &S::force_sensor,
                 "Use the force sensor; false: estimate the force from torques and joint motion")
          .more("The estimated force is relative to its value in free air just before contact.")
          .field("axes", &S::axes,
                 "Axes of contact and force: `surface`, `local` (fixed to the tool) or `world`")
          .field("weights", &S::weights,
                 "Cost weights; each cost is integrated over the horizon, with time in s. Only "
                 "ratios of weights matter.\nA larger weight reduces the error of its own term "
                 "and increases the errors of the other terms.")
          .field("constraints", &S::constraints,
                 "Hard constraints of plans; `never` switches a constraint off.")
          .field("model_error", &S::model_error,
                 "Estimation of model errors from measurements. Each plan includes the estimate.")
          .field("surface_estimate", &S::surface_estimate,
                 "Estimation of the surface from the motion of the tip. Plans use the estimate "
                 "only if `axes` is `surface`.")
          .field("friction_estimate", &S::friction_estimate,
                 "Friction coefficient between tool and surface that plans assume, and its "
                 "estimation.")
          .group("Exceeding a limit ends the run and is reported as a fault.\nThe fallback controller"
             " then brakes and holds the robot. `never` switches a limit off.", "limits")
          .field("limits", &S::limits)
          .field("tool_limits", &S::tool_limits)
          .key("limits")
          .field("contact_threshold", &S::contact_threshold,
                 "Normal force above which the tool counts as in contact [{N}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The noise of the force is measured in free air. If six standard deviations of "
                "the noise exceed the threshold, the force is averaged over 5 ms. For contact, "
                "the average must then exceed the threshold, and also six standard deviations of "
                "the noise that is left after averaging.")
          .group("")
          .field("fallback", &S::fallback,
                 "Controller after a fault: gravity compensation, a damper, and a spring of "
                 "limited torque.")
          .field("baseline", &S::baseline,
                 "Gains of the controller `baseline`, an impedance with force feedback.")
          .field("admittance", &S::admittance,
                 "Gains of the controller `admittance`: force loop, inverse kinematics and joint "
                 "position loop.")
          .field("disturbances", &S::disturbances,
                 "Disturbances that the controller does not know.\nIn a task file, one of the "
                 "words none, sensors, mismatch and joint_friction can replace all keys.\nWith "
                 "the key `preset` and one of these words, only keys that differ from the preset "
                 "are needed.");
  return all;
}

const Description& description_of(const NamedSurface* /*of*/) {
  using S = NamedSurface;
  static const Description all =
      Describe<S>("polishing", "NamedSurface",
                  "Named surface: its normal, and a starting posture of the robot that suits the "
                  "surface.")
          .result()
          .field("name", &S::name,
                 "Name of the surface")
          .field("posture", &S::posture,
                 "Name of a posture in the robot's settings")
          .field("normal_world", &S::normal_world,
                 "Normal of the surface in the world; points out of the material");
  return all;
}

}  // namespace burnish::polishing
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
