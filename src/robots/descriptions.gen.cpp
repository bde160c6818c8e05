// Written by scripts/describe --write from the headers of the layer; not to be edited.
// clang-format off
#include "robots/descriptions.gen.hpp"

// NOLINTBEGIN(readability-function-size,modernize-raw-string-literal): tables
namespace burnish {

const Description& description_of(const JointLimits* /*of*/) {
  using S = JointLimits;
  static const Description all =
      Describe<S>("robots", "JointLimits",
                  "Limits of a joint. They replace the limits in the robot's description.")
          .field("lower", &S::lower,
                 "Lower position limit [{rad or m}]",
                 {.infinite = true})
          .field("upper", &S::upper,
                 "Upper position limit [{rad or m}]",
                 {.infinite = true})
          .field("velocity", &S::velocity,
                 "Velocity limit [{rad/s or m/s}]",
                 {.least = 0, .infinite = true})
          .field("effort", &S::effort,
                 "Effort limit: largest torque or force of the motor [{Nm or N}]",
                 {.least = 0, .infinite = true})
          .more("In a robot with loops, 0 means a hinge without a motor");
  return all;
}

const Description& description_of(const JointFigures* /*of*/) {
  using S = JointFigures;
  static const Description all =
      Describe<S>("robots", "JointFigures",
                  "Drive and spring parameters of a joint. They replace the values in the robot's"
                  " description.")
          .field("armature", &S::armature,
                 "Inertia of the drive, reflected to the joint [{kg m^2 or kg}]",
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
                 "Joint position at which the spring is at rest [{rad or m}]")
          .field("rotor_inertia", &S::rotor_inertia,
                 "Inertia of the rotor about its own axis [{kg m^2}]",
                 {.least = 0})
          .more("`gear_ratio`^2 times this inertia is added to the armature")
          .field("gear_ratio", &S::gear_ratio,
                 "Turns of the rotor per turn of the joint (default: 1)")
          .more("For a prismatic joint: rotor angle per travel, in rad/m. Requires "
                "`rotor_inertia`");
  return all;
}

const Description& description_of(const RobotSettings* /*of*/) {
  using S = RobotSettings;
  static const Description all =
      Describe<S>("robots", "RobotSettings",
                  "Contents of a settings file, or of one variant in it.")
          .field("urdf", &S::urdf,
                 "URDF file, relative to the settings file; either `urdf` or `mjcf` is required")
          .field("mjcf", &S::mjcf,
                 "MJCF file, relative to the settings file, instead of `urdf`")
          .field("srdf", &S::srdf,
                 "SRDF file, relative to the settings file; each `group_state` in it is a posture")
          .more("Postures of the settings replace SRDF postures of the same name")
          .field("description", &S::description,
                 "Description of the robot in one line, shown by `burnish --robots`")
          .field("base", &S::base,
                 "Base of the robot: `fixed` (default) or `free_flyer`")
          .field("base_placement", &S::base_placement,
                 "Placement of the root link in the world (default: identity): `xyz` with `rpy` "
                 "(about fixed x, then y, then z), `quaternion` or `matrix`")
          .more("With a free-flyer, this is the placement in the neutral configuration")
          .field("lock", &S::lock,
                 "List of joints to lock (default: none)")
          .field("free", &S::free,
                 "List of joints that stay free; all other joints are locked (default: all joints"
                 " stay free)")
          .more("Cannot be combined with `lock`")
          .field("posture", &S::posture,
                 "Name of the posture at which joints are locked (default: `default_posture`, "
                 "else zero)")
          .field("default_posture", &S::default_posture,
                 "Name of the posture that commands start from (default: the neutral "
                 "configuration)")
          .more("With an MJCF file, the default is its posture `home`, else the posture in which "
                "the file draws the robot")
          .field("postures", &S::postures,
                 "Postures by name, each with values by joint: one number, or for a planar joint "
                 "`[x, y, angle]`, for a ball joint `[qx, qy, qz, qw]`, for a floating joint `[x,"
                 " y, z, qx, qy, qz, qw]`")
          .more("The floating joint of a free-flying base is `root_joint`. Joints without a value"
                " are at zero. The key `from` names an earlier posture whose values are copied "
                "first")
          .field("frames", &S::frames,
                 "Frames by name: `parent` (a link, a joint or an earlier frame) and the "
                 "placement in the parent, with the keys of `base_placement`")
          .more("Commands use the frame `tool` unless another frame is stated")
          .field("limits", &S::limits,
                 "Limits by joint, with any of the keys below; they replace the limits of the "
                 "file (`.inf`: no limit)")
          .field("joints", &S::joints,
                 "Drive and spring parameters by joint, with any of the keys below; they replace "
                 "the values of the file")
          .field("loops", &S::loops,
                 "Loops by name: `between` (two links, one of which may be `world`), `first` and "
                 "`second` (the placement of a frame in each link, with the keys of "
                 "`base_placement`), `directions` (the constrained directions, by default `[x, y,"
                 " z]`)")
          .more("See [loops](#loops)")
          .field("inertias", &S::inertias,
                 "Inertias by link: `mass` (kg), `com` (m, in link axes) and `inertia` (kg m^2, "
                 "about `com`)")
          .more("`inertia` is `[xx, xy, xz, yy, yz, zz]`, or three moments along the link axes. "
                "The values replace the values of the file")
          .field("payload", &S::payload,
                 "Payload that the robot carries (default: none): `frame` (by default `tool`), "
                 "and `mass`, `com` and `inertia` in the axes of that frame")
          .more("[identification.md](identification.md) describes how to identify a payload");
  return all;
}

}  // namespace burnish
// NOLINTEND(readability-function-size,modernize-raw-string-literal)
