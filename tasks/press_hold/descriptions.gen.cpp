// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "press_hold/descriptions.hpp"
#include "press_hold/run_descriptions.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::press_hold {

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("press_hold", "Task",
                  "The task of pressing at a point while the arm moves aside: all that a task "
                  "file may say, with its defaults.")
          .field("robot", &S::robot,
                 "a robot's name, folder or settings file, with :variant")
          .field("posture", &S::posture,
                 "where it starts; search: found for the surface")
          .more("Of the robot's settings. Empty: the robot's default, or searched where it has "
                "none.")
          .field("force", &S::force,
                 "Normal force that the tool presses with [{N}]",
                 {.least = 0, .open = true})
          .field("aside", &S::aside,
                 "{rad (m)}, offset of each joint from the start: {joint: way, ...}")
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
          .group("The surface lies `clearance` from the tool at the start. The controller knows its "
             "normal.", "surface")
          .field("normal_world", &S::normal_world,
                 "[x, y, z] out of the material towards the robot, any length, world",
                 {.direction = true})
          .in_code("out of the surface, any length")
          .key("normal")
          .field("extent", &S::extent,
                 "{m} that there is surface beyond the point, on all four sides; or endless",
                 {.least = 0, .open = true, .infinite = true})
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
          .field("search", &S::search,
                 "What a posture that is searched keeps to.")
          .group("Approach until contact, ramp the force, move aside, hold, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "{m} between tool and surface at the start",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "{m/s} towards the surface",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "{N}, at once where contact is made",
                 {.least = 0})
          .field("ramp_duration", &S::ramp_duration,
                 "{s} from touch_force to force",
                 {.least = 0, .open = true})
          .field("aside_duration", &S::aside_duration,
                 "{s} that the posture takes to go aside",
                 {.least = 0, .open = true})
          .field("hold_duration", &S::hold_duration,
                 "{s} that it stays there",
                 {.least = 0, .open = true})
          .field("retreat_duration", &S::retreat_duration,
                 "{s} off the surface, by the clearance",
                 {.least = 0, .open = true})
          .group("", "controller")
          .field("tick_rate", &S::tick_rate,
                 "{Hz}, of torque commands and of new plans",
                 {.least = 100, .most = 1e4})
          .field("command_delay", &S::command_delay,
                 "Delay from command to torque that the controller assumes [{s}]",
                 {.least = 0, .most = 0.1})
          .more("Rounded to ticks. Plans and feedback begin in the state that the torques already"
                " sent lead to.")
          .field("measurement_delay", &S::measurement_delay,
                 "Delay from measurement to tick that the controller assumes [{s}]",
                 {.least = 0, .most = 0.1})
          .field("posture_weight", &S::posture_weight,
                 "{1/rad^2}: joints to where they shall be, beside 1e4 1/m^2 of the point",
                 {.least = 0, .open = true})
          .field("constraints", &S::constraints,
                 "What plans keep, whatever it costs. Each may be never.")
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
          .field("slip", &S::slip,
                 "{m} that the tool may be off its point, along the surface",
                 {.least = 0, .open = true, .infinite = true})
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
      Describe<S>("press_hold", "Setting",
                  "A task with everything resolved: robot, start, surface, phases.")
          .field("robot", &S::robot)
          .required()
          .field("q_start", &S::q_start,
                 "nq, where the posture's reference begins")
          .required()
          .field("q_aside", &S::q_aside,
                 "nq, where it ends")
          .required()
          .field("scene", &S::scene,
                 "as the controller knows it")
          .required()
          .field("surface_axes", &S::surface_axes,
                 "columns: two tangents and the normal, world")
          .required()
          .field("p_hold", &S::p_hold,
                 "of the tool in contact, m, world")
          .required()
          .field("touch", &S::touch,
                 "{s} of the schedule")
          .field("ramp_end", &S::ramp_end,
                 "{s} of the schedule")
          .field("hold_end", &S::hold_end,
                 "{s} of the schedule");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("press_hold", "RunSpec",
                  "A run of a task.")
          .field("task", &S::task)
          .field("setting", &S::setting,
                 "of the task, where there is one already")
          .field("plant", &S::plant,
                 "MuJoCo where this build has it")
          .field("check_reach", &S::check_reach,
                 "before anything moves; a problem is then an Error")
          .field("plan_rate", &S::plan_rate,
                 "{Hz}, at which plans are recorded; 0: none")
          .field("progress", &S::progress,
                 "Called now and then with the simulated time and about when it will be over, s. "
                 "Returning false stops the run.");
  return all;
}

}  // namespace burnish::press_hold
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
