// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "stand/descriptions.hpp"
#include "stand/run_descriptions.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::stand {

const Description& description_of(const Sway* /*of*/) {
  using S = Sway;
  static const Description all =
      Describe<S>("stand", "Sway",
                  "How the trunk goes to and fro: a sine in each direction, begun and ended "
                  "smoothly. Axes are x forwards as the base is turned at the start, y to its "
                  "left, z up.")
          .field("shift", &S::shift,
                 "{m}, amplitudes of the centre of mass: x, y, z")
          .field("shift_rate", &S::shift_rate,
                 "{Hz}",
                 {.least = 0})
          .field("turn", &S::turn,
                 "{rad}, amplitudes of the base: roll, pitch, yaw")
          .field("turn_rate", &S::turn_rate,
                 "{Hz}",
                 {.least = 0})
          .field("rise", &S::rise,
                 "{s} until it is that wide",
                 {.least = 0, .open = true})
          .field("fit", &S::fit,
                 "directions that the feet or the joints do not allow are left out, or made "
                 "smaller; false: a sway that cannot be followed is refused");
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("stand", "Weights",
                  "Cost weights, per second of horizon.")
          .field("posture", &S::posture,
                 "{1/rad^2}: joints to the start",
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

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("stand", "Task",
                  "The task of standing on feet and swaying: all that a task file may say, with "
                  "its defaults.")
          .field("robot", &S::robot,
                 "a robot's name, folder or settings file, with :variant")
          .field("posture", &S::posture,
                 "where it starts, of the robot's settings; search: found, on bent legs")
          .more("Empty: the robot's default, or searched where it has none.")
          .field("crouch", &S::crouch,
                 "of the base's height above the feet with straight legs, that a searched posture"
                 " is lower",
                 {.least = 0, .most = 1, .below = true})
          .field("standing", &S::standing,
                 "What the robot stands on.")
          .field("sway", &S::sway,
                 "How the trunk goes to and fro: a sine in each direction, begun and ended "
                 "smoothly.\nAxes are x forwards as the base is turned at the start, y to its "
                 "left, z up.")
          .in_code("how the trunk goes to and fro")
          .group("Stand, sway, come back and stand.", "phases")
          .field("settle_duration", &S::settle_duration,
                 "{s} of standing before it sways",
                 {.least = 0, .open = true})
          .field("sway_duration", &S::sway_duration,
                 "{s} that it sways",
                 {.least = 0, .open = true})
          .field("rest_duration", &S::rest_duration,
                 "{s} of standing afterwards",
                 {.least = 0, .open = true})
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
          .field("slip", &S::slip,
                 "{m} that a foot may have slid; that a ball rolls is no sliding",
                 {.least = 0, .open = true, .infinite = true})
          .field("sink", &S::sink,
                 "of the height of the centre of mass above the feet, that it may be below where "
                 "it is to be",
                 {.least = 0, .open = true, .infinite = true})
          .field("tilt", &S::tilt,
                 "{rad} that the base may be turned off what it is to be",
                 {.least = 0, .open = true, .infinite = true})
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
      Describe<S>("stand", "Setting",
                  "A task with everything resolved: robot, start, feet, trunk, phases.")
          .field("robot", &S::robot)
          .required()
          .field("standing", &S::standing,
                 "the task's, with feet that were found where it states auto, or frames of which "
                 "the robot has none")
          .required()
          .field("q_start", &S::q_start,
                 "nq")
          .required()
          .field("scene", &S::scene,
                 "as the controller knows it: the feet are its supports; its surface is the "
                 "ground, and its tip a small ball in the base that never touches it")
          .required()
          .field("base", &S::base,
                 "a frame of the base's body")
          .required()
          .field("heading", &S::heading,
                 "axes that the sway is in, world: x forwards as the base is turned at the start,"
                 " z up")
          .required()
          .field("R_base", &S::R_base,
                 "axes of that frame at the start, world")
          .required()
          .field("p_base", &S::p_base,
                 "{m}, and its origin, world")
          .required()
          .field("com", &S::com,
                 "{m}, centre of mass at the start, world")
          .required()
          .field("sway", &S::sway,
                 "the task's, within what the feet allow where it is to fit")
          .field("notes", &S::notes,
                 "sentences about what was found in place of what it says")
          .field("sway_end", &S::sway_end,
                 "{s} of the schedule");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("stand", "RunSpec",
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

}  // namespace burnish::stand
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
