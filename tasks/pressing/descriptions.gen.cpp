// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "pressing/descriptions.gen.hpp"
#include "pressing/run_descriptions.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const AdmittanceGains* /*of*/) {
  using S = AdmittanceGains;
  static const Description all =
      Describe<S>("sim", "AdmittanceGains",
                  "Of both loops. The inner one knows the robot's mass matrix and gravity.")
          .field("rate", &S::rate,
                 "{Hz}, of the outer loop; rounded to ticks, one at least",
                 {.least = 0, .open = true})
          .field("delay", &S::delay,
                 "{s}, from its measurement to the inner loop; rounded to ticks",
                 {.least = 0, .most = 1})
          .field("force_cutoff", &S::force_cutoff,
                 "{rad/s}, low-pass of the measured force in the outer loop",
                 {.least = 0, .open = true})
          .field("mass", &S::mass,
                 "of the admittance, as a multiple of the tool's inertia along the normal",
                 {.least = 0})
          .field("damping", &S::damping,
                 "{1/s}, of the admittance; times that inertia",
                 {.least = 0, .open = true})
          .field("ki", &S::ki,
                 "{1/s}, of the force error; 0: no integral of it",
                 {.least = 0})
          .field("integral_limit", &S::integral_limit,
                 "{N}, largest correction by that integral",
                 {.least = 0})
          .field("path_gain", &S::path_gain,
                 "{1/s}, of the commanded tool's way to the path",
                 {.least = 0})
          .field("ik_damping", &S::ik_damping,
                 "of the inverse kinematics, m/rad",
                 {.least = 0, .open = true})
          .field("posture_gain", &S::posture_gain,
                 "{1/s}, of the commanded joints to the posture",
                 {.least = 0})
          .field("joint_kp", &S::joint_kp,
                 "{1/s^2}, of the inner loop",
                 {.least = 0})
          .field("joint_kd", &S::joint_kd,
                 "{1/s}, of the inner loop",
                 {.least = 0})
          .field("joint_ki", &S::joint_ki,
                 "{1/s^3}, of the inner loop; 0: no integral",
                 {.least = 0})
          .field("joint_integral_limit", &S::joint_integral_limit,
                 "{rad/s^2}, largest correction by that integral",
                 {.least = 0});
  return all;
}

const Description& description_of(const AdmittanceSpec* /*of*/) {
  using S = AdmittanceSpec;
  static const Description all =
      Describe<S>("sim", "AdmittanceSpec",
                  "A controller in two loops, as arms with a position interface are driven: an "
                  "outer one that turns the force's error into a motion of the tool along the "
                  "surface's normal, and that by inverse kinematics into joint positions, and an "
                  "inner one that holds these. With f the force along the normal n behind a "
                  "low-pass, q_c the commanded joints and p the tip's place there, l its inertia "
                  "along n: l (mass dv_n/dt + damping v_n) = (f - f_path) + ki * integral of it; "
                  "v_tool = v_n n and along the surface v_path + path_gain (p_path - p); dq_c/dt "
                  "by damped least squares; and delay s later tau = M (joint_kp (q_c - q) + "
                  "joint_kd (dq_c/dt - v) + joint_ki * integral of (q_c - q)) + b. Integrals are "
                  "bounded, start anew where contact is made, and stand still while a torque is "
                  "at its limit.")
          .field("path", &S::path)
          .field("gains", &S::gains);
  return all;
}

const Description& description_of(const HomeSpec* /*of*/) {
  using S = HomeSpec;
  static const Description all =
      Describe<S>("pressing", "HomeSpec",
                  "Posture at which a run begins. From there the robot moves to the start of its "
                  "task.")
          .field("posture", &S::posture,
                 "of the robot, that a run begins at; none: the run begins at its task's start")
          .in_code("posture of the robot that a run begins at; empty: the run begins at its "
                   "task's start")
          .word("none")
          .field("joints", &S::joints,
                 "{joint: rad (m), ...} in place of the posture's; without one the others are as "
                 "at the start")
          .in_code("rad (m) by joint, in place of the posture's; without a posture the others are"
                   " as at the start")
          .field("speed_ratio", &S::speed_ratio,
                 "of the joints' velocity limits, highest speed on the way",
                 {.least = 0.01, .most = 1})
          .field("duration", &S::duration,
                 "{s}; auto: the shortest that keeps speed_ratio and 0.8 of the effort limits, at"
                 " least 1 s",
                 {.least = 0, .open = true})
          .in_code("s; none: the shortest that keeps speed_ratio and 0.8 of the effort limits, at"
                   " least 1 s")
          .word("auto");
  return all;
}

const Description& description_of(const HomeMove* /*of*/) {
  using S = HomeMove;
  static const Description all =
      Describe<S>("pressing", "HomeMove",
                  "Move in joint space from where a run begins to its task's start, straight from"
                  " corner to corner and at rest at each.")
          .field("corners", &S::corners,
                 "nq each: home, the start lifted off the surface where the straight way would "
                 "touch it, the start")
          .field("durations", &S::durations,
                 "{s}, from each corner to the next")
          .field("settle", &S::settle,
                 "{s} at rest after it, until the task begins")
          .field("farthest_joint", &S::farthest_joint,
                 "entry of v that moves most")
          .field("farthest", &S::farthest,
                 "rad (m), how far");
  return all;
}

const Description& description_of(const ImpedanceGains* /*of*/) {
  using S = ImpedanceGains;
  static const Description all =
      Describe<S>("sim", "ImpedanceGains",
                  "Of the impedance; with e the tool's position error along the surface.")
          .field("kp", &S::kp,
                 "{1/s^2}, along the surface",
                 {.least = 0})
          .field("kd", &S::kd,
                 "{1/s}, along the surface",
                 {.least = 0})
          .field("ki_position", &S::ki_position,
                 "{1/s^3}, of the position's error along the surface; 0: no integral",
                 {.least = 0})
          .field("position_integral_limit", &S::position_integral_limit,
                 "{m/s^2}, largest correction by that integral",
                 {.least = 0})
          .field("kd_normal", &S::kd_normal,
                 "{1/s}, along the normal",
                 {.least = 0})
          .field("ki", &S::ki,
                 "{1/s}, of the force error; 0: no force feedback",
                 {.least = 0})
          .field("integral_limit", &S::integral_limit,
                 "{N}, largest correction by that integral",
                 {.least = 0})
          .field("posture_kp", &S::posture_kp,
                 "{1/s^2}",
                 {.least = 0})
          .field("posture_kd", &S::posture_kd,
                 "{1/s}",
                 {.least = 0});
  return all;
}

const Description& description_of(const ImpedanceSpec* /*of*/) {
  using S = ImpedanceSpec;
  static const Description all =
      Describe<S>("sim", "ImpedanceSpec",
                  "The baseline without optimal control: an impedance of the tool in the world, "
                  "the wanted force fed forward, the errors of force and place integrated, a "
                  "posture in the null space. With e the tool's position error along the surface,"
                  " v_n its velocity along the normal n and f the force along n: a = a_path + kp "
                  "e + kd de/dt + ki_position * integral of e - kd_normal v_n n and f = f_path + "
                  "ki * integral of (f_path - f_measured), by the tool's inertia and its Jacobian"
                  " as torques. Both integrals are bounded, start anew where contact is made, and"
                  " stand still while a torque is at its limit.")
          .field("path", &S::path)
          .field("gains", &S::gains)
          .field("friction", &S::friction,
                 "of the surface, fed forward along the path's velocity",
                 {.least = 0});
  return all;
}

const Words& words_of(PlantKind /*of*/) {
  static const Words all{
      "pressing",
      "PlantKind",
      "What is controlled in a run.",
      {{"mujoco", "an engine that shares no code with this library"},
       {"ideal", "the library's own contact dynamics, a rigid surface"}}};
  return all;
}

const Description& description_of(const TaskPoint* /*of*/) {
  using S = TaskPoint;
  static const Description all =
      Describe<S>("sim", "TaskPoint",
                  "Where the tip frame's origin shall be and how hard the surface shall push "
                  "back.")
          .field("p_world", &S::p_world,
                 "{m}")
          .field("v_world", &S::v_world,
                 "{m/s}")
          .field("a_world", &S::a_world,
                 "{m/s^2}")
          .field("force", &S::force,
                 "{N}, along the surface's normal")
          .field("normal_world", &S::normal_world,
                 "of the surface there, of length one; zero: the controller's own");
  return all;
}

const Description& description_of(const CirclePath* /*of*/) {
  using S = CirclePath;
  static const Description all =
      Describe<S>("sim", "CirclePath",
                  "A circle in a plane. It starts at the centre, at rest, and its radius grows "
                  "smoothly.")
          .field("center_world", &S::center_world,
                 "{m}")
          .field("normal_world", &S::normal_world,
                 "of the plane, any length but zero")
          .field("radius", &S::radius,
                 "{m}")
          .field("rate", &S::rate,
                 "{rad/s}, about the normal")
          .field("start_up", &S::start_up,
                 "{s} until the radius is reached; positive")
          .field("force", &S::force,
                 "{N}");
  return all;
}

const Description& description_of(const PressingPath* /*of*/) {
  using S = PressingPath;
  static const Description all =
      Describe<S>("sim", "PressingPath",
                  "The task of a controller without a plan: down to the surface, until it is "
                  "felt, up to the force, along the path. These are the phases Approach, Ramp and"
                  " Track of Phase.")
          .field("tool", &S::tool,
                 "frame whose origin follows the path")
          .field("normal_world", &S::normal_world,
                 "of the surface, towards the robot",
                 {.direction = true})
          .field("task", &S::task,
                 "The task at t s after the ramp; before, it stays at its start. Must not throw.")
          .field("posture", &S::posture,
                 "nq, what the null space is drawn to")
          .field("period", &S::period,
                 "{s} between ticks",
                 {.least = 0, .open = true})
          .field("approach_speed", &S::approach_speed,
                 "{m/s}, against the normal",
                 {.least = 0})
          .field("contact_threshold", &S::contact_threshold,
                 "{N} of measured normal force that end the approach; see PressingTask",
                 {.least = 0})
          .field("touch_force", &S::touch_force,
                 "{N}, asked for where contact is made; the ramp starts there",
                 {.least = 0})
          .field("ramp", &S::ramp,
                 "{s} from contact to the task's force",
                 {.least = 0});
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

const Description& description_of(const ToolLimits* /*of*/) {
  using S = ToolLimits;
  static const Description all =
      Describe<S>("pressing", "ToolLimits",
                  "When a run is given up for what happens at the tool. Infinite: never.")
          .field("force", &S::force,
                 "{N} at the tool, mean over force_window",
                 {.least = 0, .open = true, .infinite = true})
          .more("A rigid impact's force at a single instant is its impulse over the sampling time"
                " and says little.")
          .field("force_window", &S::force_window,
                 "{s}",
                 {.least = 0})
          .more("rounded to ticks, one at least")
          .field("tool_speed", &S::tool_speed,
                 "{m/s}",
                 {.least = 0, .open = true, .infinite = true})
          .field("contact_lost", &S::contact_lost,
                 "{s} without force while it is wanted",
                 {.least = 0, .open = true, .infinite = true})
          .field("late_contact_travel", &S::late_contact_travel,
                 "{m} that the tool may go on after contact was due",
                 {.least = 0, .open = true, .infinite = true})
          .more("Along the normal, from when the schedule's clock began to wait for it "
                "(SchedulePhase::hold before it was due): how far the surface may lie behind "
                "where it is thought to be.")
          .field("late_contact_time", &S::late_contact_time,
                 "{s} that contact may come late",
                 {.least = 0, .open = true, .infinite = true})
          .more("from the same moment")
          .field("unexpected_force", &S::unexpected_force,
                 "{N} while moving through free space",
                 {.least = 0, .open = true, .infinite = true})
          .more("Mean over `force_window`, where nothing is to touch, and while leaving once the "
                "tool has come off (its force fell below the threshold of contact) or `release` s"
                " are over. More where noise reaches further: six deviations of that mean.")
          .field("release", &S::release,
                 "{s} into the retreat after which it is free space at the latest",
                 {.least = 0, .open = true, .infinite = true});
  return all;
}

const Description& description_of(const PlanLimits* /*of*/) {
  using S = PlanLimits;
  static const Description all =
      Describe<S>("pressing", "PlanLimits",
                  "What plans keep, as hard constraints. Infinite: not kept.")
          .field("joint_margin", &S::joint_margin,
                 "{rad (m)} that joints keep from their limits",
                 {.least = 0, .infinite = true})
          .field("joint_speed", &S::joint_speed,
                 "of the robot's velocity limits",
                 {.least = 0, .open = true, .infinite = true})
          .field("torque", &S::torque,
                 "of the robot's effort limits; nor is more than that sent",
                 {.least = 0, .open = true, .infinite = true})
          .field("force_band", &S::force_band,
                 "{N} that the force may be off its target while pressing; it is never below zero",
                 {.least = 0, .open = true, .infinite = true})
          .field("joint_torque_rate", &S::joint_torque_rate,
                 "{1/s}, of the robot's effort limits: rate of change of torques, with a "
                 "torque_cutoff",
                 {.least = 0, .open = true, .infinite = true});
  return all;
}

const Description& description_of(const TaskTarget* /*of*/) {
  using S = TaskTarget;
  static const Description all =
      Describe<S>("pressing", "TaskTarget",
                  "What the task asks of the tool at a time of the schedule, for the record. What"
                  " the controller aims at is what the costs of the problem say.")
          .field("p_world", &S::p_world,
                 "{m}; in the axes of MpcSpec::base where there is one")
          .field("force", &S::force,
                 "{N}, along the normal; 0: no contact wanted, and no friction is reckoned with");
  return all;
}

const Description& description_of(const PressedSurface* /*of*/) {
  using S = PressedSurface;
  static const Description all =
      Describe<S>("pressing", "PressedSurface",
                  "The surface that a round tip presses on, as the task believes it to be.")
          .field("shape", &S::shape)
          .field("point_world", &S::point_world,
                 "{m}, of it")
          .field("normal_world", &S::normal_world,
                 "there, of any length",
                 {.direction = true})
          .field("tip_radius", &S::tip_radius,
                 "{m}",
                 {.least = 0, .open = true})
          .field("estimate", &S::estimate);
  return all;
}

const Description& description_of(const PressingTask* /*of*/) {
  using S = PressingTask;
  static const Description all =
      Describe<S>("pressing", "PressingTask",
                  "The task of an MpcSpec. Its event is \"contact\": a measured normal force "
                  "above the threshold and the sensor's noise, which is found out while nothing "
                  "touches.")
          .field("touch", &S::touch,
                 "one for each phase of the schedule")
          .field("target", &S::target,
                 "by time of the schedule, each tick; must be given")
          .field("limits", &S::limits)
          .field("surface", &S::surface,
                 "What contacts that follow a surface follow, from the start as believed and "
                 "while the tool slides as estimated. None: references and normal are the "
                 "specification's.");
  return all;
}

const Description& description_of(const ReachOptions* /*of*/) {
  using S = ReachOptions;
  static const Description all =
      Describe<S>("pressing", "ReachOptions",
                  "How check_reach() looks, and how much room it asks for.")
          .field("spacing", &S::spacing,
                 "{m} between two points that are looked at")
          .field("tolerance", &S::tolerance,
                 "{m} that the tool may be off")
          .field("joint_margin", &S::joint_margin,
                 "{rad (m)} that joints keep from their limits")
          .field("torque_share", &S::torque_share,
                 "Of the effort limits that statics may take: the rest is for motion and "
                 "feedback.")
          .field("link_radius", &S::link_radius,
                 "{m}, how thick links are taken to be; see check_reach()");
  return all;
}

const Words& words_of(ReachProblem /*of*/) {
  static const Words all{
      "pressing",
      "ReachProblem",
      "What is in the way.",
      {{"none"},
       {"position", "no posture puts the tool there, whatever the limits"},
       {"joint", "the only postures found are beyond a joint's limit"},
       {"torque", "holding the tool there takes more than a joint's effort limit"},
       {"collision", "the arm itself would touch the surface"}}};
  return all;
}

const Description& description_of(const ReachReport* /*of*/) {
  using S = ReachReport;
  static const Description all =
      Describe<S>("pressing", "ReachReport",
                  "The first thing in the way of a task, and how much room there is elsewhere.")
          .field("problem", &S::problem)
          .field("text", &S::text,
                 "One sentence: where, which joint, what came and what is allowed; empty without "
                 "a problem.")
          .field("s", &S::s,
                 "{m} along the path in contact where the problem is; negative: so far before the"
                 " path's start, on the way to it. A point that is held is a path without length.")
          .field("p_world", &S::p_world,
                 "of the tool there, m")
          .field("joint", &S::joint,
                 "empty for Position")
          .field("value", &S::value,
                 "{m} that the tool is off, rad (m) of the joint, Nm (N), m of the joint's origin"
                 " from the surface.")
          .field("limit", &S::limit,
                 "what is allowed, in the same unit")
          .field("points", &S::points,
                 "that were looked at")
          .field("path_length", &S::path_length,
                 "{m}, once around where the path repeats itself")
          .field("joint_margin", &S::joint_margin,
                 "{rad (m)}, smallest of all points")
          .field("tightest_joint", &S::tightest_joint)
          .field("torque_share", &S::torque_share,
                 "of the effort limit, largest of all points")
          .field("tightest_torque", &S::tightest_torque)
          .field("force_per_torque", &S::force_per_torque,
                 "{1/m}: N along the normal per Nm that every joint's torque is wrong by, "
                 "independent of each other, as told without a force sensor; largest of all "
                 "points on the surface")
          .field("force_joint", &S::force_joint,
                 "the joint that has most part in it there")
          .field("clearance", &S::clearance,
                 "{m} between the surface and the arm without its tool link, smallest of all "
                 "points; infinite where nothing but the tool link moves.")
          .field("tightest_clearance", &S::tightest_clearance,
                 "joint there");
  return all;
}

const Description& description_of(const PostureLimits* /*of*/) {
  using S = PostureLimits;
  static const Description all =
      Describe<S>("pressing", "PostureLimits",
                  "What a posture that is searched has to keep to; see find_posture().")
          .field("tilt", &S::tilt,
                 "{rad} between the tool's axis and the normal",
                 {.least = 0})
          .field("joint_margin", &S::joint_margin,
                 "{rad} that joints keep from their limits at the start",
                 {.least = 0})
          .more("m of prismatic joints")
          .field("body_distance", &S::body_distance,
                 "{m} between the last link and the robot's body; less where the arm is short",
                 {.least = 0});
  return all;
}

const Description& description_of(const PostureOptions* /*of*/) {
  using S = PostureOptions;
  static const Description all =
      Describe<S>("pressing", "PostureOptions",
                  "How find_posture() searches.")
          .field("random_starts", &S::random_starts,
                 "besides the robot's named postures and the middle of the limits")
          .field("seed", &S::seed,
                 "of those")
          .field("tilt_limit", &S::tilt_limit,
                 "{rad} between the pressing axis and the normal's opposite")
          .field("joint_margin", &S::joint_margin,
                 "{rad (m)} that joints keep from their limits at the start")
          .field("body_distance", &S::body_distance,
                 "{m} between the last link, for which stand three points on the line from its "
                 "joint to the tool, and the robot's body, for which stand the lines between the "
                 "joints before that one and the origins of all links that neither the last two "
                 "joints carry nor what hangs on them. Of parts of the arm that are near each "
                 "other along it, as in a compact wrist, no more is wanted than `bend` times the "
                 "arm's length between them. Coarse: no collision check.")
          .field("bend", &S::bend,
                 "see body_distance; of two equal links it lets 67 degrees between them")
          .field("checked", &S::checked,
                 "best candidates whose whole path is looked at")
          .field("reach", &S::reach);
  return all;
}

const Description& description_of(const FoundPosture* /*of*/) {
  using S = FoundPosture;
  static const Description all =
      Describe<S>("pressing", "FoundPosture",
                  "What find_posture() found.")
          .result()
          .field("q", &S::q,
                 "nq")
          .field("score", &S::score,
                 "lower is better")
          .field("tilt", &S::tilt,
                 "{rad} between the pressing axis and the normal's opposite")
          .field("reach", &S::reach,
                 "of the task from there")
          .field("candidates", &S::candidates,
                 "postures that met all conditions at the start");
  return all;
}

const Description& description_of(const Standing* /*of*/) {
  using S = Standing;
  static const Description all =
      Describe<S>("pressing", "Standing",
                  "Feet on level ground, where they are in the starting posture. Plans hold them "
                  "still within the friction and the pressure that these bear; the plant's ground"
                  " can only push and rub.")
          .field("feet", &S::feet,
                 "frames of the feet; auto: found in the description, with their sizes; none: the"
                 " base is fixed")
          .word("auto")
          .field("half_x", &S::half_x,
                 "{m}, half the length of a sole along x of its frame, about its origin; 0: point"
                 " feet",
                 {.least = 0})
          .field("half_y", &S::half_y,
                 "{m}, half its width along y",
                 {.least = 0})
          .field("radius", &S::radius,
                 "{m}, of a point foot",
                 {.least = 0, .open = true})
          .field("friction", &S::friction,
                 "Coulomb coefficient of the plant's ground",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "{N/m}, of the plant's ground under each foot; auto: it yields by 0.23 mm under "
                 "the weight, under point feet by 0.245 mm",
                 {.least = 0, .open = true})
          .in_code("N/m, of the plant's ground under each foot; none: it yields by 0.23 mm under "
                   "the weight, under point feet by 0.245 mm")
          .word("auto")
          .field("damping", &S::damping,
                 "{Ns/m}, of the plant's ground under each foot; auto: 0.05 s times the "
                 "stiffness, for point feet 0.02 s",
                 {.least = 0, .open = true})
          .in_code("Ns/m, of the plant's ground under each foot; none: 0.05 s times the "
                   "stiffness, for point feet 0.02 s")
          .word("auto")
          .field("plan_friction", &S::plan_friction,
                 "friction coefficient that plans assume",
                 {.least = 0, .open = true})
          .field("plan_sole", &S::plan_sole,
                 "fraction of a sole's half sides within which plans keep the centre of pressure",
                 {.least = 0, .most = 1})
          .field("least_load", &S::least_load,
                 "{N}, smallest load of each foot in plans; auto: 0.09 of the weight per foot",
                 {.least = 0})
          .in_code("N, smallest load of each foot in plans; none: 0.09 of the weight per foot")
          .word("auto")
          .field("balance", &S::balance,
                 "{1/m^2}: centre of mass to where it starts",
                 {.least = 0})
          .field("base", &S::base,
                 "{1/rad^2}: base to its orientation at the start",
                 {.least = 0})
          .field("momentum", &S::momentum,
                 "{per (kg m/s)^2 and (kg m^2/s)^2}: momentum about the centre of mass",
                 {.least = 0})
          .field("rubbing", &S::rubbing,
                 "{1/N^2}, on tangential forces and yaw moments of each foot",
                 {.least = 0})
          .more("It discourages internal forces between the feet.")
          .field("contact_kd", &S::contact_kd,
                 "{1/s}, damping of the feet's constraint (Baumgarte)",
                 {.least = 0})
          .field("estimate", &S::estimate,
                 "the base is estimated from an inertial unit, the joints and the feet; false: "
                 "its state is known")
          .in_code("the base is estimated from an inertial unit, the joints and the feet "
                   "(BaseEstimator); false: its state is known")
          .field("imu_frame", &S::imu_frame,
                 "of that unit; empty: the base's body")
          .field("fallback", &S::fallback,
                 "hold at first and after a fault, in place of the task's; light feet on "
                 "compliant ground need a soft one")
          .field("hoist", &S::hoist,
                 "{s} at first, within settle, in which a hoist hands the weight over to the feet",
                 {.least = 0})
          .field("slip", &S::slip,
                 "how plans treat a foot that slips")
          .field("settle", &S::settle,
                 "time for which the posture is held at first, while the estimate of the base "
                 "settles [{s}]",
                 {.least = 0})
          .field("force_sensors", &S::force_sensors,
                 "in the feet, of forces and moments")
          .field("after_fault", &S::after_fault,
                 "time for which a run continues after a fault, to show whether the robot falls "
                 "[{s}]",
                 {.least = 0})
          .more("The task's figures end at the fault.");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
