// Loading of robots. A robot's folder has a description file (URDF or MJCF), and a settings file
// with postures and variants.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// A robot: the Model and named postures.
struct Robot {
  Model model;
  std::map<std::string, Posture> postures;
  std::string default_posture;  ///< Name of the default posture; empty if there is none

  /// Collision shapes of a URDF file. find_feet() uses them; dynamics ignores them.
  std::vector<Visual> collisions;
  /// Warnings about odd but usable content of the robot's files, one sentence each. Warnings of the
  /// model are included.
  std::vector<std::string> warnings;
  /// Notes on content of the robot's files that does not affect dynamics, one sentence each. Such
  /// content never causes an Error, even if loading is strict.
  std::vector<std::string> notes;

  /// Returns the configuration of a named posture. If the robot has kinematic loops, the
  /// configuration is adjusted to close the loops (see closed_configuration()). Throws Error if the
  /// loops cannot be closed, or with the nearest known name if no posture has this name.
  Eigen::VectorXd posture(const std::string& name) const;
  /// Returns the configuration of the default posture, or the neutral configuration if there is no
  /// default posture. Kinematic loops are closed in both cases.
  Eigen::VectorXd reference_configuration() const;
};

/// Changes to the settings of a robot, for example from a command line.
struct RobotOverrides {
  std::optional<Base> base;
  std::vector<std::string>
      locked;  ///< Joints to lock, in addition to the locked joints of the settings file

  /// Joints that move; all other joints are locked. Replaces `lock` and `free` of the settings
  /// file. Empty: no change.
  std::vector<std::string> free;

  /// Name of the link, joint or frame to which a tool is attached. This name has an effect only for
  /// a robot without a settings file. Joints that do not move the tool, such as joints of another
  /// arm or a head, are then locked, since nothing would define their motion. Fingers of a gripper
  /// are locked too, and a note reports this. If only fingers move the tool, they stay free. If the
  /// name is empty or unknown, all joints move.
  std::string carrying;
  /// Name of the posture in which joints are locked. If the name is empty, `posture` of the
  /// settings file is used, else its `default_posture`, else zero positions.
  std::string posture;
  /// SRDF file with named postures (group_states). If empty, load_robot() searches for an SRDF
  /// file.
  std::string srdf;
  bool strict = false;  ///< Treat warnings about the robot as errors
};

/// Loads a robot. `name` is one of
///  - a URDF or MJCF file (`arm.urdf`, `arm.xml`), or any other readable path, such as /dev/stdin
///    or a pipe; the content shows whether it is URDF or MJCF;
///  - a settings file (`robots/talos/robot.yaml`), optionally followed by `:variant`;
///  - a folder with a robot.yaml (`robots/talos`, `robots/talos:right_arm`);
///  - the name of a robot that comes with the library (`talos`, `talos:right_arm`).
///
/// Robots of the library are searched in the folders of robot_search_path(): $BURNISH_ROBOTS, then
/// share/burnish/robots in a folder above the running program or library, then the folder where the
/// library was built or installed.
///
/// Throws Error with the file, the place in the file and the requirement. One Error lists all
/// problems of a URDF file. Odd but usable content is reported in `warnings` of the result.
///
/// Example of a settings file; docs/robots.md has all keys. All keys except `urdf` or `mjcf` are
/// optional. Angles are in rad, lengths in m.
///
///     urdf: talos.urdf                 # in the folder of the settings; or mjcf: talos.xml
///     description: one line
///     base: free_flyer                 # or fixed, the default
///     base_placement: {xyz: [0, 0, 1.02], rpy: [0, 0, 0]}
///     lock: [joint, ...]               # or free: [joint, ...], which locks all others
///     posture: name                    # in which joints are locked; else default_posture, or zero
///     default_posture: name            # returned by reference_configuration()
///     postures: {name: {joint: value or list of values, from: an earlier posture, ...}, ...}
///     frames: {name: {parent: frame, xyz: [0, 0, 0], rpy: [0, 0, 0]}, ...}
///     limits: {joint: {lower: -1, upper: 1, velocity: 2, effort: 40}, ...}  # replace the URDF's
///     loops: {name: {between: [link, link], first: {xyz: [0, 0, 0]}, second: {xyz: [0, 0, 0]},
///                    directions: [x, y, z]}, ...}  # close chains; placements in the links
///     srdf: talos.srdf                 # its group_states become postures
///     variants: {name: {any of the keys above}, ...}
///
/// An MJCF file can also state frames, postures and gravity. Frames and postures of the settings
/// take precedence over those of the MJCF file. Without a default posture in the settings, the
/// posture "home" of the MJCF file is used. Without "home", the initial configuration of the MJCF
/// file is used.
///
/// If a URDF file is loaded without settings, an SRDF file with the same name is read too, from the
/// same folder or ../srdf. Postures of the settings take precedence over postures of an SRDF file.
/// Loops of the settings take precedence over loops of the same name in the description.
///
/// If a posture leaves a kinematic loop open, Robot::posture() moves joints to close the loop.
/// load_robot() throws Error if that is not possible. If a posture has values for all joints, a
/// warning reports a loop with a gap above 1 mm or 0.1 degrees.
///
/// The keys of a variant replace the same keys of the settings file. Keys with named entries, such
/// as postures, are merged: an entry of the variant replaces the entry of the same name. A `lock`
/// or `free` of the variant replaces both `lock` and `free` of the settings file.
Robot load_robot(const std::string& name, const RobotOverrides& overrides = {});

/// Returns the folders that are searched for robots by name, in search order.
std::vector<std::filesystem::path> robot_search_path();

}  // namespace burnish
