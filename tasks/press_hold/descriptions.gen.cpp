// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "press_hold/descriptions.hpp"
#include "press_hold/figures.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish::press_hold {

const Description& description_of(const Task* /*of*/) {
  using S = Task;
  static const Description all =
      Describe<S>("press_hold", "Task",
                  "Task of pressing at a point while the rest of the arm moves aside. The members"
                  " are the keys of a task file, with their defaults.")
          .field("robot", &S::robot,
                 "Name, folder or settings file of the robot, optionally followed by `:variant`")
          .field("posture", &S::posture,
                 "Starting posture: a name from the robot's settings, or `search` (find one for "
                 "the surface)")
          .more("If empty, the robot's default posture is used; if there is none, a posture is "
                "searched.")
          .field("force", &S::force,
                 "Normal force that the tool presses with [{N}]",
                 {.least = 0, .open = true})
          .field("aside", &S::aside,
                 "Offsets from the starting posture that move the arm aside [{rad (m)}]: {joint: "
                 "offset, ...}")
          .group("", "tool")
          .field("tool", &S::tool,
                 "Frame of the tool; its origin is the centre of the round tip")
          .key("frame")
          .field("tool_axis", &S::tool_axis,
                 "Pressing direction [x, y, z] in the tool's frame (automatic: away from the arm)",
                 {.direction = true})
          .more("If robot.yaml defines the tool's frame, the automatic direction is the frame's z"
                " or -z axis. Otherwise it is the axis of the last joint; see "
                "pressing_direction(). The vector need not have unit length. If a starting "
                "posture is stated, the angle between the pressing direction and the direction "
                "into the surface must be at most search.tilt.")
          .key("axis")
          .word("auto")
          .field("tip_radius", &S::tip_radius,
                 "Radius of the round tip [{m}]",
                 {.least = 0, .open = true})
          .group("The surface lies at the distance `clearance` from the tool at the start. The "
             "controller knows the surface's normal.", "surface")
          .field("normal_world", &S::normal_world,
                 "Normal of the surface [x, y, z] in world axes, towards the robot",
                 {.direction = true})
          .more("The normal points out of the material. It need not have unit length.")
          .key("normal")
          .field("extent", &S::extent,
                 "Distance from the pressed point to the surface's four edges (`endless`: no "
                 "edges) [{m}]",
                 {.least = 0, .open = true, .infinite = true})
          .more("The word `endless` stands for infinite; the surface is then a whole plane.")
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
          .field("search", &S::search,
                 "Requirements on a starting posture that is found by a search.")
          .group("Approach until contact, ramp the force, move aside, hold, retreat.", "phases")
          .field("clearance", &S::clearance,
                 "Distance between tool and surface at the start [{m}]",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "Speed towards the surface [{m/s}]",
                 {.least = 0, .open = true})
          .field("touch_force", &S::touch_force,
                 "Pressing force of the tool right after contact [{N}]",
                 {.least = 0})
          .field("ramp_duration", &S::ramp_duration,
                 "Duration of the ramp from touch_force to force [{s}]",
                 {.least = 0, .open = true})
          .field("aside_duration", &S::aside_duration,
                 "Duration of the move aside [{s}]",
                 {.least = 0, .open = true})
          .field("hold_duration", &S::hold_duration,
                 "Time for which the arm stays aside [{s}]",
                 {.least = 0, .open = true})
          .field("retreat_duration", &S::retreat_duration,
                 "Duration of the retreat from the surface to the distance `clearance` [{s}]",
                 {.least = 0, .open = true})
          .group("", "controller")
          .field("tick_rate", &S::tick_rate,
                 "Rate of torque commands and of new plans [{Hz}]",
                 {.least = 100, .most = 1e4})
          .field("command_delay", &S::command_delay,
                 "Assumed delay from a torque command to the torque in the joint [{s}]",
                 {.least = 0, .most = 0.1})
          .more("The delay is rounded to ticks. Plans and feedback start from a state that is "
                "predicted from the torques already sent.")
          .field("measurement_delay", &S::measurement_delay,
                 "Assumed delay from a measurement to the tick that receives it [{s}]",
                 {.least = 0, .most = 0.1})
          .field("posture_weight", &S::posture_weight,
                 "Weight on deviations of joint angles from the motion aside [{1/rad^2}]",
                 {.least = 0, .open = true})
          .more("For comparison, the weight on the tool's position is 1e4 1/m^2.")
          .field("constraints", &S::constraints,
                 "Hard constraints of plans; `never` switches a constraint off.")
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
          .field("slip", &S::slip,
                 "Largest distance that the tool may slide away from the pressed point [{m}]",
                 {.least = 0, .open = true, .infinite = true})
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
      Describe<S>("press_hold", "Setting",
                  "Task with all settings filled in: robot, start, surface, phases.")
          .field("robot", &S::robot,
                 "Robot of the task")
          .required()
          .field("q_start", &S::q_start,
                 "Configuration at the start, nq entries; also the first reference of the joint "
                 "angles")
          .required()
          .field("q_aside", &S::q_aside,
                 "Configuration with the arm moved aside, nq entries; also the last reference of "
                 "the joint angles")
          .required()
          .field("scene", &S::scene,
                 "Tip and surface as the controller assumes them")
          .required()
          .field("surface_axes", &S::surface_axes,
                 "Axes of the surface in the world; the columns are two tangents and the normal")
          .required()
          .field("p_hold", &S::p_hold,
                 "Position of the tool in contact, in the world [{m}]")
          .required()
          .field("touch", &S::touch,
                 "Schedule time of the planned contact [{s}]")
          .field("ramp_end", &S::ramp_end,
                 "Schedule time at the end of the force ramp [{s}]")
          .field("hold_end", &S::hold_end,
                 "Schedule time at the end of the hold [{s}]");
  return all;
}

const Description& description_of(const RunSpec* /*of*/) {
  using S = RunSpec;
  static const Description all =
      Describe<S>("press_hold", "RunSpec",
                  "Options of run_task().")
          .field("task", &S::task)
          .field("setting", &S::setting,
                 "Task with all settings filled in; none: computed by make_setting()")
          .field("plant", &S::plant,
                 "Plant to simulate; by default MuJoCo, if this build has it")
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

}  // namespace burnish::press_hold
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
