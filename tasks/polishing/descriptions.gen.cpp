// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "polishing/descriptions.hpp"
#include "polishing/run_descriptions.hpp"

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
          .more("Before the first point, kind steps uses the task's force. Kind lines "
                "interpolates from the task's force at time 0.")
          .field("amplitude", &S::amplitude,
                 "Amplitude of the sine about the force of the task [{N}]",
                 {.least = 0})
          .field("frequency", &S::frequency,
                 "Frequency of the sine [{Hz}]",
                 {.least = 0, .open = true})
          .field("start", &S::start,
                 "Time on the path when the sine begins [{s}]",
                 {.least = 0})
          .more("Until then the force is constant.")
          .field("preview", &S::preview,
                 "Plans know the future target force; false: plans assume that the present target"
                 " force stays");
  return all;
}

const Words& words_of(ForceProfile::Kind /*of*/) {
  static const Words all{
      "polishing",
      "ForceProfileKind",
      "Shape of the target force over the time on the path.",
      {{"constant"},
       {"steps", "Jump to the force of a point at the time of that point"},
       {"lines", "Straight lines between points"},
       {"sine", "Sine about the force of the task"}}};
  return all;
}

const Description& description_of(const RequiredMargins* /*of*/) {
  using S = RequiredMargins;
  static const Description all =
      Describe<S>("polishing", "RequiredMargins",
                  "Stability margins that fit_gains() requires, in addition to the delays and "
                  "filters of the loop.")
          .field("delay", &S::delay,
                 "Delay of the commands that the loop must tolerate [{s}]",
                 {.least = 0})
          .field("gain", &S::gain,
                 "Factor on the torque of any single joint that the loop must tolerate",
                 {.least = 0, .open = true})
          .more("The loop must also tolerate the inverse of the factor.");
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
                 "Time until the circle has its full radius, or the spiral its full growth rate "
                 "[{s}]",
                 {.least = 0, .open = true})
          .field("pitch", &S::pitch,
                 "Mean distance between two turns of the spiral [{m}]",
                 {.least = 0, .open = true})
          .more("The mean is taken from the centre to the largest radius.")
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
                 "Points [[u, w], ...] along the tangents [{m}], or a CSV file with columns u and"
                 " w")
          .in_code("Points (u, w) along the two tangents [m]")
          .more("Straight lines lead from the centre through the points. The path comes to rest "
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
       {"admittance", "Admittance from force error to targets of joint positions (make_admittance_controller())"}}};
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
                 "Plant to simulate; MuJoCo if this build has it")
          .field("check_reach", &S::check_reach,
                 "Check the reach before the run, and throw Error if there is a problem")
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
                 "Position of the tool in contact at the path's origin, in the world [{m}]")
          .required()
          .field("reach_end", &S::reach_end,
                 "Schedule time at the end of the reach [{s}]")
          .field("touch", &S::touch,
                 "Schedule time of the planned contact [{s}]")
          .field("ramp_end", &S::ramp_end,
                 "Schedule time when the ramp ends and the path begins [{s}]")
          .field("track_end", &S::track_end,
                 "Schedule time at the end of the path [{s}]")
          .field("assumed_rotors", &S::assumed_rotors,
                 "Armature that Task.assume_rotors added to each joint, by joint name [{kg m^2 "
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
                  "Oscillation of a surface that is attached to a frame of the robot. The frame "
                  "moves from its placement at the start by the translation shift * s and the "
                  "rotation vector turn * s. Here s = sin(2 pi frequency t), where t is the time "
                  "since contact. The amplitude grows smoothly during start_up.")
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
                 "Weight on the distance of the frame's origin from its target [{1/m^2}]",
                 {.least = 0})
          .field("rotation", &S::rotation,
                 "Weight on the angle between the frame and its target [{1/rad^2}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("polishing", "Weights",
                  "Cost weights, per second of horizon. If the weight of a term is doubled, the "
                  "other terms cause half the error in that term.")
          .field("force", &S::force,
                 "Weight on errors of the normal force [{1/N^2}]",
                 {.least = 0})
          .field("position", &S::position,
                 "Weight on the tool's distance from the path (auto: fitted to the arm) [{1/m^2}]",
                 {.least = 0})
          .in_code("Weight on the tool's distance from the path (none: fitted to the arm) [1/m^2]")
          .more("fit_gains() fits the weight. During the reach, the target is the point above the"
                " surface.")
          .word("auto")
          .field("approach", &S::approach,
                 "Weight on errors of the tool's normal speed in approach and retreat [{s^2/m^2}]",
                 {.least = 0})
          .field("rotation", &S::rotation,
                 "Weight on the tool's orientation relative to the start [{1/rad^2}]",
                 {.least = 0})
          .more("With a smaller weight the wrist turns more.")
          .field("posture", &S::posture,
                 "Weight on joint angles relative to the start [{1/rad^2}]",
                 {.least = 0})
          .more("A larger weight keeps the elbow in place but costs accuracy.")
          .field("velocity", &S::velocity,
                 "Weight on joint velocities [{s^2/rad^2}]",
                 {.least = 0})
          .more("A larger weight damps more but lets the tool lag on fast paths.")
          .field("torque", &S::torque,
                 "Weight on torques relative to the torques that hold the start [{1/Nm^2}]",
                 {.least = 0})
          .field("terminal", &S::terminal,
                 "Duration by which the weights are multiplied for the terminal cost [{s}]",
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
                 "Smallest allowed fraction of the time in contact",
                 {.least = 0, .most = 1})
          .field("force_rmse", &S::force_rmse,
                 "Largest allowed rms error of the force, as a fraction of the task's force; or "
                 "never",
                 {.least = 0, .open = true, .infinite = true})
          .in_code("Largest allowed rms error of the force, as a fraction of the task's force")
          .more("The force is averaged over 10 ms. The value never (infinite) allows any error.")
          .field("path_share", &S::path_share,
                 "Smallest allowed fraction of the path's length on which the tip is over its "
                 "target",
                 {.least = 0, .most = 1})
          .more("The tip is over its target if their distance along the surface is at most the "
                "tip's radius. The length of a path without end is the length that the tool "
                "travels in Task.polish_duration.");
  return all;
}

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("polishing", "Task",
                  "Task of polishing a surface along a path: all keys of a task file, with their "
                  "defaults.")
          .field("robot", &S::robot,
                 "Name, folder or settings file of the robot, optionally with :variant")
          .field("posture", &S::posture,
                 "Starting posture, also the target of the null space (search: find one for the "
                 "surface)")
          .more("The value is a posture's name in the robot's settings, or search, which calls "
                "find_posture(). If empty: the robot's default posture, or a search if the robot "
                "has none. If the robot does not have the posture of a named surface, that "
                "posture is searched, too.")
          .field("assume_rotors", &S::assume_rotors,
                 "Add an armature of 2 ms * effort / velocity to joints whose rotor is missing")
          .more("Effort and velocity are the limits of the joint. The armature is added in plans "
                "and plant. A rotor counts as missing if torque noise alone drives the joint "
                "beyond its speed limit. If false, a note names these joints.")
          .field("force", &S::force,
                 "Normal force that the tool presses with [{N}]",
                 {.least = 0, .open = true})
          .group("", "tool")
          .field("tool", &S::tool,
                 "Frame of the tool; its origin is the centre of the round tip")
          .key("frame")
          .field("tool_axis", &S::tool_axis,
                 "Pressing direction [x, y, z] in the tool's frame (auto: away from the arm)",
                 {.direction = true})
          .in_code("Pressing direction in the tool's frame (none: away from the arm)")
          .more("The automatic direction is z or -z of a frame from robot.yaml, else the axis of "
                "the last joint; see pressing_direction(). The vector need not have unit length. "
                "A stated starting posture must agree with the direction within search.tilt.")
          .key("axis")
          .word("auto")
          .field("tip_radius", &S::tip_radius,
                 "Radius of the round tip [{m}]",
                 {.least = 0, .open = true})
          .group("The controller knows where the surface is, but not its friction and stiffness.\nOne"
             " word can replace all keys and set posture, normal and point:\ntable, board, "
             "board_x, board_y, board_minus_y, tilt_45.", "surface")
          .field("surface_frame", &S::surface_frame,
                 "Frame of the robot that carries the surface, such as its other hand; or world")
          .in_code("Frame of the robot that carries the surface, such as its other hand; empty: "
                   "the world")
          .more("The surface may be a plate in that hand. Normal and point of the surface are in "
                "the axes of this frame.")
          .key("frame")
          .word("world")
          .field("normal_world", &S::normal_world,
                 "Normal of the surface [x, y, z], towards the robot",
                 {.direction = true})
          .more("The normal is in the axes of the frame that carries the surface; without such a "
                "frame, in world axes. It points out of the material and need not have unit "
                "length.")
          .key("normal")
          .field("point_world", &S::point_world,
                 "Position [x, y, z] of any point on the surface [{m}]; or under_tool: "
                 "`clearance` below the tool")
          .in_code("Position of any point on the surface [m]; none: `clearance` below the tool at"
                   " the start")
          .more("The position is in the axes of the frame that carries the surface; without such "
                "a frame, in world axes. The value under_tool refers to the tool at the start.")
          .key("point")
          .word("under_tool")
          .field("extent", &S::extent,
                 "Width of the surface beyond the path on all four sides (or endless) [{m}]",
                 {.least = 0, .infinite = true})
          .in_code("Width of the surface beyond the path on all four sides [m]")
          .more("The surface is a square about the path's origin. The value endless (infinite) "
                "makes it a whole plane.")
          .word("endless")
          .field("friction", &S::friction,
                 "Coulomb friction coefficient (replaced by disturbances.surface_friction if "
                 "stated)",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "Stiffness of the surface in the plant [{N/m}]",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "Damping of the surface in the plant [{Ns/m}]",
                 {.least = 0})
          .field("shape", &S::shape,
                 "Shape of the surface: a plane, or a curved shape about its point.\nThe path is "
                 "projected onto the surface along the normal at that point.")
          .field("waving", &S::waving,
                 "Oscillation of the frame that carries the surface, if it is a frame of the "
                 "robot.")
          .field("search", &S::search,
                 "Requirements on a starting posture that is found by a search.")
          .field("home", &S::home,
                 "Posture where a run begins, if it differs from the start of the task.\nFrom "
                 "there the joints move straight to the start, in a phase `home`.")
          .field("standing", &S::standing,
                 "Feet and ground of a robot with a floating base.")
          .field("path", &S::path,
                 "Path in the plane of the surface. The path begins at rest at the point under "
                 "the start.")
          .field("force_profile", &S::force_profile,
                 "Target force as a function of the time on the path. Before the path, the force "
                 "rises to `force`.")
          .group("Reach above the surface, approach until contact, ramp the force, polish, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "Distance between tool and surface at the end of the reach [{m}]",
                 {.least = 0, .open = true})
          .field("reach_duration", &S::reach_duration,
                 "Duration of the reach [{s}]",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "Speed towards the surface [{m/s}]",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "Force that the tool presses with as soon as contact is made [{N}]",
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
                 "Number of knots in the plan (0: one every `step`)",
                 {.least = 0})
          .more("The steps between knots grow to cover the horizon. With 0, all steps are equal.")
          .field("update_rate", &S::update_rate,
                 "Rate of new plans, tick_rate divided by an integer [{Hz}]",
                 {.least = 0, .open = true})
          .field("tick_rate", &S::tick_rate,
                 "Rate of torque commands [{Hz}]",
                 {.least = 0, .open = true})
          .field("timing", &S::timing,
                 "When a new plan is used: fixed (after solver_delay), measured (after its "
                 "computing time) or thread")
          .more("With measured, simulations delay the plan by its computing time, too. With "
                "thread, a separate thread computes plans, and a plan is used as soon as it is "
                "ready.")
          .field("solver_delay", &S::solver_delay,
                 "Time from a measurement to the use of the plan that starts from it [{s}]",
                 {.least = 0})
          .field("command_delay", &S::command_delay,
                 "Assumed delay from a command to its torque [{s}]",
                 {.least = 0, .most = 0.1})
          .more("The delay is rounded to ticks. Plans and feedback start from the state that the "
                "torques already sent lead to.")
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
          .more("Plans with steps of 10 ms do not tolerate a smaller value than 0.1 m/s.")
          .field("torque_cutoff", &S::torque_cutoff,
                 "Cutoff of the torque lag in plans (0: no lag) [{rad/s}]",
                 {.least = 0})
          .more("The lag of the plant is a key of disturbances.")
          .field("force_sensor", &S::force_sensor,
                 "Use the force sensor; false: estimate the force from torques and joint motion")
          .more("The estimate is relative to the estimate in free air just before contact.")
          .field("axes", &S::axes,
                 "Axes of contact and force: surface, local (fixed to the tool) or world")
          .field("weights", &S::weights,
                 "Cost weights, per second of horizon. Only their ratios matter.\nA larger weight"
                 " reduces the error of its own term and increases the errors of the other terms.")
          .field("constraints", &S::constraints,
                 "Hard constraints of plans; `never` switches a constraint off.")
          .field("model_error", &S::model_error,
                 "Estimation of model errors from measurements. Each plan includes the estimate.")
          .field("surface_estimate", &S::surface_estimate,
                 "Estimation of the surface from the path of the tip. Plans use the estimate only"
                 " if `axes` is surface.")
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
                "the noise exceed the threshold, the mean force over 5 ms is used. Contact then "
                "requires that the mean exceeds both the threshold and six standard deviations of"
                " the mean.")
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
                 "Disturbances that the controller does not know.\nOne word can replace all keys:"
                 " none, sensors, mismatch or joint_friction.\nWith the key `preset` and one of "
                 "these words, only keys that differ from the preset are needed.")
          .in_code("Disturbances that the controller does not know");
  return all;
}

const Description& description_of(const NamedSurface* /*of*/) {
  using S = NamedSurface;
  static const Description all =
      Describe<S>("polishing", "NamedSurface",
                  "Surface with a name, its normal, and a starting posture of the robot that fits"
                  " it.")
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
