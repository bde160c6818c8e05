// What specifications of tasks that press hold, and the entries that all such tasks have.
#pragma once

#include "base/description.hpp"
#include "burnish/tasks/pressing/admittance_controller.hpp"
#include "burnish/tasks/pressing/home.hpp"
#include "burnish/tasks/pressing/impedance_controller.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "burnish/tasks/pressing/pressing_task.hpp"
#include "burnish/tasks/pressing/reach.hpp"
#include "burnish/tasks/pressing/standing.hpp"
#include "mpc/descriptions.hpp"

namespace burnish {

const Description& description_of(const ToolLimits*);
const Description& description_of(const PlanLimits*);
const Description& description_of(const PostureLimits*);
const Description& description_of(const HomeSpec*);
const Description& description_of(const Standing*);
const Words& words_of(Touch);
const Description& description_of(const TaskTarget*);
const Description& description_of(const PressedSurface*);
const Description& description_of(const PressingTask*);
const Description& description_of(const TaskPoint*);
const Description& description_of(const CirclePath*);
const Description& description_of(const PressingPath*);
const Description& description_of(const ImpedanceGains*);
const Description& description_of(const ImpedanceSpec*);
const Description& description_of(const AdmittanceGains*);
const Description& description_of(const AdmittanceSpec*);
const Words& words_of(PlantKind);

namespace pressing {

/// The section `tool`.
template <class Task>
Describe<Task>& describe_tool(Describe<Task>& task) {
  return task.group("", "tool")
      .field("tool", &Task::tool, "its origin is the centre of a round tip")
      .key("frame")
      .field("tool_axis", &Task::tool_axis,
             "[x, y, z] that it presses along, in its frame; or auto: z or -z of a frame of "
             "robot.yaml, of others the last joint's axis, away from the arm",
             range::direction)
      .in_code(
          "that the tool presses along, in its frame, any length; without it see "
          "pressing_direction()")
      .more("a posture that is given must agree with it, within search.tilt")
      .key("axis")
      .word("auto")
      .field("tip_radius", &Task::tip_radius, "{m}", range::positive);
}

/// Of the surface, what the plant alone knows.
template <class Task>
Describe<Task>& describe_material(Describe<Task>& task) {
  return task
      .field("friction", &Task::friction,
             "Coulomb coefficient of the plant, unless disturbances.surface_friction says another",
             range::not_negative)
      .field("stiffness", &Task::stiffness, "{N/m}, of the plant", range::positive)
      .field("damping", &Task::damping, "{Ns/m}, of the plant", range::not_negative);
}

/// Delays that a controller knows of, in the section before.
template <class Task>
Describe<Task>& describe_delays(Describe<Task>& task) {
  constexpr Range delay{.least = 0.0, .most = 0.1};
  return task
      .field("command_delay", &Task::command_delay,
             "{s} from a command to the torque that it makes, as far as it is known", delay)
      .more(
          "Rounded to ticks. Plans and feedback begin in the state that the torques already sent "
          "lead to.")
      .field("measurement_delay", &Task::measurement_delay,
             "{s} from what is measured to the tick that has it, as far as it is known", delay);
}

/// The section `limits`.
template <class Task>
Describe<Task>& describe_limits(Describe<Task>& task) {
  return task
      .group(
          "Beyond these a run is given up: the arm is braked and held (fallback), and there is a "
          "report.\nEach may be never.",
          "limits")
      .field("limits", &Task::limits, "")
      .field("tool_limits", &Task::tool_limits, "")
      .key("limits")
      .field("contact_threshold", &Task::contact_threshold, "{N} that count as contact",
             range::positive_or_infinite)
      .more(
          "Where the sensor's noise comes near it, which is found out in the reach, it is the mean "
          "over 5 ms that counts, against six of its own deviations.");
}

/// The section `disturbances`; see read_presets().
template <class Task>
Describe<Task>& describe_disturbances(Describe<Task>& task) {
  return task
      .field("disturbances", &Task::disturbances,
             "What the controller does not know. Or one word: none, sensors, mismatch, "
             "joint_friction; or\n`preset: word` and keys that differ from it.")
      .in_code("what the controller does not know");
}

}  // namespace pressing
}  // namespace burnish
