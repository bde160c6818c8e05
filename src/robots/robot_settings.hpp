// The settings file of a robot folder, read strictly.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/inertia.hpp"
#include "burnish/robots/robot.hpp"

namespace burnish {

/// Limits of a joint. They replace the limits in the robot's description.
/// @described robots
struct JointLimits {
  std::optional<double> lower;     ///< Lower position limit [rad or m], finite or infinite
  std::optional<double> upper;     ///< Upper position limit [rad or m], finite or infinite
  std::optional<double> velocity;  ///< Velocity limit [rad/s or m/s], >= 0 or infinite
  /// Effort limit: largest torque or force of the motor [Nm or N], >= 0 or infinite
  /// @more In a robot with loops, 0 means a hinge without a motor
  std::optional<double> effort;
};

/// Drive and spring parameters of a joint. They replace the values in the robot's description.
/// @described robots
struct JointFigures {
  /// Inertia of the drive, reflected to the joint [kg m^2 or kg], >= 0
  std::optional<double> armature;
  std::optional<double> damping;    ///< Viscous friction [Nms/rad or Ns/m], >= 0
  std::optional<double> friction;   ///< Coulomb friction [Nm or N], >= 0
  std::optional<double> stiffness;  ///< Stiffness of a spring in the joint [Nm/rad or N/m], >= 0
  std::optional<double> rest;       ///< Joint position at which the spring is at rest [rad or m]
  /// Inertia of the rotor about its own axis [kg m^2], >= 0
  /// @more `gear_ratio`^2 times this inertia is added to the armature
  std::optional<double> rotor_inertia;
  /// Turns of the rotor per turn of the joint (default: 1)
  /// @more For a prismatic joint: rotor angle per travel, in rad/m. Requires `rotor_inertia`
  std::optional<double> gear_ratio;
};

/// Contents of a settings file, or of one variant in it.
/// @described robots
/// If the file does not state a key, the member is empty: an optional without a value, or a map or
/// list without entries. Variants state only the keys that differ.
struct RobotSettings {
  /// URDF file, relative to the settings file; either `urdf` or `mjcf` is required
  std::optional<std::string> urdf;
  std::optional<std::string> mjcf;  ///< MJCF file, relative to the settings file, instead of `urdf`
  /// SRDF file, relative to the settings file; each `group_state` in it is a posture
  /// @more Postures of the settings replace SRDF postures of the same name
  std::optional<std::string> srdf;
  /// Description of the robot in one line, shown by `burnish --robots`
  std::optional<std::string> description;
  std::optional<Base> base;  ///< Base of the robot: `fixed` (default) or `free_flyer`
  /// Placement of the root link in the world (default: identity): `xyz` with `rpy` (about fixed x,
  /// then y, then z), `quaternion` or `matrix`
  /// @more With a free-flyer, this is the placement in the neutral configuration
  std::optional<Eigen::Isometry3d> base_placement;
  std::optional<std::vector<std::string>> lock;  ///< List of joints to lock (default: none)
  /// List of joints that stay free; all other joints are locked (default: all joints stay free)
  /// @more Cannot be combined with `lock`
  std::optional<std::vector<std::string>> free;
  /// Name of the posture at which joints are locked (default: `default_posture`, else zero)
  std::optional<std::string> posture;
  /// Name of the posture that commands start from (default: the neutral configuration)
  /// @more With an MJCF file, the default is its posture `home`, else the posture in which the file
  /// draws the robot
  std::optional<std::string> default_posture;
  /// Postures by name, each with values by joint: one number, or for a planar joint `[x, y,
  /// angle]`, for a ball joint `[qx, qy, qz, qw]`, for a floating joint `[x, y, z, qx, qy, qz, qw]`
  /// @more The floating joint of a free-flying base is `root_joint`. Joints without a value are at
  /// zero. The key `from` names an earlier posture whose values are copied first
  std::map<std::string, Posture> postures;
  /// Frames by name: `parent` (a link, a joint or an earlier frame) and the placement in the
  /// parent, with the keys of `base_placement`
  /// @more Commands use the frame `tool` unless another frame is stated
  /// @note In the order of the file.
  std::vector<FrameSpec> frames;
  /// Limits by joint, with any of the keys below; they replace the limits of the file (`.inf`: no
  /// limit)
  std::map<std::string, JointLimits> limits;
  /// Drive and spring parameters by joint, with any of the keys below; they replace the values of
  /// the file
  std::map<std::string, JointFigures> joints;
  /// Loops by name: `between` (two links, one of which may be `world`), `first` and `second` (the
  /// placement of a frame in each link, with the keys of `base_placement`), `directions` (the
  /// constrained directions, by default `[x, y, z]`)
  /// @more See [loops](#loops)
  /// @note In the order of the file.
  std::vector<LoopSpec> loops;
  /// Inertias by link: `mass` (kg), `com` (m, in link axes) and `inertia` (kg m^2, about `com`)
  /// @more `inertia` is `[xx, xy, xz, yy, yz, zz]`, or three moments along the link axes. The
  /// values replace the values of the file
  std::map<std::string, InertiaSpec> inertias;
  /// Payload that the robot carries (default: none): `frame` (by default `tool`), and `mass`, `com`
  /// and `inertia` in the axes of that frame
  /// @more [identification.md](identification.md) describes how to identify a payload
  std::optional<Payload> payload;
};

/// Settings file of a robot: the settings themselves, and its variants by name.
struct RobotSettingsFile {
  RobotSettings common;
  std::map<std::string, RobotSettings> variants;
};

/// Reads the settings file of a robot. Errors name the file, the line and the key, and state the
/// requirement.
RobotSettingsFile read_robot_settings(const std::filesystem::path& file);
/// Reads the settings of a robot from the text of a settings file. Error messages use `name` as the
/// file's name.
RobotSettingsFile parse_robot_settings(const std::string& text, const std::string& name);

/// Returns `common` overwritten by the keys that `variant` states; named entries are merged.
RobotSettings with_variant(RobotSettings common, const RobotSettings& variant);

/// SRDF file of a robot, if there is one. If the file was not asked for, its problems become
/// warnings, because they must not prevent loading.
struct SrdfFile {
  std::filesystem::path file;
  bool asked_for = false;  ///< Whether the settings or the command line name the file
};

/// Builds a robot from its settings and its description `tree`. Error messages use `origin` as the
/// name of the settings file. Frames and postures of the settings replace those of the description
/// that have the same name.
Robot make_robot(RobotSettings settings, const RobotOverrides& overrides, const std::string& origin,
                 TreeSpec tree, const SrdfFile& srdf = {});

}  // namespace burnish
