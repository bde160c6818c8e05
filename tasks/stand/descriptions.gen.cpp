// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "stand/descriptions.hpp"
#include "stand/figures.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::stand {

const Description& description_of(const Sway* /*of*/) {
  using S = Sway;
  static const Description all =
      Describe<S>("stand", "Sway",
                  "Sway of the trunk: a sine in each direction that begins and ends smoothly. The"
                  " axes of the sway are level: x points forwards (as the base does at the "
                  "start), y to the left, and z up.")
          .field("shift", &S::shift,
                 "Amplitudes of the motion of the centre of mass along x, y and z [{m}]")
          .field("shift_rate", &S::shift_rate,
                 "Frequencies of the motion of the centre of mass along x, y and z [{Hz}]",
                 {.least = 0})
          .field("turn", &S::turn,
                 "Amplitudes of the rotation of the base in roll, pitch and yaw [{rad}]")
          .field("turn_rate", &S::turn_rate,
                 "Frequencies of the rotation of the base in roll, pitch and yaw [{Hz}]",
                 {.least = 0})
          .field("rise", &S::rise,
                 "Time until the sway has its full amplitude [{s}]",
                 {.least = 0, .open = true})
          .more("At the end, the sway fades out in the same time.")
          .field("fit", &S::fit,
                 "Reduce amplitudes that feet or joints do not allow; false: reject such "
                 "amplitudes with an error")
          .more("An amplitude is reduced to 0 if needed.");
  return all;
}

const Description& description_of(const Weights* /*of*/) {
  using S = Weights;
  static const Description all =
      Describe<S>("stand", "Weights",
                  "Cost weights. Each cost is integrated over the horizon, with time in s.")
          .field("posture", &S::posture,
                 "Weight on joint angles relative to the starting posture [{1/rad^2}]",
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

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("stand", "Task",
                  "Task of standing on the feet while the trunk sways. The members are the keys "
                  "of a task file, with their defaults.")
          .field("robot", &S::robot,
                 "Name, folder or settings file of the robot, optionally followed by `:variant`")
          .field("posture", &S::posture,
                 "Starting posture: a name from the robot's settings, or `search` (find one with "
                 "bent legs)")
          .more("If empty, the robot's default posture is used; if there is none, a posture is "
                "searched.")
          .field("crouch", &S::crouch,
                 "Drop of the base in a searched posture, as a fraction of the base's height",
                 {.least = 0, .most = 1, .below = true})
          .more("The base's height is measured from the feet, with straight legs.")
          .field("standing", &S::standing,
                 "Feet and ground of a robot with a floating base.")
          .field("sway", &S::sway,
                 "Sway of the trunk: a sine in each direction that begins and ends smoothly.\nThe"
                 " axes are level: x points forwards (as the base does at the start), y to the "
                 "left, z up.")
          .group("Stand, sway, then stand in the starting posture again.", "phases")
          .field("settle_duration", &S::settle_duration,
                 "Time to stand before the sway [{s}]",
                 {.least = 0, .open = true})
          .field("sway_duration", &S::sway_duration,
                 "Duration of the sway [{s}]",
                 {.least = 0, .open = true})
          .field("rest_duration", &S::rest_duration,
                 "Time to stand after the sway [{s}]",
                 {.least = 0, .open = true})
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
          .field("slip", &S::slip,
                 "Largest distance that a foot may slide [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("Rolling of point feet does not count.")
          .field("sink", &S::sink,
                 "Largest drop of the centre of mass below its target, divided by its height",
                 {.least = 0, .open = true, .infinite = true})
          .more("The height of the centre of mass is measured from the feet.")
          .field("tilt", &S::tilt,
                 "Largest allowed angle between the base and its target [{rad}]",
                 {.least = 0, .open = true, .infinite = true})
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
      Describe<S>("stand", "Setting",
                  "Task with all settings filled in: robot, start, feet, trunk, phases.")
          .field("robot", &S::robot,
                 "Robot of the task")
          .required()
          .field("standing", &S::standing,
                 "Feet and ground that the robot stands on")
          .more("If the task states `auto`, or only frames that the robot lacks, detected feet "
                "replace the feet of the task.")
          .required()
          .field("q_start", &S::q_start,
                 "Configuration at the start, nq")
          .required()
          .field("scene", &S::scene,
                 "Scene as the controller assumes it: the feet are supports on the ground")
          .more("The robot has no tool")
          .required()
          .field("ground", &S::ground,
                 "Ground: a plane at the height of the lowest foot, in the middle of the feet")
          .field("base", &S::base,
                 "Name of a frame on the body of the floating base")
          .required()
          .field("heading", &S::heading,
                 "Axes of the sway in the world, as columns: forwards (as the base points at the "
                 "start), left, up")
          .required()
          .field("R_base", &S::R_base,
                 "Axes of the frame `base` at the start, in the world")
          .required()
          .field("p_base", &S::p_base,
                 "Origin of the frame `base` at the start, in the world [{m}]")
          .required()
          .field("com", &S::com,
                 "Centre of mass at the start, in the world [{m}]")
          .required()
          .field("sway", &S::sway,
                 "Sway of the task; if Sway.fit is true, the amplitudes are reduced to what feet "
                 "and joints allow")
          .field("notes", &S::notes,
                 "Settings of the task that were replaced for this robot, one sentence each")
          .field("sway_end", &S::sway_end,
                 "Schedule time at the end of the sway [{s}]");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("stand", "RunSpec",
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

}  // namespace burnish::stand
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
