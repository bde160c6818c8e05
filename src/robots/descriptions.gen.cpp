// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "robots/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const JointLimits* /*of*/) {
  using S = JointLimits;
  static const Description all =
      Describe<S>("robots", "JointLimits",
                  "Limits of a joint, before those of its description.")
          .field("lower", &S::lower,
                 "Least position [{rad or m}]",
                 {.infinite = true})
          .field("upper", &S::upper,
                 "Largest position [{rad or m}]",
                 {.infinite = true})
          .field("velocity", &S::velocity,
                 "Largest speed [{rad/s or m/s}]",
                 {.least = 0, .infinite = true})
          .field("effort", &S::effort,
                 "Largest torque or force of the motor [{Nm or N}]",
                 {.least = 0, .infinite = true})
          .more("In robots with loops 0 is a hinge without a motor");
  return all;
}

const Description& description_of(const JointFigures* /*of*/) {
  using S = JointFigures;
  static const Description all =
      Describe<S>("robots", "JointFigures",
                  "Drive and spring of a joint, before those of its description.")
          .field("armature", &S::armature,
                 "Inertia of the drive, seen at the joint [{kg m^2 or kg}]",
                 {.least = 0})
          .field("damping", &S::damping,
                 "Viscous friction [{Nms/rad or Ns/m}]",
                 {.least = 0})
          .field("friction", &S::friction,
                 "Coulomb friction [{Nm or N}]",
                 {.least = 0})
          .field("stiffness", &S::stiffness,
                 "Stiffness of a spring in the joint [{Nm/rad or N/m}]",
                 {.least = 0})
          .field("rest", &S::rest,
                 "Position where that spring is at rest [{rad or m}]")
          .field("rotor_inertia", &S::rotor_inertia,
                 "Inertia of the rotor about its own axis [{kg m^2}], of which `gear_ratio`^2 "
                 "times as much is added to the armature",
                 {.least = 0})
          .field("gear_ratio", &S::gear_ratio,
                 "Turns of the rotor per turn of the joint, or rad per m of one that slides; 1 "
                 "unless stated")
          .more("It stands beside a `rotor_inertia`");
  return all;
}

const Description& description_of(const RobotSettings* /*of*/) {
  using S = RobotSettings;
  static const Description all =
      Describe<S>("robots", "RobotSettings",
                  "What a settings file, or one variant in it, states.")
          .field("urdf", &S::urdf,
                 "URDF file, relative to the settings: it or `mjcf` is needed")
          .field("mjcf", &S::mjcf,
                 "MJCF file, relative to the settings, in place of `urdf`")
          .field("srdf", &S::srdf,
                 "SRDF file, relative to the settings, whose `group_state`s are postures too; the"
                 " settings' own of the same name go before")
          .field("description", &S::description,
                 "One line for `burnish --robots`")
          .field("base", &S::base,
                 "`fixed` or `free_flyer`; `fixed` unless stated")
          .field("base_placement", &S::base_placement,
                 "Placement of the root link in the world: `xyz` with `rpy` (about fixed x, then "
                 "y, then z), `quaternion` or `matrix`; identity unless stated")
          .more("With a free-flyer it is that of the neutral configuration")
          .field("lock", &S::lock,
                 "Joints to hold: a list; none unless stated")
          .field("free", &S::free,
                 "Joints to leave free, all others being held: a list, not beside `lock`; all "
                 "unless stated")
          .field("posture", &S::posture,
                 "Name of the posture at which joints are held; `default_posture`, or zero, "
                 "unless stated")
          .field("default_posture", &S::default_posture,
                 "Name of the posture that commands start from; the neutral configuration unless "
                 "stated")
          .field("postures", &S::postures,
                 "By name: values by joint, one number each; for a planar joint `[x, y, angle]`, "
                 "for a ball `[qx, qy, qz, qw]`, for a floating one or `root_joint`, the "
                 "free-flying base, `[x, y, z, qx, qy, qz, qw]`")
          .more("Joints that are not named are at zero; `from` names a posture above that it "
                "begins as")
          .field("frames", &S::frames,
                 "By name: `parent` (a link, a joint or a frame above) and the placement in it, "
                 "as of `base_placement`")
          .more("Commands take `tool` unless told otherwise")
          .field("limits", &S::limits,
                 "By joint: limits that go before those of the file, `.inf` for none; any of the "
                 "keys below")
          .field("joints", &S::joints,
                 "By joint: drive and spring, before those of the file; any of the keys below")
          .field("loops", &S::loops,
                 "By name: `between` (two links, one of which may be `world`), `first` and "
                 "`second` (placements in them, as of `base_placement`), `directions` that are "
                 "held (`[x, y, z]` unless stated), as in [loops](#loops)")
          .field("inertias", &S::inertias,
                 "By link: `mass` (kg), `com` (m, link axes) and `inertia` (kg m^2 about `com`: "
                 "`[xx, xy, xz, yy, yz, zz]`, or three along the axes), in the place of the "
                 "file's")
          .field("payload", &S::payload,
                 "What the robot carries: `frame` (`tool` unless stated), and `mass`, `com` and "
                 "`inertia` in its axes; nothing unless stated")
          .more("Found as [identification.md](identification.md) says");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
