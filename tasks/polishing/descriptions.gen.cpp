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
                  "What the wanted force does from when the path begins.")
          .field("kind", &S::kind,
                 "constant, steps, lines or sine")
          .field("points", &S::points,
                 "[[s since the path began, N], ...] (steps: the force from then on; lines: "
                 "joined by straight lines)")
          .more("before the first one it is the task's force that holds, from which the first "
                "line leads")
          .field("amplitude", &S::amplitude,
                 "{N}, about the task's force (sine)",
                 {.least = 0})
          .field("frequency", &S::frequency,
                 "{Hz} (sine)",
                 {.least = 0, .open = true})
          .field("start", &S::start,
                 "{s} since the path began, until which the force is constant (sine)",
                 {.least = 0})
          .field("preview", &S::preview,
                 "plans know the force that is to come; false: they take that of now for all that"
                 " is ahead");
  return all;
}

const Words& words_of(ForceProfile::Kind /*of*/) {
  static const Words all{
      "polishing",
      "ForceProfileKind",
      "What the wanted force does from when the path begins.",
      {{"constant"},
       {"steps", "from one point's force to the next one's at once"},
       {"lines", "straight between points"},
       {"sine", "about the task's force"}}};
  return all;
}

const Description& description_of(const RequiredMargins* /*of*/) {
  using S = RequiredMargins;
  static const Description all =
      Describe<S>("polishing", "RequiredMargins",
                  "Margins that every arm must have beyond the delays and filters of its loop.")
          .field("delay", &S::delay,
                 "{s}, extra delay of the commands",
                 {.least = 0})
          .field("gain", &S::gain,
                 "factor on one joint's torque; also its inverse",
                 {.least = 0, .open = true});
  return all;
}

const Description& description_of(const TaskMargins* /*of*/) {
  using S = TaskMargins;
  static const Description all =
      Describe<S>("polishing", "TaskMargins",
                  "Stability margins of a polishing task's loop at its starting posture.")
          .result()
          .field("air", &S::air,
                 "in free air")
          .field("contact", &S::contact,
                 "with the tool on the surface");
  return all;
}

const Description& description_of(const FittedGains* /*of*/) {
  using S = FittedGains;
  static const Description all =
      Describe<S>("polishing", "FittedGains",
                  "Result of fit_gains().")
          .result()
          .field("meets", &S::meets,
                 "true if the required margins are met, or cannot be computed")
          .field("changes", &S::changes,
                 "sentence that names the fitted gains; empty if none was fitted");
  return all;
}

const Words& words_of(PathKind /*of*/) {
  static const Words all{
      "polishing",
      "PathKind",
      "Shapes of paths.",
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
                  "A path in the plane of a surface, in its two tangents (u, w), from its centre "
                  "at rest.")
          .field("kind", &S::kind,
                 "circle, spiral, zigzag or points")
          .field("radius", &S::radius,
                 "{m} (circle, and the largest of a spiral)",
                 {.least = 0, .open = true})
          .field("rate", &S::rate,
                 "{rad/s} (circle, spiral)")
          .field("start_up", &S::start_up,
                 "{s} until the full radius (circle), the full growth (spiral)",
                 {.least = 0, .open = true})
          .field("pitch", &S::pitch,
                 "{m} between two turns (spiral)",
                 {.least = 0, .open = true})
          .more("mean over the way out")
          .field("width", &S::width,
                 "{m} along the first tangent (zigzag)",
                 {.least = 0, .open = true})
          .field("height", &S::height,
                 "{m} along the second tangent (zigzag)",
                 {.least = 0, .open = true})
          .field("rows", &S::rows,
                 "lines (zigzag)",
                 {.least = 2})
          .field("speed", &S::speed,
                 "{m/s}, the highest along a line (zigzag, points)",
                 {.least = 0, .open = true})
          .field("points", &S::points,
                 "[[u, w], ...] in the surface's tangents, {m}, or a CSV file with columns u and "
                 "w (points)")
          .in_code("in the surface's tangents, m (points); followed by lines from the centre, at "
                   "rest at each");
  return all;
}

const Description& description_of(const PlanarPoint* /*of*/) {
  using S = PlanarPoint;
  static const Description all =
      Describe<S>("polishing", "PlanarPoint",
                  "(u, w) of a path and their first two derivatives at a time.")
          .field("p", &S::p,
                 "{m}")
          .field("v", &S::v,
                 "{m/s}")
          .field("a", &S::a,
                 "{m/s^2}");
  return all;
}

const Description& description_of(const FreeHome* /*of*/) {
  using S = FreeHome;
  static const Description all =
      Describe<S>("polishing", "FreeHome",
                  "Posture of a robot from which its joints can move straight to a task's start.")
          .result()
          .field("posture", &S::posture,
                 "of the robot's settings")
          .field("duration", &S::duration,
                 "{s}, of the move");
  return all;
}

const Words& words_of(ControllerKind /*of*/) {
  static const Words all{
      "polishing",
      "ControllerKind",
      "What controls a run.",
      {{"mpc", "model predictive control (MpcController)"},
       {"baseline", "impedance with force feedback, no optimisation (make_impedance_controller())"},
       {"admittance", "force error to joint positions that are held (make_admittance_controller())"}}};
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("polishing", "RunSpec",
                  "A run of a task.")
          .field("task", &S::task)
          .field("robot", &S::robot,
                 "in place of the one that the task names")
          .field("controller", &S::controller)
          .field("plant", &S::plant,
                 "MuJoCo where this build has it")
          .field("check_reach", &S::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("reach", &S::reach)
          .field("plan_rate", &S::plan_rate,
                 "{Hz}, at which plans of the MPC are recorded, at most 20 000 of them; 0: none")
          .field("progress", &S::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("polishing", "Setting",
                  "A task with everything resolved: robot, start, surface, path in the world, "
                  "phases.")
          .field("robot", &S::robot)
          .required()
          .field("q_start", &S::q_start,
                 "nq")
          .required()
          .field("scene", &S::scene,
                 "as the controller knows it")
          .required()
          .field("surface_axes", &S::surface_axes,
                 "columns: two tangents and the normal, world")
          .required()
          .field("p_start", &S::p_start,
                 "of the tool, m, world")
          .required()
          .field("p_center", &S::p_center,
                 "of the tool at the path's origin in contact, m, world")
          .required()
          .field("reach_end", &S::reach_end,
                 "{s} of the schedule")
          .field("touch", &S::touch,
                 "{s} of the schedule")
          .field("ramp_end", &S::ramp_end,
                 "{s} of the schedule")
          .field("track_end", &S::track_end,
                 "{s} of the schedule")
          .field("assumed_rotors", &S::assumed_rotors,
                 "kg m^2 (kg) by joint, that Task.assume_rotors added to the robot's armature")
          .field("home", &S::home,
                 "from where a run begins (Task.home) to q_start");
  return all;
}

const Words& words_of(ForceAxes /*of*/) {
  static const Words all{
      "polishing",
      "ForceAxes",
      "Axes that the contact and its force are written in.",
      {{"surface", "the surface's own: x, y along it, z out of it (the paper's centred frame where the "
        "surface is aligned with the world)"},
       {"local", "the tool's: its axis that is closest to the normal at the start"},
       {"world", "the world's: those of the surface at the start, which stay where they are"}}};
  return all;
}

const Description& description_of(const Waving* /*of*/) {
  using S = Waving;
  static const Description all =
      Describe<S>("polishing", "Waving",
                  "How the robot itself moves the frame that carries the surface: from where it "
                  "starts by shift * s and turn * s (a rotation vector), s = sin(2 pi frequency "
                  "t) from contact on.")
          .field("shift_world", &S::shift_world,
                 "[x, y, z] {m}, world")
          .key("shift")
          .field("turn_world", &S::turn_world,
                 "[x, y, z] {rad}, world")
          .key("turn")
          .field("frequency", &S::frequency,
                 "{Hz}",
                 {.least = 0, .open = true})
          .field("start_up", &S::start_up,
                 "{s} until the full way",
                 {.least = 0, .open = true})
          .field("position", &S::position,
                 "{1/m^2}: the frame's origin to where it shall be",
                 {.least = 0})
          .field("rotation", &S::rotation,
                 "{1/rad^2}: the frame's axes to what they shall be",
                 {.least = 0});
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("polishing", "Weights",
                  "Cost weights, per second of horizon. Each is (what it buys): doubling it "
                  "halves the error that the others force on its term.")
          .field("force", &S::force,
                 "{1/N^2}: force along the normal to its target",
                 {.least = 0})
          .field("position", &S::position,
                 "{1/m^2}: tool to the path, in the reach to the point above the surface; auto: "
                 "fitted to the arm",
                 {.least = 0})
          .in_code("1/m^2: tool to the path, in the reach to the point above the surface; none: "
                   "fitted to the arm, see fit_gains()")
          .word("auto")
          .field("approach", &S::approach,
                 "{s^2/m^2}: speed along the normal to that of approach and retreat",
                 {.least = 0})
          .field("rotation", &S::rotation,
                 "{1/rad^2}: tool to its orientation at the start; less lets the wrist follow",
                 {.least = 0})
          .field("posture", &S::posture,
                 "{1/rad^2}: joints to the start; more holds the elbow, costs path accuracy",
                 {.least = 0})
          .field("velocity", &S::velocity,
                 "{s^2/rad^2}: joint speeds; more damps, and lags on fast paths",
                 {.least = 0})
          .field("torque", &S::torque,
                 "{1/Nm^2}: torques to those that hold the start",
                 {.least = 0})
          .field("terminal", &S::terminal,
                 "{s}: what the end of the horizon costs, as a time at its running cost",
                 {.least = 0});
  return all;
}

const Description& description_of(const Verdict* /*of*/) {
  using S = Verdict;
  static const Description all =
      Describe<S>("polishing", "Verdict",
                  "What \"polished\" asks for, of the plant's true force and place, from the end "
                  "of the ramp to the end of the path.")
          .field("contact_share", &S::contact_share,
                 "of the time in contact, at least; 0 to 1",
                 {.least = 0, .most = 1})
          .field("force_rmse", &S::force_rmse,
                 "of the force: rms error of its mean over 10 ms, at most; or never",
                 {.least = 0, .open = true, .infinite = true})
          .in_code("of the force: rms error of its mean over 10 ms, at most; infinite: any")
          .field("path_share", &S::path_share,
                 "of the path's length with the tip over its target, at least; 0 to 1",
                 {.least = 0, .most = 1})
          .more("Nearer to it than the tip's radius. A path without end is as long as "
                "Task::polish_duration makes it.");
  return all;
}

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("polishing", "Task",
                  "The polishing task: all that a task file may say, with its defaults.")
          .field("robot", &S::robot,
                 "a robot's name, folder or settings file, with :variant")
          .field("posture", &S::posture,
                 "start of the arm, what its null space is drawn to; search: found for the "
                 "surface")
          .more("Of the robot's settings, or find_posture()'s. Empty: the robot's default, or "
                "searched where it has none. So is a named surface's, where the robot has none of"
                " that name.")
          .field("assume_rotors", &S::assume_rotors,
                 "joints whose rotor is missing get an armature of 2 ms * effort / velocity")
          .more("In plans and plant. Missing: torque noise alone drives the joint past its speed "
                "limit; without this a note names it.")
          .field("force", &S::force,
                 "{N}, that the tool presses with",
                 {.least = 0, .open = true})
          .group("", "tool")
          .field("tool", &S::tool,
                 "its origin is the centre of a round tip")
          .key("frame")
          .field("tool_axis", &S::tool_axis,
                 "[x, y, z] that it presses along, in its frame; or auto: z or -z of a frame of "
                 "robot.yaml, of others the last joint's axis, away from the arm",
                 {.direction = true})
          .in_code("that the tool presses along, in its frame, any length; without it see "
                   "pressing_direction()")
          .more("a posture that is given must agree with it, within search.tilt")
          .key("axis")
          .word("auto")
          .field("tip_radius", &S::tip_radius,
                 "Radius of the round tip [{m}]",
                 {.least = 0, .open = true})
          .group("Or one word for posture, normal and point: table, board, board_x, board_y, "
             "board_minus_y,\ntilt_45. The controller knows where it is; it knows nothing of "
             "friction and stiffness.", "surface")
          .field("surface_frame", &S::surface_frame,
                 "of the robot, that carries the surface, such as a plate in the other hand, in "
                 "whose axes normal and point are then; or world")
          .in_code("of the robot, that carries the surface, such as a plate in the other hand; "
                   "empty: the world")
          .key("frame")
          .word("world")
          .field("normal_world", &S::normal_world,
                 "[x, y, z] out of the material towards the robot, any length, world",
                 {.direction = true})
          .in_code("out of the surface, any length; in the axes of the frame that carries it")
          .key("normal")
          .field("point_world", &S::point_world,
                 "[x, y, z] of any point on it, {m}; or under_tool: clearance below the start")
          .in_code("a point of the surface, m, alike; without it `clearance` under the tool at "
                   "the start")
          .key("point")
          .word("under_tool")
          .field("extent", &S::extent,
                 "{m} that there is surface beyond the path, on all four sides; or endless",
                 {.least = 0, .infinite = true})
          .in_code("m that there is surface beyond the path, on all four sides of a square about "
                   "the path's origin; infinite: it has no end")
          .word("endless")
          .field("friction", &S::friction,
                 "Coulomb coefficient of the plant, unless disturbances.surface_friction says "
                 "another",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "{N/m}, of the plant",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "{Ns/m}, of the plant",
                 {.least = 0})
          .field("shape", &S::shape,
                 "What the surface is about its point. The path is drawn on it as seen along the "
                 "normal there.")
          .in_code("plane, or what the surface is about its point")
          .field("waving", &S::waving,
                 "How the robot moves the frame that carries the surface, where one does.")
          .in_code("of that frame")
          .field("search", &S::search,
                 "What a posture that is searched keeps to.")
          .field("home", &S::home,
                 "Where a run begins, if not at its start: a posture, from which the joints move "
                 "straight to the start\nin a phase `home`.")
          .in_code("where a run begins, if not at the start of the arm")
          .field("standing", &S::standing,
                 "What a robot whose base floats stands on.")
          .field("path", &S::path,
                 "In the plane of the surface, from the point under the start, beginning at rest.")
          .field("force_profile", &S::force_profile,
                 "What the force does from when the path begins; until then it rises to `force`.")
          .group("Reach above the surface, approach until contact, ramp the force, polish, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "{m} between tool and surface where the reach ends",
                 {.least = 0, .open = true})
          .field("reach_duration", &S::reach_duration,
                 "{s}",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "{m/s} towards the surface",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "{N}, at once where contact is made, so that the tool does not rebound",
                 {.least = 0})
          .more("the ramp starts there")
          .field("ramp_duration", &S::ramp_duration,
                 "{s} from contact to the full force",
                 {.least = 0, .open = true})
          .field("polish_duration", &S::polish_duration,
                 "{s} on the path",
                 {.least = 0, .open = true})
          .field("retreat_duration", &S::retreat_duration,
                 "{s} back to the clearance",
                 {.least = 0, .open = true})
          .field("verdict", &S::verdict,
                 "What \"polished\" asks for, of the plant's true force and place, from the end "
                 "of the ramp on.")
          .group("The optimal control problem that is solved again and again, and the loop around it.", "controller")
          .field("horizon", &S::horizon,
                 "{s} that are planned ahead",
                 {.least = 0, .open = true})
          .field("step", &S::step,
                 "{s} between two knots of the plan",
                 {.least = 0, .open = true})
          .field("knots", &S::knots,
                 "of the plan: their steps grow from the first one, so that few look as far "
                 "ahead; 0: all are alike",
                 {.least = 0})
          .field("update_rate", &S::update_rate,
                 "{Hz}, of new plans; divides the tick rate",
                 {.least = 0, .open = true})
          .field("tick_rate", &S::tick_rate,
                 "{Hz}, of torque commands",
                 {.least = 0, .open = true})
          .field("timing", &S::timing,
                 "fixed: plans are used solver_delay after their measurement; measured: the time "
                 "that each takes passes, in simulations too; thread: they are made in a thread "
                 "of their own")
          .field("solver_delay", &S::solver_delay,
                 "{s} from a measurement to the use of the plan made from it",
                 {.least = 0})
          .field("command_delay", &S::command_delay,
                 "Delay from command to torque that the controller assumes [{s}]",
                 {.least = 0, .most = 0.1})
          .more("Rounded to ticks. Plans and feedback begin in the state that the torques already"
                " sent lead to.")
          .field("measurement_delay", &S::measurement_delay,
                 "Delay from measurement to tick that the controller assumes [{s}]",
                 {.least = 0, .most = 0.1})
          .field("slowdown", &S::slowdown,
                 "of measured timing: a machine by this factor slower",
                 {.least = 0, .open = true})
          .field("iterations", &S::iterations,
                 "of the solver, per plan",
                 {.least = 1})
          .field("solver", &S::solver,
                 "multiple_shooting or rollout")
          .field("feedback", &S::feedback,
                 "between plans follow their Riccati gains, not just their torques")
          .field("contact_kd", &S::contact_kd,
                 "{1/s}, damping of the contact constraint (Baumgarte)",
                 {.least = 0})
          .field("friction_speed", &S::friction_speed,
                 "{m/s} of sliding below which the friction of plans fades: their steps bear no "
                 "less",
                 {.least = 0, .open = true})
          .field("torque_cutoff", &S::torque_cutoff,
                 "{rad/s}, torque lag that plans know of; 0: none; the plant's is in disturbances",
                 {.least = 0})
          .field("force_sensor", &S::force_sensor,
                 "false: the force is told from torques, encoders and velocities, against what "
                 "they said in the air just before")
          .field("axes", &S::axes,
                 "of contact and force: surface, local (the tool's) or world")
          .field("weights", &S::weights,
                 "Cost per second of squared error. What counts is how they compare: raise one, "
                 "and its error\nshrinks at the expense of the others.")
          .field("constraints", &S::constraints,
                 "What plans keep, whatever it costs. Each may be never.")
          .field("model_error", &S::model_error,
                 "What measurements say that the model gets wrong, given back to it before each "
                 "plan.")
          .field("surface_estimate", &S::surface_estimate,
                 "What the tip's own path says of the surface, given to each plan: not with axes:"
                 " local.")
          .field("friction_estimate", &S::friction_estimate,
                 "The coefficient of friction between tool and surface, given to each plan.")
          .group("Beyond these a run is given up: the arm is braked and held (fallback), and there is"
             " a report.\nEach may be never.", "limits")
          .field("limits", &S::limits)
          .field("tool_limits", &S::tool_limits)
          .key("limits")
          .field("contact_threshold", &S::contact_threshold,
                 "{N} that count as contact",
                 {.least = 0, .open = true, .infinite = true})
          .more("Where the sensor's noise comes near it, which is found out in the reach, it is "
                "the mean over 5 ms that counts, against six of its own deviations.")
          .group("")
          .field("fallback", &S::fallback,
                 "What holds the arm after a fault: gravity compensation, a damper, and a spring "
                 "that slips.")
          .field("baseline", &S::baseline,
                 "Gains of the controller `baseline`, an impedance with force feedback.")
          .in_code("of the controller `baseline`")
          .field("admittance", &S::admittance,
                 "Gains of the controller `admittance`: force error to motion, inverse "
                 "kinematics, joint\npositions that are held.")
          .in_code("of the controller `admittance`")
          .field("disturbances", &S::disturbances,
                 "What the controller does not know. Or one word: none, sensors, mismatch, "
                 "joint_friction; or\n`preset: word` and keys that differ from it.")
          .in_code("what the controller does not know");
  return all;
}

const Description& description_of(const NamedSurface* /*of*/) {
  using S = NamedSurface;
  static const Description all =
      Describe<S>("polishing", "NamedSurface",
                  "A surface by name: where its normal points and a starting posture of the robot"
                  " for it.")
          .result()
          .field("name", &S::name)
          .field("posture", &S::posture,
                 "of the robot's settings")
          .field("normal_world", &S::normal_world,
                 "out of the surface");
  return all;
}

}  // namespace burnish::polishing
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
