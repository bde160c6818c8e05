#include "polishing/descriptions.hpp"

#include "mpc/descriptions.hpp"
#include "pressing/descriptions.hpp"
#include "sim/descriptions.hpp"
#include "solver/descriptions.hpp"

namespace burnish::polishing {

const Words& words_of(PathKind /*of*/) {
  static const Words all{"polishing",
                         "PathKind",
                         "Shapes of paths.",
                         {{"circle"}, {"spiral"}, {"zigzag"}, {"points"}}};
  return all;
}

const Words& words_of(ForceAxes /*of*/) {
  static const Words all{
      "polishing",
      "ForceAxes",
      "Axes that the contact and its force are written in.",
      {{"surface",
        "the surface's own: x, y along it, z out of it (the paper's centred frame where the "
        "surface "
        "is aligned with the world)"},
       {"local", "the tool's: its axis that is closest to the normal at the start"},
       {"world", "the world's: those of the surface at the start, which stay where they are"}}};
  return all;
}

const Words& words_of(ForceProfile::Kind /*of*/) {
  static const Words all{"polishing",
                         "ForceProfileKind",
                         "What the wanted force does from when the path begins.",
                         {{"constant"},
                          {"steps", "from one point's force to the next one's at once"},
                          {"lines", "straight between points"},
                          {"sine", "about the task's force"}}};
  return all;
}

const Description& description_of(const ForceProfile* /*of*/) {
  using F = ForceProfile;
  static const Description all =
      Describe<F>("polishing", "ForceProfile",
                  "What the wanted force does from when the path begins.")
          .field("kind", &F::kind, "constant, steps, lines or sine")
          .field("points", &F::points,
                 "[[s since the path began, N], ...] (steps: the force from then on; lines: joined "
                 "by straight lines)")
          .more(
              "before the first one it is the task's force that holds, from which the first line "
              "leads")
          .field("amplitude", &F::amplitude, "{N}, about the task's force (sine)",
                 range::not_negative)
          .field("frequency", &F::frequency, "{Hz} (sine)", range::positive)
          .field("start", &F::start,
                 "{s} since the path began, until which the force is constant (sine)",
                 range::not_negative)
          .field("preview", &F::preview,
                 "plans know the force that is to come; false: they take that of now for all that "
                 "is ahead");
  return all;
}

const Description& description_of(const PathSpec* /*of*/) {
  using P = PathSpec;
  constexpr Range positive = range::positive;
  static const Description all =
      Describe<P>(
          "polishing", "PathSpec",
          "A path in the plane of a surface, in its two tangents (u, w), from its centre at "
          "rest.")
          .field("kind", &P::kind, "circle, spiral, zigzag or points")
          .field("radius", &P::radius, "{m} (circle, and the largest of a spiral)", positive)
          .field("rate", &P::rate, "{rad/s} (circle, spiral)")
          .field("start_up", &P::start_up,
                 "{s} until the full radius (circle), the full growth (spiral)", positive)
          .field("pitch", &P::pitch, "{m} between two turns (spiral)", positive)
          .more("mean over the way out")
          .field("width", &P::width, "{m} along the first tangent (zigzag)", positive)
          .field("height", &P::height, "{m} along the second tangent (zigzag)", positive)
          .field("rows", &P::rows, "lines (zigzag)", range::from(2))
          .field("speed", &P::speed, "{m/s}, the highest along a line (zigzag, points)", positive)
          .field("points", &P::points,
                 "[[u, w], ...] in the surface's tangents, {m}, or a CSV file with columns u and w "
                 "(points)")
          .in_code(
              "in the surface's tangents, m (points); followed by lines from the centre, at rest "
              "at each");
  return all;
}

const Description& description_of(const PlanarPoint* /*of*/) {
  using P = PlanarPoint;
  static const Description all =
      Describe<P>("polishing", "PlanarPoint",
                  "(u, w) of a path and their first two derivatives at a time.")
          .field("p", &P::p, "{m}")
          .field("v", &P::v, "{m/s}")
          .field("a", &P::a, "{m/s^2}");
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using W = Weights;
  constexpr Range weight = range::not_negative;
  static const Description all =
      Describe<W>(
          "polishing", "Weights",
          "Cost weights, per second of horizon. Each is (what it buys): doubling it halves the "
          "error that the others force on its term.")
          .field("force", &W::force, "{1/N^2}: force along the normal to its target", weight)
          .field("position", &W::position,
                 "{1/m^2}: tool to the path, in the reach to the point above the surface; auto: "
                 "fitted to the arm",
                 weight)
          .in_code(
              "1/m^2: tool to the path, in the reach to the point above the surface; none: fitted "
              "to the arm, see fit_gains()")
          .word("auto")
          .field("approach", &W::approach,
                 "{s^2/m^2}: speed along the normal to that of approach and retreat", weight)
          .field("rotation", &W::rotation,
                 "{1/rad^2}: tool to its orientation at the start; less lets the wrist follow",
                 weight)
          .field("posture", &W::posture,
                 "{1/rad^2}: joints to the start; more holds the elbow, costs path accuracy",
                 weight)
          .field("velocity", &W::velocity,
                 "{s^2/rad^2}: joint speeds; more damps, and lags on fast paths", weight)
          .field("torque", &W::torque, "{1/Nm^2}: torques to those that hold the start", weight)
          .field("terminal", &W::terminal,
                 "{s}: what the end of the horizon costs, as a time at its running cost", weight);
  return all;
}

const Description& description_of(const Waving* /*of*/) {
  using W = Waving;
  constexpr Range weight = range::not_negative;
  static const Description all =
      Describe<W>("polishing", "Waving",
                  "How the robot itself moves the frame that carries the surface: from where it "
                  "starts by shift * s and turn * s (a rotation vector), s = sin(2 pi frequency t) "
                  "from contact on.")
          .field("shift_world", &W::shift_world, "[x, y, z] {m}, world")
          .key("shift")
          .field("turn_world", &W::turn_world, "[x, y, z] {rad}, world")
          .key("turn")
          .field("frequency", &W::frequency, "{Hz}", range::positive)
          .field("start_up", &W::start_up, "{s} until the full way", range::positive)
          .field("position", &W::position, "{1/m^2}: the frame's origin to where it shall be",
                 weight)
          .field("rotation", &W::rotation, "{1/rad^2}: the frame's axes to what they shall be",
                 weight);
  return all;
}

const Description& description_of(const Verdict* /*of*/) {
  using V = Verdict;
  static const Description all =
      Describe<V>(
          "polishing", "Verdict",
          "What \"polished\" asks for, of the plant's true force and place, from the end of "
          "the ramp to the end of the path.")
          .field("contact_share", &V::contact_share, "of the time in contact, at least; 0 to 1",
                 range::share)
          .field("force_rmse", &V::force_rmse,
                 "of the force: rms error of its mean over 10 ms, at most; or never",
                 range::positive_or_infinite)
          .in_code("of the force: rms error of its mean over 10 ms, at most; infinite: any")
          .field("path_share", &V::path_share,
                 "of the path's length with the tip over its target, at least; 0 to 1",
                 range::share)
          .more(
              "Nearer to it than the tip's radius. A path without end is as long as "
              "Task::polish_duration makes it.");
  return all;
}

namespace {

using T = Task;

/// Where: the robot, its tool, the surface, the path.
// NOLINTNEXTLINE(readability-function-size): a table
Describe<T>& describe_place(Describe<T>& task) {
  constexpr Range positive = range::positive;
  task.field("robot", &T::robot, "a robot's name, folder or settings file, with :variant")
      .field("posture", &T::posture,
             "start of the arm, what its null space is drawn to; search: found for the surface")
      .more(
          "Of the robot's settings, or find_posture()'s. Empty: the robot's default, or searched "
          "where it has none. So is a named surface's, where the robot has none of that name.")
      .field("assume_rotors", &T::assume_rotors,
             "joints whose rotor is missing get an armature of 2 ms * effort / velocity")
      .more(
          "In plans and plant. Missing: torque noise alone drives the joint past its speed limit; "
          "without this a note names it.")
      .field("force", &T::force, "{N}, that the tool presses with", positive);
  pressing::describe_tool(task)
      .group(
          "Or one word for posture, normal and point: table, board, board_x, board_y, "
          "board_minus_y,\ntilt_45. The controller knows where it is; it knows nothing of friction "
          "and stiffness.",
          "surface")
      .field("surface_frame", &T::surface_frame,
             "of the robot, that carries the surface, such as a plate in the other hand, in whose "
             "axes normal and point are then; or world")
      .in_code(
          "of the robot, that carries the surface, such as a plate in the other hand; empty: the "
          "world")
      .key("frame")
      .word("world")
      .field("normal_world", &T::normal_world,
             "[x, y, z] out of the material towards the robot, any length, world", range::direction)
      .in_code("out of the surface, any length; in the axes of the frame that carries it")
      .key("normal")
      .field("point_world", &T::point_world,
             "[x, y, z] of any point on it, {m}; or under_tool: clearance below the start")
      .in_code(
          "a point of the surface, m, alike; without it `clearance` under the tool at the start")
      .key("point")
      .word("under_tool")
      .field("extent", &T::extent,
             "{m} that there is surface beyond the path, on all four sides; or endless",
             range::not_negative_or_infinite)
      .in_code(
          "m that there is surface beyond the path, on all four sides of a square about the "
          "path's origin; infinite: it has no end")
      .word("endless");
  return pressing::describe_material(task)
      .field("shape", &T::shape,
             "What the surface is about its point. The path is drawn on it as seen along the "
             "normal there.")
      .in_code("plane, or what the surface is about its point")
      .field("waving", &T::waving,
             "How the robot moves the frame that carries the surface, where one does.")
      .in_code("of that frame")
      .field("search", &T::search, "What a posture that is searched keeps to.")
      .field("home", &T::home,
             "Where a run begins, if not at its start: a posture, from which the joints move "
             "straight to the start\nin a phase `home`.")
      .in_code("where a run begins, if not at the start of the arm")
      .field("standing", &T::standing, "What a robot whose base floats stands on.")
      .field("path", &T::path,
             "In the plane of the surface, from the point under the start, beginning at rest.")
      .field("force_profile", &T::force_profile,
             "What the force does from when the path begins; until then it rises to `force`.");
}

/// When, and what it is to come to.
Describe<T>& describe_phases(Describe<T>& task) {
  constexpr Range positive = range::positive;
  return task
      .group("Reach above the surface, approach until contact, ramp the force, polish, retreat.",
             "phases")
      .field("clearance", &T::clearance, "{m} between tool and surface where the reach ends",
             positive)
      .field("reach_duration", &T::reach_duration, "{s}", positive)
      .field("approach_speed", &T::approach_speed, "{m/s} towards the surface", positive)
      .field("touch_force", &T::touch_force,
             "{N}, at once where contact is made, so that the tool does not rebound",
             range::not_negative)
      .more("the ramp starts there")
      .field("ramp_duration", &T::ramp_duration, "{s} from contact to the full force", positive)
      .field("polish_duration", &T::polish_duration, "{s} on the path", positive)
      .field("retreat_duration", &T::retreat_duration, "{s} back to the clearance", positive)
      .field("verdict", &T::verdict,
             "What \"polished\" asks for, of the plant's true force and place, from the end of the "
             "ramp on.");
}

/// How: the controller, and what it does not know.
// NOLINTNEXTLINE(readability-function-size): a table
Describe<T>& describe_controller(Describe<T>& task) {
  constexpr Range positive = range::positive;
  task.group("The optimal control problem that is solved again and again, and the loop around it.",
             "controller")
      .field("horizon", &T::horizon, "{s} that are planned ahead", positive)
      .field("step", &T::step, "{s} between two knots of the plan", positive)
      .field("knots", &T::knots,
             "of the plan: their steps grow from the first one, so that few look as far ahead; 0: "
             "all are alike",
             range::from(0))
      .field("update_rate", &T::update_rate, "{Hz}, of new plans; divides the tick rate", positive)
      .field("tick_rate", &T::tick_rate, "{Hz}, of torque commands", positive)
      .field(
          "timing", &T::timing,
          "fixed: plans are used solver_delay after their measurement; measured: the time that "
          "each takes passes, in simulations too; thread: they are made in a thread of their own")
      .field("solver_delay", &T::solver_delay,
             "{s} from a measurement to the use of the plan made from it", range::not_negative);
  pressing::describe_delays(task)
      .field("slowdown", &T::slowdown, "of measured timing: a machine by this factor slower",
             range::positive)
      .field("iterations", &T::iterations, "of the solver, per plan", range::from(1))
      .field("solver", &T::solver, "multiple_shooting or rollout")
      .field("feedback", &T::feedback,
             "between plans follow their Riccati gains, not just their torques")
      .field("contact_kd", &T::contact_kd, "{1/s}, damping of the contact constraint (Baumgarte)",
             range::not_negative)
      .field("friction_speed", &T::friction_speed,
             "{m/s} of sliding below which the friction of plans fades: their steps bear no less",
             range::positive)
      .field("torque_cutoff", &T::torque_cutoff,
             "{rad/s}, torque lag that plans know of; 0: none; the plant's is in disturbances",
             range::not_negative)
      .field("force_sensor", &T::force_sensor,
             "false: the force is told from torques, encoders and velocities, against what they "
             "said in the air just before")
      .field("axes", &T::axes, "of contact and force: surface, local (the tool's) or world")
      .field(
          "weights", &T::weights,
          "Cost per second of squared error. What counts is how they compare: raise one, and its "
          "error\nshrinks at the expense of the others.")
      .field("constraints", &T::constraints,
             "What plans keep, whatever it costs. Each may be never.")
      .field("model_error", &T::model_error,
             "What measurements say that the model gets wrong, given back to it before each plan.")
      .field(
          "surface_estimate", &T::surface_estimate,
          "What the tip's own path says of the surface, given to each plan: not with axes: local.")
      .field("friction_estimate", &T::friction_estimate,
             "The coefficient of friction between tool and surface, given to each plan.");
  pressing::describe_limits(task)
      .group("")
      .field("fallback", &T::fallback,
             "What holds the arm after a fault: gravity compensation, a damper, and a spring that "
             "slips.")
      .field("baseline", &T::baseline,
             "Gains of the controller `baseline`, an impedance with force feedback.")
      .in_code("of the controller `baseline`")
      .field("admittance", &T::admittance,
             "Gains of the controller `admittance`: force error to motion, inverse kinematics, "
             "joint\npositions that are held.")
      .in_code("of the controller `admittance`");
  return pressing::describe_disturbances(task);
}

}  // namespace

const Description& description_of(const Task* /*of*/) {
  static const Description all = [] {
    Describe<T> task("polishing", "Task",
                     "The polishing task: all that a task file may say, with its defaults.");
    describe_place(task);
    describe_phases(task);
    return describe_controller(task);
  }();
  return all;
}

}  // namespace burnish::polishing
