#include "pressing/descriptions.hpp"

namespace burnish {

const Description& description_of(const ToolLimits* /*of*/) {
  constexpr Range limit = range::positive_or_infinite;
  static const Description all =
      Describe<ToolLimits>("pressing", "ToolLimits",
                           "When a run is given up for what happens at the tool. Infinite: never.")
          .field("force", &ToolLimits::force, "{N} at the tool, mean over force_window", limit)
          .more(
              "A rigid impact's force at a single instant is its impulse over the sampling time "
              "and "
              "says little.")
          .field("force_window", &ToolLimits::force_window, "{s}", range::not_negative)
          .more("rounded to ticks, one at least")
          .field("tool_speed", &ToolLimits::tool_speed, "{m/s}", limit)
          .field("contact_lost", &ToolLimits::contact_lost, "{s} without force while it is wanted",
                 limit)
          .field("late_contact_travel", &ToolLimits::late_contact_travel,
                 "{m} that the tool may go on after contact was due", limit)
          .more(
              "Along the normal, from when the schedule's clock began to wait for it "
              "(SchedulePhase::hold before it was due): how far the surface may lie behind where "
              "it "
              "is thought to be.")
          .field("late_contact_time", &ToolLimits::late_contact_time,
                 "{s} that contact may come late", limit)
          .more("from the same moment")
          .field("unexpected_force", &ToolLimits::unexpected_force,
                 "{N} while moving through free space", limit)
          .more(
              "Mean over `force_window`, where nothing is to touch, and while leaving once the "
              "tool has "
              "come off (its force fell below the threshold of contact) or `release` s are over. "
              "More where noise reaches further: six deviations of that mean.")
          .field("release", &ToolLimits::release,
                 "{s} into the retreat after which it is free space at the latest", limit);
  return all;
}

const Description& description_of(const PlanLimits* /*of*/) {
  using P = PlanLimits;
  static const Description all =
      Describe<P>("pressing", "PlanLimits",
                  "What plans keep, as hard constraints. Infinite: not kept.")
          .field("joint_margin", &P::joint_margin, "{rad (m)} that joints keep from their limits",
                 range::not_negative_or_infinite)
          .field("joint_speed", &P::joint_speed, "of the robot's velocity limits",
                 range::positive_or_infinite)
          .field("torque", &P::torque, "of the robot's effort limits; nor is more than that sent",
                 range::positive_or_infinite)
          .field("force_band", &P::force_band,
                 "{N} that the force may be off its target while pressing; it is never below zero",
                 range::positive_or_infinite);
  return all;
}

const Description& description_of(const PostureLimits* /*of*/) {
  using P = PostureLimits;
  constexpr Range limit = range::not_negative;
  static const Description all =
      Describe<P>("pressing", "PostureLimits",
                  "What a posture that is searched has to keep to; see find_posture().")
          .field("tilt", &P::tilt, "{rad} between the tool's axis and the normal", limit)
          .field("joint_margin", &P::joint_margin,
                 "{rad} that joints keep from their limits at the start", limit)
          .more("m of prismatic joints")
          .field("body_distance", &P::body_distance,
                 "{m} between the last link and the robot's body; less where the arm is short",
                 limit);
  return all;
}

const Words& words_of(Touch /*of*/) {
  static const Words all{
      "pressing",
      "Touch",
      "What the tool has to do with the surface in a phase.",
      {{"free", "nothing touches: a force is a fault, and what is felt is the sensor's noise"},
       {"due", "contact is to be made: SchedulePhase.until \"contact\""},
       {"wanted", "pressed"},
       {"leaving", "pressed at first; free once the tool has come off, or `release` s are over"}}};
  return all;
}

const Description& description_of(const TaskTarget* /*of*/) {
  using T = TaskTarget;
  static const Description all =
      Describe<T>("pressing", "TaskTarget",
                  "What the task asks of the tool at a time of the schedule, for the record. What "
                  "the controller aims at is what the costs of the problem say.")
          .field("p_world", &T::p_world, "{m}")
          .field("force", &T::force,
                 "{N}, along the normal; 0: no contact wanted, and no friction is reckoned with");
  return all;
}

const Description& description_of(const PressedSurface* /*of*/) {
  using P = PressedSurface;
  static const Description all =
      Describe<P>("pressing", "PressedSurface",
                  "The surface that a round tip presses on, as the task believes it to be.")
          .field("shape", &P::shape)
          .field("point_world", &P::point_world, "{m}, of it")
          .field("normal_world", &P::normal_world, "there, of any length", range::direction)
          .field("tip_radius", &P::tip_radius, "{m}", range::positive)
          .field("estimate", &P::estimate);
  return all;
}

const Description& description_of(const PressingTask* /*of*/) {
  using P = PressingTask;
  static const Description all =
      Describe<P>("pressing", "PressingTask",
                  "The task of an MpcSpec. Its event is \"contact\": a measured normal force above "
                  "the threshold and the sensor's noise, which is found out while nothing touches.")
          .field("touch", &P::touch, "one for each phase of the schedule")
          .field("target", &P::target, "by time of the schedule, each tick; must be given")
          .field("limits", &P::limits)
          .field("surface", &P::surface,
                 "What contacts that follow a surface follow, from the start as believed and while "
                 "the tool slides as estimated. None: references and normal are the "
                 "specification's.");
  return all;
}

const Description& description_of(const TaskPoint* /*of*/) {
  using T = TaskPoint;
  static const Description all =
      Describe<T>("sim", "TaskPoint",
                  "Where the tip frame's origin shall be and how hard the surface shall push back.")
          .field("p_world", &T::p_world, "{m}")
          .field("v_world", &T::v_world, "{m/s}")
          .field("a_world", &T::a_world, "{m/s^2}")
          .field("force", &T::force, "{N}, along the surface's normal")
          .field("normal_world", &T::normal_world,
                 "of the surface there, of length one; zero: the controller's own");
  return all;
}

const Description& description_of(const CirclePath* /*of*/) {
  using C = CirclePath;
  static const Description all =
      Describe<C>(
          "sim", "CirclePath",
          "A circle in a plane. It starts at the centre, at rest, and its radius grows smoothly.")
          .field("center_world", &C::center_world, "{m}")
          .field("normal_world", &C::normal_world, "of the plane, any length but zero")
          .field("radius", &C::radius, "{m}")
          .field("rate", &C::rate, "{rad/s}, about the normal")
          .field("start_up", &C::start_up, "{s} until the radius is reached; positive")
          .field("force", &C::force, "{N}");
  return all;
}

const Description& description_of(const ImpedanceSpec* /*of*/) {
  using I = ImpedanceSpec;
  static const Description all =
      Describe<I>(
          "sim", "ImpedanceSpec",
          "The baseline without optimal control: an impedance of the tool in the world, the wanted "
          "force fed forward, its error integrated, a posture in the null space. With e the tool's "
          "position error along the surface, v_n its velocity along the normal n and f the force "
          "along n: a = a_path + kp e + kd de/dt - kd_normal v_n n and f = f_path + ki * integral "
          "of (f_path - f_measured), by the tool's inertia and its Jacobian as torques.")
          .field("tool", &I::tool, "frame whose origin follows the path")
          .field("normal_world", &I::normal_world, "of the surface, towards the robot",
                 range::direction)
          .field("task", &I::task,
                 "The task at t s after the ramp; before, it stays at its start. Must not throw.")
          .field("posture", &I::posture, "nq, what the null space is drawn to")
          .field("period", &I::period, "{s} between ticks", range::positive)
          .field("kp", &I::kp, "{1/s^2}, along the surface", range::not_negative)
          .field("kd", &I::kd, "{1/s}, along the surface", range::not_negative)
          .field("kd_normal", &I::kd_normal, "{1/s}, along the normal", range::not_negative)
          .field("ki", &I::ki, "{1/s}, of the force error; 0: no force feedback",
                 range::not_negative)
          .field("integral_limit", &I::integral_limit, "{N}, largest correction by the integral",
                 range::not_negative)
          .field("posture_kp", &I::posture_kp, "{1/s^2}", range::not_negative)
          .field("posture_kd", &I::posture_kd, "{1/s}", range::not_negative)
          .field("friction", &I::friction, "of the surface, fed forward along the path's velocity",
                 range::not_negative)
          .field("approach_speed", &I::approach_speed,
                 "{m/s}, of a point that draws the tip against the normal", range::not_negative)
          .field("contact_threshold", &I::contact_threshold,
                 "{N} of measured normal force that end the approach; see PressingTask",
                 range::not_negative)
          .field("ramp", &I::ramp, "{s} from the threshold to the task's force",
                 range::not_negative);
  return all;
}

const Words& words_of(PlantKind /*of*/) {
  static const Words all{"pressing",
                         "PlantKind",
                         "What is controlled in a run.",
                         {{"mujoco", "an engine that shares no code with this library"},
                          {"ideal", "the library's own contact dynamics, a rigid surface"}}};
  return all;
}

}  // namespace burnish
