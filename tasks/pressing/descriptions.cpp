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
                 range::positive_or_infinite)
          .field("joint_torque_rate", &P::joint_torque_rate,
                 "{1/s}, of the robot's effort limits: rate of change of torques, with a "
                 "torque_cutoff",
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

const Description& description_of(const HomeSpec* /*of*/) {
  using H = HomeSpec;
  static const Description all =
      Describe<H>("pressing", "HomeSpec",
                  "Posture at which a run begins. From there the robot moves to the start of its "
                  "task.")
          .field("posture", &H::posture,
                 "of the robot, that a run begins at; none: the run begins at its task's start")
          .in_code(
              "posture of the robot that a run begins at; empty: the run begins at its task's "
              "start")
          .word("none")
          .field(
              "joints", &H::joints,
              "{joint: rad (m), ...} in place of the posture's; without one the others are as at "
              "the start")
          .in_code(
              "rad (m) by joint, in place of the posture's; without a posture the others are as at "
              "the start")
          .field("speed_ratio", &H::speed_ratio,
                 "of the joints' velocity limits, highest speed on the way",
                 Range{.least = 0.01, .most = 1.0})
          .field("duration", &H::duration,
                 "{s}; auto: the shortest that keeps speed_ratio and 0.8 of the effort limits, at "
                 "least 1 s",
                 range::positive)
          .in_code(
              "s; none: the shortest that keeps speed_ratio and 0.8 of the effort limits, at least "
              "1 s")
          .word("auto");
  return all;
}

// NOLINTNEXTLINE(readability-function-size): a table
const Description& description_of(const Standing* /*of*/) {
  using S = Standing;
  constexpr Range size = range::not_negative;
  static const Description all =
      Describe<S>("pressing", "Standing",
                  "Feet on level ground, where they are in the starting posture. Plans hold them "
                  "still within the friction and the pressure that these bear; the plant's ground "
                  "can only push and rub.")
          .field("feet", &S::feet,
                 "frames of the feet; auto: found in the description, with their sizes; none: the "
                 "base is fixed")
          .word("auto")
          .field("half_x", &S::half_x,
                 "{m}, half the length of a sole along x of its frame, about its origin; 0: point "
                 "feet",
                 size)
          .field("half_y", &S::half_y, "{m}, half its width along y", size)
          .field("radius", &S::radius, "{m}, of a point foot", range::positive)
          .field("friction", &S::friction, "Coulomb coefficient of the plant's ground", size)
          .field("stiffness", &S::stiffness,
                 "{N/m}, of the plant's ground under each foot; auto: it yields by 0.23 mm under "
                 "the weight, under point feet by 0.245 mm",
                 range::positive)
          .in_code(
              "N/m, of the plant's ground under each foot; none: it yields by 0.23 mm under the "
              "weight, under point feet by 0.245 mm")
          .word("auto")
          .field("damping", &S::damping,
                 "{Ns/m}, of the plant's ground under each foot; auto: 0.05 s times the stiffness, "
                 "for point feet 0.02 s",
                 range::positive)
          .in_code(
              "Ns/m, of the plant's ground under each foot; none: 0.05 s times the stiffness, for "
              "point feet 0.02 s")
          .word("auto")
          .field("plan_friction", &S::plan_friction, "friction coefficient that plans assume",
                 range::positive)
          .field("plan_sole", &S::plan_sole,
                 "fraction of a sole's half sides within which plans keep the centre of pressure",
                 range::share)
          .field("least_load", &S::least_load,
                 "{N}, smallest load of each foot in plans; auto: 0.09 of the weight per foot",
                 size)
          .in_code("N, smallest load of each foot in plans; none: 0.09 of the weight per foot")
          .word("auto")
          .field("balance", &S::balance, "{1/m^2}: centre of mass to where it starts", size)
          .field("base", &S::base, "{1/rad^2}: base to its orientation at the start", size)
          .field("momentum", &S::momentum,
                 "{per (kg m/s)^2 and (kg m^2/s)^2}: momentum about the centre of mass", size)
          .field("rubbing", &S::rubbing,
                 "{1/N^2}, on tangential forces and yaw moments of each foot", size)
          .more("It discourages internal forces between the feet.")
          .field("contact_kd", &S::contact_kd,
                 "{1/s}, damping of the feet's constraint (Baumgarte)", size)
          .field("estimate", &S::estimate,
                 "the base is estimated from an inertial unit, the joints and the feet; false: its "
                 "state is known")
          .in_code(
              "the base is estimated from an inertial unit, the joints and the feet "
              "(BaseEstimator); false: its state is known")
          .field("imu_frame", &S::imu_frame, "of that unit; empty: the base's body")
          .field("fallback", &S::fallback,
                 "hold at first and after a fault, in place of the task's; light feet on compliant "
                 "ground need a soft one")
          .field("hoist", &S::hoist,
                 "{s} at first, within settle, in which a hoist hands the weight over to the feet",
                 size)
          .field("slip", &S::slip, "how plans treat a foot that slips")
          .field("settle", &S::settle,
                 "time for which the posture is held at first, while the estimate of the base "
                 "settles [{s}]",
                 size)
          .field("force_sensors", &S::force_sensors, "in the feet, of forces and moments")
          .field(
              "after_fault", &S::after_fault,
              "time for which a run continues after a fault, to show whether the robot falls [{s}]",
              size)
          .more("The task's figures end at the fault.");
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
          .field("p_world", &T::p_world, "{m}; in the axes of MpcSpec::base where there is one")
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

const Description& description_of(const PressingPath* /*of*/) {
  using P = PressingPath;
  static const Description all =
      Describe<P>(
          "sim", "PressingPath",
          "The task of a controller without a plan: down to the surface, until it is felt, up to "
          "the force, along the path. These are the phases Approach, Ramp and Track of Phase.")
          .field("tool", &P::tool, "frame whose origin follows the path")
          .field("normal_world", &P::normal_world, "of the surface, towards the robot",
                 range::direction)
          .field("task", &P::task,
                 "The task at t s after the ramp; before, it stays at its start. Must not throw.")
          .field("posture", &P::posture, "nq, what the null space is drawn to")
          .field("period", &P::period, "{s} between ticks", range::positive)
          .field("approach_speed", &P::approach_speed, "{m/s}, against the normal",
                 range::not_negative)
          .field("contact_threshold", &P::contact_threshold,
                 "{N} of measured normal force that end the approach; see PressingTask",
                 range::not_negative)
          .field("touch_force", &P::touch_force,
                 "{N}, asked for where contact is made; the ramp starts there", range::not_negative)
          .field("ramp", &P::ramp, "{s} from contact to the task's force", range::not_negative);
  return all;
}

const Description& description_of(const ImpedanceGains* /*of*/) {
  using I = ImpedanceGains;
  constexpr Range gain = range::not_negative;
  static const Description all =
      Describe<I>("sim", "ImpedanceGains",
                  "Of the impedance; with e the tool's position error along the surface.")
          .field("kp", &I::kp, "{1/s^2}, along the surface", gain)
          .field("kd", &I::kd, "{1/s}, along the surface", gain)
          .field("ki_position", &I::ki_position,
                 "{1/s^3}, of the position's error along the surface; 0: no integral", gain)
          .field("position_integral_limit", &I::position_integral_limit,
                 "{m/s^2}, largest correction by that integral", gain)
          .field("kd_normal", &I::kd_normal, "{1/s}, along the normal", gain)
          .field("ki", &I::ki, "{1/s}, of the force error; 0: no force feedback", gain)
          .field("integral_limit", &I::integral_limit, "{N}, largest correction by that integral",
                 gain)
          .field("posture_kp", &I::posture_kp, "{1/s^2}", gain)
          .field("posture_kd", &I::posture_kd, "{1/s}", gain);
  return all;
}

const Description& description_of(const ImpedanceSpec* /*of*/) {
  using I = ImpedanceSpec;
  static const Description all =
      Describe<I>(
          "sim", "ImpedanceSpec",
          "The baseline without optimal control: an impedance of the tool in the world, the wanted "
          "force fed forward, the errors of force and place integrated, a posture in the null "
          "space. With e the tool's position error along the surface, v_n its velocity along the "
          "normal n and f the force along n: a = a_path + kp e + kd de/dt + ki_position * integral "
          "of e - kd_normal v_n n and f = f_path + ki * integral of (f_path - f_measured), by the "
          "tool's inertia and its Jacobian as torques. Both integrals are bounded, start anew "
          "where contact is made, and stand still while a torque is at its limit.")
          .field("path", &I::path)
          .field("gains", &I::gains)
          .field("friction", &I::friction, "of the surface, fed forward along the path's velocity",
                 range::not_negative);
  return all;
}

const Description& description_of(const AdmittanceGains* /*of*/) {
  using A = AdmittanceGains;
  constexpr Range gain = range::not_negative, positive = range::positive;
  static const Description all =
      Describe<A>("sim", "AdmittanceGains",
                  "Of both loops. The inner one knows the robot's mass matrix and gravity.")
          .field("rate", &A::rate, "{Hz}, of the outer loop; rounded to ticks, one at least",
                 positive)
          .field("delay", &A::delay,
                 "{s}, from its measurement to the inner loop; rounded to ticks",
                 range::from(0.0, 1.0))
          .field("force_cutoff", &A::force_cutoff,
                 "{rad/s}, low-pass of the measured force in the outer loop", positive)
          .field("mass", &A::mass,
                 "of the admittance, as a multiple of the tool's inertia along the normal", gain)
          .field("damping", &A::damping, "{1/s}, of the admittance; times that inertia", positive)
          .field("ki", &A::ki, "{1/s}, of the force error; 0: no integral of it", gain)
          .field("integral_limit", &A::integral_limit, "{N}, largest correction by that integral",
                 gain)
          .field("path_gain", &A::path_gain, "{1/s}, of the commanded tool's way to the path", gain)
          .field("ik_damping", &A::ik_damping, "of the inverse kinematics, m/rad", positive)
          .field("posture_gain", &A::posture_gain, "{1/s}, of the commanded joints to the posture",
                 gain)
          .field("joint_kp", &A::joint_kp, "{1/s^2}, of the inner loop", gain)
          .field("joint_kd", &A::joint_kd, "{1/s}, of the inner loop", gain)
          .field("joint_ki", &A::joint_ki, "{1/s^3}, of the inner loop; 0: no integral", gain)
          .field("joint_integral_limit", &A::joint_integral_limit,
                 "{rad/s^2}, largest correction by that integral", gain);
  return all;
}

const Description& description_of(const AdmittanceSpec* /*of*/) {
  using A = AdmittanceSpec;
  static const Description all =
      Describe<A>(
          "sim", "AdmittanceSpec",
          "A controller in two loops, as arms with a position interface are driven: an outer one "
          "that turns the force's error into a motion of the tool along the surface's normal, and "
          "that by inverse kinematics into joint positions, and an inner one that holds these. "
          "With f the force along the normal n behind a low-pass, q_c the commanded joints and p "
          "the tip's place there, l its inertia along n: l (mass dv_n/dt + damping v_n) = (f - "
          "f_path) + ki * integral of it; "
          "v_tool = v_n n and along the surface v_path + path_gain (p_path - p); dq_c/dt by damped "
          "least squares; and delay s later tau = M (joint_kp (q_c - q) + joint_kd (dq_c/dt - v) + "
          "joint_ki * integral of (q_c - q)) + b. Integrals are bounded, start anew where contact "
          "is made, and stand still while a torque is at its limit.")
          .field("path", &A::path)
          .field("gains", &A::gains);
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
