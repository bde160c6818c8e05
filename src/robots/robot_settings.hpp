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

/// Limits of a joint, before those of its description.
/// @described robots
struct JointLimits {
  std::optional<double> lower;     ///< Least position [rad or m], finite or infinite
  std::optional<double> upper;     ///< Largest position [rad or m], finite or infinite
  std::optional<double> velocity;  ///< Largest speed [rad/s or m/s], >= 0 or infinite
  /// Largest torque or force of the motor [Nm or N], >= 0 or infinite
  /// @more In robots with loops 0 is a hinge without a motor
  std::optional<double> effort;
};

/// Drive and spring of a joint, before those of its description.
/// @described robots
struct JointFigures {
  std::optional<double> armature;  ///< Inertia of the drive, seen at the joint [kg m^2 or kg], >= 0
  std::optional<double> damping;   ///< Viscous friction [Nms/rad or Ns/m], >= 0
  std::optional<double> friction;  ///< Coulomb friction [Nm or N], >= 0
  std::optional<double> stiffness;  ///< Stiffness of a spring in the joint [Nm/rad or N/m], >= 0
  std::optional<double> rest;       ///< Position where that spring is at rest [rad or m]
  /// Inertia of the rotor about its own axis [kg m^2], of which `gear_ratio`^2 times as much is
  /// added to the armature, >= 0
  std::optional<double> rotor_inertia;
  /// Turns of the rotor per turn of the joint, or rad per m of one that slides; 1 unless stated
  /// @more It stands beside a `rotor_inertia`
  std::optional<double> gear_ratio;
};

/// What a settings file, or one variant in it, states.
/// @described robots
/// Keys that are absent are empty. A value is an optional, a map or a list of what has a name, so
/// that variants can leave it.
struct RobotSettings {
  std::optional<std::string> urdf;  ///< URDF file, relative to the settings: it or `mjcf` is needed
  std::optional<std::string> mjcf;  ///< MJCF file, relative to the settings, in place of `urdf`
  /// SRDF file, relative to the settings, whose `group_state`s are postures too; the settings' own
  /// of the same name go before
  std::optional<std::string> srdf;
  std::optional<std::string> description;  ///< One line for `burnish --robots`
  std::optional<Base> base;                ///< `fixed` or `free_flyer`; `fixed` unless stated
  /// Placement of the root link in the world: `xyz` with `rpy` (about fixed x, then y, then z),
  /// `quaternion` or `matrix`; identity unless stated
  /// @more With a free-flyer it is that of the neutral configuration
  std::optional<Eigen::Isometry3d> base_placement;
  std::optional<std::vector<std::string>> lock;  ///< Joints to hold: a list; none unless stated
  /// Joints to leave free, all others being held: a list, not beside `lock`; all unless stated
  std::optional<std::vector<std::string>> free;
  /// Name of the posture at which joints are held; `default_posture`, or zero, unless stated
  std::optional<std::string> posture;
  /// Name of the posture that commands start from; the neutral configuration unless stated
  std::optional<std::string> default_posture;
  /// By name: values by joint, one number each; for a planar joint `[x, y, angle]`, for a ball
  /// `[qx, qy, qz, qw]`, for a floating one or `root_joint`, the free-flying base, `[x, y, z, qx,
  /// qy, qz, qw]`
  /// @more Joints that are not named are at zero; `from` names a posture above that it begins as
  std::map<std::string, Posture> postures;
  /// By name: `parent` (a link, a joint or a frame above) and the placement in it, as of
  /// `base_placement`
  /// @more Commands take `tool` unless told otherwise @note In the order of the file.
  std::vector<FrameSpec> frames;
  /// By joint: limits that go before those of the file, `.inf` for none; any of the keys below
  std::map<std::string, JointLimits> limits;
  /// By joint: drive and spring, before those of the file; any of the keys below
  std::map<std::string, JointFigures> joints;
  /// By name: `between` (two links, one of which may be `world`), `first` and `second` (placements
  /// in them, as of `base_placement`), `directions` that are held (`[x, y, z]` unless stated),
  /// as in [loops](#loops)
  /// @note In the order of the file.
  std::vector<LoopSpec> loops;
  /// By link: `mass` (kg), `com` (m, link axes) and `inertia` (kg m^2 about `com`: `[xx, xy, xz,
  /// yy, yz, zz]`, or three along the axes), in the place of the file's
  std::map<std::string, InertiaSpec> inertias;
  /// What the robot carries: `frame` (`tool` unless stated), and `mass`, `com` and `inertia` in its
  /// axes; nothing unless stated
  /// @more Found as [identification.md](identification.md) says
  std::optional<Payload> payload;
};

struct RobotSettingsFile {
  RobotSettings common;
  std::map<std::string, RobotSettings> variants;
};

/// Throws Error naming the file, the line, the key, and what was wanted.
RobotSettingsFile read_robot_settings(const std::filesystem::path& file);
/// The same from a text, called `name` in refusals.
RobotSettingsFile parse_robot_settings(const std::string& text, const std::string& name);

/// `common` with what `variant` states in its place.
RobotSettings with_variant(RobotSettings common, const RobotSettings& variant);

/// Where the SRDF file lies, if there is one. One that nobody asked for stops nothing.
struct SrdfFile {
  std::filesystem::path file;
  bool asked_for = false;
};

/// The robot that settings and a description make; `origin` stands for the settings' file in error
/// sentences. Frames and postures of the settings go before those of the description.
Robot make_robot(RobotSettings settings, const RobotOverrides& overrides, const std::string& origin,
                 TreeSpec tree, const SrdfFile& srdf = {});

}  // namespace burnish
