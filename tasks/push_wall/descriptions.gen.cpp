// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "push_wall/descriptions.hpp"
#include "push_wall/figures.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::push_wall {

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("push_wall", "Weights",
                  "Cost weights. Each cost is integrated over the horizon, with time in s.")
          .field("force", &S::force,
                 "Weight on errors of the normal force of each hand [{1/N^2}]",
                 {.least = 0})
          .field("friction", &S::friction,
                 "Weight on the tangential force of each hand [{1/N^2}]",
                 {.least = 0})
          .field("position", &S::position,
                 "Weight on position errors of the hands while they are not in contact [{1/m^2}]",
                 {.least = 0})
          .more("The weight applies to errors along the wall. Before the approach, the weight "
                "also applies to errors along the wall's normal.")
          .field("approach", &S::approach,
                 "Weight on errors of the normal speed of the hands in approach and retreat "
                 "[{s^2/m^2}]",
                 {.least = 0})
          .field("inclination", &S::inclination,
                 "Weight on the change of each hand's angle to the wall since the start "
                 "[{1/rad^2}]",
                 {.least = 0})
          .more("A tilted hand needs more wrist torque.")
          .field("posture", &S::posture,
                 "Weight on joint angles relative to the starting posture [{1/rad^2}]",
                 {.least = 0})
          .more("A larger weight hinders the body from moving towards the wall.")
          .field("range", &S::range,
                 "Weight on joint angles closer than range_margin to a position limit [{1/rad^2}]",
                 {.least = 0})
          .field("range_margin", &S::range_margin,
                 "Distance from position limits below which the weight `range` acts [{rad (m)}]",
                 {.least = 0})
          .field("velocity", &S::velocity,
                 "Weight on joint velocities [{s^2/rad^2}]",
                 {.least = 0})
          .field("torque", &S::torque,
                 "Weight on torques relative to the torques that hold the starting posture "
                 "[{1/Nm^2}]",
                 {.least = 0})
          .field("terminal", &S::terminal,
                 "Duration that multiplies the weights in the terminal cost [{s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const Wall* /*of*/) {
  using S = Wall;
  static const Description all =
      Describe<S>("push_wall", "Wall",
                  "Plane wall in front of the hands, with its contact parameters in the plant and"
                  " in plans. At the start the distance between the wall and the nearer hand is "
                  "`clearance`.")
          .field("normal_world", &S::normal_world,
                 "Normal of the wall [x, y, z] in world axes, towards the robot",
                 {.direction = true})
          .more("The normal points out of the wall. It need not have unit length.")
          .key("normal")
          .field("friction", &S::friction,
                 "Coulomb friction coefficient of the plant's wall",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "Stiffness of the plant's wall at each hand [{N/m}]",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "Damping of the plant's wall at each hand [{Ns/m}]",
                 {.least = 0, .open = true})
          .field("plan_friction", &S::plan_friction,
                 "Friction coefficient that plans assume for the wall",
                 {.least = 0, .open = true})
          .field("contact_kd", &S::contact_kd,
                 "Baumgarte damping of the contact constraint of the hands in plans [{1/s}]",
                 {.least = 0});
  return all;
}

const Description& description_of(const ForceSearch* /*of*/) {
  using S = ForceSearch;
  static const Description all =
      Describe<S>("push_wall", "ForceSearch",
                  "Search for the largest force. The force of both hands rises until a condition "
                  "of the enumeration Limit ends the search.")
          .field("rate", &S::rate,
                 "Rate of increase of the force of each hand [{N/s}]",
                 {.least = 0, .open = true})
          .field("force_max", &S::force_max,
                 "Force of each hand at which the search stops at the latest [{N}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("With the value `never` (infinite), the search stops at nine tenths of "
                "limits.force.")
          .field("reserve", &S::reserve,
                 "Additional force that the posture must be able to support, as a fraction of the"
                 " force",
                 {.least = 0})
          .more("The check is static and uses the constraints of plans.")
          .field("force_tolerance", &S::force_tolerance,
                 "Largest amount by which the force of the hands may fall below its target [{N}]",
                 {.least = 0, .open = true})
          .more("The force is the mean of both hands over 0.1 s.")
          .field("slip", &S::slip,
                 "Largest distance that a hand or foot may slide within about a second [{m}]",
                 {.least = 0, .open = true})
          .more("Slow creep, for example of feet on compliant ground, does not count.")
          .field("hold_fraction", &S::hold_fraction,
                 "Force held after the search, as a fraction of the force where the search ended",
                 {.least = 0, .most = 1})
          .field("hold_duration", &S::hold_duration,
                 "Time for which the reduced force is held after the search [{s}]",
                 {.least = 0, .open = true});
  return all;
}

const Words& words_of(Limit /*of*/) {
  static const Words all{
      "push_wall",
      "Limit",
      "Condition that ended the search for the largest force.",
      {{"none", "none: the search did not end"},
       {"force_max", "the force reached ForceSearch.force_max"},
       {"statics", "the posture could not support the additional force of ForceSearch.reserve"},
       {"tracking", "the force of the hands fell behind its target"},
       {"plan", "plans could not satisfy all their constraints"},
       {"hand", "a hand slipped"},
       {"foot", "a foot slipped"}}};
  return all;
}

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("push_wall", "Task",
                  "Task of pushing with both hands against a wall. The members are the keys of a "
                  "task file, with their defaults.")
          .field("robot", &S::robot,
                 "Name, folder or settings file of the robot, optionally followed by `:variant`")
          .field("posture", &S::posture,
                 "Starting posture, a name from the robot's settings")
          .more("If empty, the robot's default posture is used.")
          .field("force", &S::force,
                 "Normal force that each hand presses with [{N}]",
                 {.least = 0, .open = true})
          .field("hands", &S::hands,
                 "Frames of the two hands; their origins are the centres of the round tips")
          .field("tip_radius", &S::tip_radius,
                 "Radius of the round tips of both hands [{m}]",
                 {.least = 0, .open = true})
          .field("wall", &S::wall,
                 "Plane wall at the distance `clearance` from the nearer hand at the start. The "
                 "controller knows the wall's normal.")
          .field("standing", &S::standing,
                 "Feet and ground of a robot with a floating base.")
          .group("Stand, approach until both hands have contact, ramp the force, hold it, search for "
             "the largest force,\nhold a fraction of the largest force, release, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "Distance between the nearer hand and the wall at the start [{m}]",
                 {.least = 0, .open = true})
          .field("settle_duration", &S::settle_duration,
                 "Time to stand before the approach [{s}]",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "Speed towards the wall [{m/s}]",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "Pressing force of each hand right after both hands have contact [{N}]",
                 {.least = 0, .open = true})
          .field("ramp_duration", &S::ramp_duration,
                 "Duration of the ramp from touch_force to force [{s}]",
                 {.least = 0, .open = true})
          .field("hold_duration", &S::hold_duration,
                 "Time for which `force` is held before the search [{s}]",
                 {.least = 0, .open = true})
          .field("release_duration", &S::release_duration,
                 "Duration of the release, a ramp of the force down to touch_force [{s}]",
                 {.least = 0, .open = true})
          .field("retreat_duration", &S::retreat_duration,
                 "Duration of the retreat from the wall to the distance `clearance` [{s}]",
                 {.least = 0, .open = true})
          .group("")
          .field("force_search", &S::force_search,
                 "Search for the largest force, and the conditions that end the search.")
          .group("", "controller")
          .field("tick_rate", &S::tick_rate,
                 "Rate of torque commands [{Hz}]",
                 {.least = 100, .most = 1e4})
          .field("update_rate", &S::update_rate,
                 "Rate of new plans, tick_rate divided by an integer [{Hz}]",
                 {.least = 0, .open = true})
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
          .field("horizon", &S::horizon,
                 "Duration that a plan covers [{s}]",
                 {.least = 0, .open = true})
          .field("step", &S::step,
                 "Time between the first two knots of the plan [{s}]",
                 {.least = 0, .open = true})
          .field("knots", &S::knots,
                 "Number of knots in the plan",
                 {.least = 2})
          .more("The steps between knots grow to cover the horizon.")
          .group("")
          .field("weights", &S::weights,
                 "Cost weights; each cost is integrated over the horizon, with time in s. Only "
                 "ratios of weights matter.\nA larger weight reduces the error of its own term "
                 "and increases the errors of the other terms.")
          .field("model_error", &S::model_error,
                 "Estimation of model errors from measurements. Each plan includes the estimate.")
          .field("constraints", &S::constraints,
                 "Hard constraints of plans; `never` switches a constraint off.")
          .group("Exceeding a limit ends the run and is reported as a fault.\nThe fallback controller"
             " then brakes and holds the robot. `never` switches a limit off.", "limits")
          .field("force_limit", &S::force_limit,
                 "Largest mean force of a hand over 5 ms [{N}]",
                 {.least = 0, .open = true, .infinite = true})
          .key("force")
          .field("slip", &S::slip,
                 "Largest distance that a hand or foot may slide [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("sink", &S::sink,
                 "Largest drop of the centre of mass below its height at the start [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("late_contact", &S::late_contact,
                 "Longest wait for contact after the planned time of contact [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("contact_lost", &S::contact_lost,
                 "Longest time without force at a hand that should press [{s}]",
                 {.least = 0, .open = true, .infinite = true})
          .field("contact_threshold", &S::contact_threshold,
                 "Force of a hand, averaged over 10 ms, above which the hand counts as in contact"
                 " [{N}]",
                 {.least = 0, .open = true})
          .more("Contact counts as lost if the force falls below half of this threshold.")
          .field("limits", &S::limits)
          .group("")
          .field("disturbances", &S::disturbances,
                 "Disturbances that the controller does not know.\nIn a task file, one of the "
                 "words none, sensors, mismatch and joint_friction can replace all keys.\nWith "
                 "the key `preset` and one of these words, only keys that differ from the preset "
                 "are needed.");
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("push_wall", "Setting",
                  "Task with all settings filled in: robot, start, wall, feet, hands, phases.")
          .field("robot", &S::robot,
                 "Robot of the task, with a floating base")
          .required()
          .field("q_start", &S::q_start,
                 "Configuration at the start, nq")
          .required()
          .field("scene", &S::scene,
                 "Scene as the controller assumes it: the feet are supports on the ground, the "
                 "hands on the wall")
          .more("The feet come before the hands. The robot has no tool")
          .required()
          .field("wall_axes", &S::wall_axes,
                 "Axes of the wall in the world; the columns are two tangents and the normal")
          .required()
          .field("p_hands", &S::p_hands,
                 "World positions of the two hands when they touch the wall [{m}]; one column per"
                 " hand")
          .required()
          .field("com", &S::com,
                 "Centre of mass at the start, in the world [{m}]")
          .required()
          .field("com_per_force", &S::com_per_force,
                 "Horizontal displacement of the centre of mass per force of each hand, in the "
                 "world [{m/N}]")
          .more("With this displacement, the centre of pressure under the feet does not move when"
                " the force changes.")
          .required()
          .field("room", &S::room,
                 "Distance at the start from the middle of the feet to the centre of pressure, "
                 "towards the wall [{m}]; 0 if the centre of pressure is farther from the wall "
                 "than the middle")
          .field("touch", &S::touch,
                 "Schedule time of the planned contact [{s}]")
          .field("ramp_end", &S::ramp_end,
                 "Schedule time at the end of the force ramp [{s}]")
          .field("hold_end", &S::hold_end,
                 "Schedule time when the hold ends and the search begins [{s}]")
          .field("search_end", &S::search_end,
                 "Schedule time at the end of the search for the largest force [{s}]")
          .field("top_end", &S::top_end,
                 "Schedule time at the end of the hold after the search [{s}]")
          .field("release_end", &S::release_end,
                 "Schedule time at the end of the release [{s}]");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("push_wall", "RunSpec",
                  "Options of run_task().")
          .field("task", &S::task)
          .field("setting", &S::setting,
                 "Task with all settings filled in; none: computed by make_setting()")
          .field("plant", &S::plant,
                 "Plant to simulate; must not be ideal, because the ideal plant has no feet")
          .field("check_reach", &S::check_reach,
                 "Check before the run by statics whether the robot can do the task; throw Error "
                 "if it cannot")
          .field("plan_rate", &S::plan_rate,
                 "Recording rate of plans (0: no recording) [{Hz}]")
          .field("progress", &S::progress,
                 "Callback that is called repeatedly with the simulated time and the run's "
                 "expected end, in s")
          .more("If the callback returns false, the run stops.");
  return all;
}

}  // namespace burnish::push_wall
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
