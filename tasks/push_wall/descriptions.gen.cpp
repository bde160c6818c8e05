// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "push_wall/descriptions.hpp"
#include "push_wall/run_descriptions.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::push_wall {

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("push_wall", "Weights",
                  "Cost weights, per second of horizon.")
          .field("force", &S::force,
                 "{1/N^2}: of each hand along the normal to its target",
                 {.least = 0})
          .field("friction", &S::friction,
                 "{1/N^2}: of each hand along the wall to none",
                 {.least = 0})
          .field("position", &S::position,
                 "{1/m^2}: hands to their places along the wall, while they do not hold",
                 {.least = 0})
          .field("approach", &S::approach,
                 "{s^2/m^2}: speed along the normal to that of approach and retreat",
                 {.least = 0})
          .field("inclination", &S::inclination,
                 "{1/rad^2}: hands to their axis along the normal at the start; what tilts costs "
                 "torque of the wrists",
                 {.least = 0})
          .field("posture", &S::posture,
                 "{1/rad^2}: joints to the start; more keeps the body from leaning",
                 {.least = 0})
          .field("range", &S::range,
                 "{1/rad^2}: joints off their limits, within range_margin of these",
                 {.least = 0})
          .field("range_margin", &S::range_margin,
                 "{rad (m)}",
                 {.least = 0})
          .field("velocity", &S::velocity,
                 "{s^2/rad^2}: joint speeds",
                 {.least = 0})
          .field("torque", &S::torque,
                 "{1/Nm^2}: torques to those that hold the start",
                 {.least = 0})
          .field("terminal", &S::terminal,
                 "{s}: what the end of the horizon costs, as a time at its running cost",
                 {.least = 0});
  return all;
}

const Description& description_of(const Wall* /*of*/) {
  using S = Wall;
  static const Description all =
      Describe<S>("push_wall", "Wall",
                  "A plane before the hands, and what plans keep of it. It lies `clearance` from "
                  "the nearer hand at the start.")
          .field("normal_world", &S::normal_world,
                 "[x, y, z] out of the wall towards the robot, any length, world",
                 {.direction = true})
          .in_code("out of the wall, any length")
          .key("normal")
          .field("friction", &S::friction,
                 "Coulomb coefficient of the plant",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "{N/m}, of the plant, under each hand",
                 {.least = 0, .open = true})
          .field("damping", &S::damping,
                 "{Ns/m}, of the plant, under each hand",
                 {.least = 0, .open = true})
          .field("plan_friction", &S::plan_friction,
                 "coefficient that plans keep within",
                 {.least = 0, .open = true})
          .field("contact_kd", &S::contact_kd,
                 "{1/s}, damping of the hands' constraint (Baumgarte)",
                 {.least = 0});
  return all;
}

const Description& description_of(const Lean* /*of*/) {
  using S = Lean;
  static const Description all =
      Describe<S>("push_wall", "Lean",
                  "How the largest force is looked for, and when the search is over: where the "
                  "posture could not bear `reserve` more, where plans cannot keep their limits or"
                  " give way, where a hand or a foot slips, and at `force_max`.")
          .field("rate", &S::rate,
                 "{N/s}, of each hand",
                 {.least = 0, .open = true})
          .field("force_max", &S::force_max,
                 "{N} of each hand, where it ends at the latest",
                 {.least = 0, .open = true, .infinite = true})
          .more("never: nine tenths of limits.force.")
          .field("reserve", &S::reserve,
                 "of the force, that the posture must be able to bear beyond it, at rest and "
                 "within the limits that plans keep",
                 {.least = 0})
          .field("give", &S::give,
                 "{N} that the mean of both hands over 0.1 s may be below the target",
                 {.least = 0, .open = true})
          .field("slip", &S::slip,
                 "{m} that a hand or foot may slide within a second; grounds creep",
                 {.least = 0, .open = true})
          .field("share", &S::share,
                 "of the force then, that is held afterwards",
                 {.least = 0, .most = 1})
          .field("hold_duration", &S::hold_duration,
                 "{s} that this is held",
                 {.least = 0, .open = true});
  return all;
}

const Words& words_of(Limit /*of*/) {
  static const Words all{
      "push_wall",
      "Limit",
      "What ended the search for the largest force.",
      {{"none", "nothing: the search did not end"},
       {"most", "Lean.force_max was reached"},
       {"bear", "the posture could not bear Lean.reserve more"},
       {"give", "plans gave way: the hands fell behind the target"},
       {"plan", "plans could not keep all their limits"},
       {"hand", "a hand slipped"},
       {"foot", "a foot slipped"}}};
  return all;
}

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("push_wall", "Task",
                  "The task of pushing with both hands against a wall: all that a task file may "
                  "say, with its defaults.")
          .field("robot", &S::robot,
                 "a robot's name, folder or settings file, with :variant")
          .field("posture", &S::posture,
                 "where it starts, of the robot's settings")
          .more("Empty: the robot's default.")
          .field("force", &S::force,
                 "{N}, that each hand presses with",
                 {.least = 0, .open = true})
          .field("hands", &S::hands,
                 "two frames, whose origins are the centres of balls")
          .field("tip_radius", &S::tip_radius,
                 "{m}, of those balls",
                 {.least = 0, .open = true})
          .field("wall", &S::wall,
                 "A plane, `clearance` before the nearer hand at the start. The controller knows "
                 "its normal.")
          .field("standing", &S::standing,
                 "What the robot stands on.")
          .group("Stand, approach until both hands have contact, ramp the force, hold it, lean to the"
             " largest,\nhold that, release, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "{m} between hands and wall at the start",
                 {.least = 0, .open = true})
          .field("settle_duration", &S::settle_duration,
                 "{s} of standing before",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "{m/s} towards the wall",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "{N} of each hand, at once where both have contact",
                 {.least = 0, .open = true})
          .field("ramp_duration", &S::ramp_duration,
                 "{s} from touch_force to force",
                 {.least = 0, .open = true})
          .field("hold_duration", &S::hold_duration,
                 "{s} that the force is held",
                 {.least = 0, .open = true})
          .field("release_duration", &S::release_duration,
                 "{s} back to touch_force",
                 {.least = 0, .open = true})
          .field("retreat_duration", &S::retreat_duration,
                 "{s} off the wall, by the clearance",
                 {.least = 0, .open = true})
          .group("")
          .field("lean", &S::lean,
                 "How the largest force is looked for, and when the search is over.")
          .group("", "controller")
          .field("tick_rate", &S::tick_rate,
                 "{Hz}, of torque commands",
                 {.least = 100, .most = 1e4})
          .field("update_rate", &S::update_rate,
                 "{Hz}, of new plans; divides the tick rate",
                 {.least = 0, .open = true})
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
          .field("horizon", &S::horizon,
                 "{s} that are planned ahead",
                 {.least = 0, .open = true})
          .field("step", &S::step,
                 "{s} between the first two knots of the plan",
                 {.least = 0, .open = true})
          .field("knots", &S::knots,
                 "of the plan; the steps grow so that they fill the horizon",
                 {.least = 2})
          .group("")
          .field("weights", &S::weights,
                 "Cost weights, per second of horizon.")
          .field("model_error", &S::model_error,
                 "What is estimated of what the model gets wrong.")
          .field("constraints", &S::constraints,
                 "What plans keep, whatever it costs. Each may be never.")
          .group("Beyond these a run is given up: the robot is braked and held (fallback), and there "
             "is a report.\nEach may be never.", "limits")
          .field("force_limit", &S::force_limit,
                 "{N} of a hand, mean over 5 ms",
                 {.least = 0, .open = true, .infinite = true})
          .key("force")
          .field("slip", &S::slip,
                 "{m} that a hand or foot may have slid",
                 {.least = 0, .open = true, .infinite = true})
          .field("sink", &S::sink,
                 "{m} that the centre of mass may be below where it starts",
                 {.least = 0, .open = true, .infinite = true})
          .field("late_contact", &S::late_contact,
                 "{s} that contact may come late",
                 {.least = 0, .open = true, .infinite = true})
          .field("contact_lost", &S::contact_lost,
                 "{s} that a hand may be without force while it is to press",
                 {.least = 0, .open = true, .infinite = true})
          .field("contact_threshold", &S::contact_threshold,
                 "{N}, mean over 10 ms, that count as contact of a hand",
                 {.least = 0, .open = true})
          .field("limits", &S::limits)
          .group("")
          .field("disturbances", &S::disturbances,
                 "What the controller does not know. Or one word: none, sensors, mismatch, "
                 "joint_friction; or\n`preset: word` and keys that differ from it.")
          .in_code("what the controller does not know");
  return all;
}

const Description& description_of(const Setting* /*of*/) {
  using S = Setting;
  static const Description all =
      Describe<S>("push_wall", "Setting",
                  "A task with everything resolved: robot, start, wall, feet, hands, phases.")
          .field("robot", &S::robot)
          .required()
          .field("q_start", &S::q_start,
                 "nq")
          .required()
          .field("scene", &S::scene,
                 "as the controller knows it: feet and hands are its supports, in this order; its"
                 " surface is the wall, and its tip a smaller ball that never touches it")
          .required()
          .field("wall_axes", &S::wall_axes,
                 "columns: two tangents and the normal, world")
          .required()
          .field("p_hands", &S::p_hands,
                 "of the hands in contact, m, world; columns")
          .required()
          .field("com", &S::com,
                 "centre of mass at the start, m, world")
          .required()
          .field("com_per_force", &S::com_per_force,
                 "m/N, world, level: how far the centre of mass goes per N of each hand so that "
                 "the pressure under the feet stays where it is")
          .required()
          .field("room", &S::room,
                 "{m} that the pressure lies before the middle of the feet at the start, on the "
                 "side of the wall")
          .field("touch", &S::touch,
                 "{s} of the schedule")
          .field("ramp_end", &S::ramp_end,
                 "{s} of the schedule")
          .field("hold_end", &S::hold_end,
                 "{s} of the schedule")
          .field("lean_end", &S::lean_end,
                 "{s} of the schedule")
          .field("top_end", &S::top_end,
                 "{s} of the schedule")
          .field("release_end", &S::release_end,
                 "{s} of the schedule");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("push_wall", "RunSpec",
                  "A run of a task.")
          .field("task", &S::task)
          .field("setting", &S::setting,
                 "of the task, where there is one already")
          .field("plant", &S::plant,
                 "the ideal plant has no feet to stand on")
          .field("check_reach", &S::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("plan_rate", &S::plan_rate,
                 "{Hz}, at which plans are recorded; 0: none")
          .field("progress", &S::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

}  // namespace burnish::push_wall
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
