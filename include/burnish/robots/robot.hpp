// A robot folder: a description file and a small settings file with postures and variants.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/model.hpp"

namespace burnish {

/// A compiled robot with its named postures.
struct Robot {
  Model model;
  std::map<std::string, Posture> postures;
  std::string default_posture;  ///< name in postures, or empty
  /// Collision geometry of a URDF file; no dynamics uses it. find_feet() does.
  std::vector<Visual> collisions;
  /// What is odd about its files but computes, one sentence each: those of the model and others.
  std::vector<std::string> warnings;
  /// What its files hold that dynamics does not need, one sentence each: never refused.
  std::vector<std::string> notes;

  /// Configuration of a named posture; of a robot with loops one that closes them
  /// (closed_configuration() in contact/loops.hpp). Throws Error with the nearest known name, and
  /// where loops cannot be closed.
  Eigen::VectorXd posture(const std::string& name) const;
  /// The default posture, or the neutral configuration when there is none, with loops closed.
  Eigen::VectorXd reference_configuration() const;
};

/// Changes to what the settings file says, as a command line gives them.
struct RobotOverrides {
  std::optional<Base> base;
  std::vector<std::string> locked;  ///< in addition to what the settings lock
  std::vector<std::string> free;    ///< these alone move, whatever the settings lock or free
  /// A link or joint: of a robot without settings only what carries it moves, since nothing says
  /// what another arm or a head do meanwhile. Fingers of a gripper that carry it are held too,
  /// which a note says. Empty or unknown: all joints move.
  std::string carrying;
  /// Named posture at which joints are locked; empty: the settings' `posture`, then their
  /// `default_posture`, then zero.
  std::string posture;
  std::string srdf;     ///< file whose group_states are postures too; empty: as load_robot says
  bool strict = false;  ///< refuse what would be a warning
};

/// Loads a robot by
///  - a URDF or MJCF file (`arm.urdf`, `arm.xml`), told apart by what is in it, or whatever else a
///    path leads to, such as /dev/stdin or a pipe,
///  - a settings file (`robots/talos/robot.yaml`), with `:variant` behind it if wanted,
///  - a folder that holds robot.yaml (`robots/talos`, `robots/talos:right_arm`),
///  - the name of a robot that came with the library (`talos`, `talos:right_arm`), looked up in
///    $BURNISH_ROBOTS, then in share/burnish/robots around the program or library that runs, then
///    where the library was built or installed.
/// Throws Error naming the file, the place in it and what was wanted, all problems of a URDF file
/// at once. What is odd but computes is in the result's `warnings`.
///
/// A settings file, of which docs/robots.md has all keys (angles in rad, lengths in m):
///
///     urdf: talos.urdf                 # beside the settings file; or mjcf: talos.xml
///     description: one line
///     base: free_flyer                 # or fixed, which is the default
///     base_placement: {xyz: [0, 0, 1.02], rpy: [0, 0, 0]}
///     lock: [joint, ...]               # or free: [joint, ...], which locks all others
///     posture: name                    # at which joints are locked; default_posture, or zero
///     default_posture: name            # of reference_configuration()
///     postures: {name: {joint: value or list of values, from: name of one above, ...}, ...}
///     frames: {name: {parent: frame, xyz: [0, 0, 0], rpy: [0, 0, 0]}, ...}
///     limits: {joint: {lower: -1, upper: 1, velocity: 2, effort: 40}, ...}  # before the URDF's
///     loops: {name: {between: [link, link], first: {xyz: [0, 0, 0]}, second: {xyz: [0, 0, 0]},
///                    directions: [x, y, z]}, ...}  # that close chains; placements are in the
///                    links
///     srdf: talos.srdf                 # its group_states are postures too
///     variants: {name: {any of the keys above}, ...}
///
/// Frames, postures and gravity of an MJCF file are the robot's; what settings state goes before,
/// and without a default posture there that is the file's "home", or else how it draws the robot.
/// Without settings the SRDF file beside a URDF file, or in ../srdf, that has its name is read; the
/// postures of the settings go before those of an SRDF file. Loops of the settings go before those
/// of the description that have their names. Where the values of a posture leave a loop open by
/// more than 1 mm or 0.1 degrees, a warning says so, unless it leaves joints to close it with.
///
/// A variant's keys replace those of the file; what it has by name is added, replacing what has the
/// same name; its `lock` or `free` replaces the file's `lock` and `free`.
Robot load_robot(const std::string& name, const RobotOverrides& overrides = {});

/// Folders searched for robots by name, in order.
std::vector<std::filesystem::path> robot_search_path();

}  // namespace burnish
