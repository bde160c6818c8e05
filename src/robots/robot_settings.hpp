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

/// Limits of a joint that go before those of the description.
struct JointLimits {
  std::optional<double> lower, upper, velocity, effort;
};

/// What the drive and the spring of a joint are, before what the description states of them. A
/// rotor's inertia (kg m^2, about its own axis) adds gear_ratio^2 times itself to the armature; the
/// ratio is turns of the rotor per turn of the joint, or rad per m of one that slides.
struct JointFigures {
  std::optional<double> armature, damping, friction, stiffness, rest, rotor_inertia, gear_ratio;
};

/// What a settings file, or one variant in it, states. Keys that are absent are empty.
struct RobotSettings {
  std::optional<std::string> urdf;  ///< as written, relative to the settings file
  std::optional<std::string> mjcf;  ///< the same; one of the two
  std::optional<std::string> srdf;  ///< the same
  std::optional<std::string> description;
  std::optional<Base> base;
  std::optional<Eigen::Isometry3d> base_placement;
  std::optional<std::vector<std::string>> lock, free;  ///< at most one of the two
  std::optional<std::string> posture, default_posture;
  std::map<std::string, Posture> postures;
  std::vector<FrameSpec> frames;  ///< in the order of the file
  std::map<std::string, JointLimits> limits;
  std::map<std::string, JointFigures> joints;
  std::vector<LoopSpec> loops;                  ///< in the order of the file
  std::map<std::string, InertiaSpec> inertias;  ///< of links, in the place of the URDF's
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
