// The settings file of a robot folder, read strictly.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/model/inertia.hpp"
#include "burnish/robots/robot.hpp"

namespace burnish {

/// Limits of a joint that go before those of the URDF.
struct JointLimits {
  std::optional<double> lower, upper, velocity, effort;
};

/// What a settings file, or one variant in it, states. Keys that are absent are empty.
struct RobotSettings {
  std::optional<std::string> urdf;  ///< as written, relative to the settings file
  std::optional<std::string> srdf;  ///< the same
  std::optional<std::string> description;
  std::optional<Base> base;
  std::optional<Eigen::Isometry3d> base_placement;
  std::optional<std::vector<std::string>> lock, free;  ///< at most one of the two
  std::optional<std::string> posture, default_posture;
  std::map<std::string, Posture> postures;
  std::vector<FrameSpec> frames;  ///< in the order of the file
  std::map<std::string, JointLimits> limits;
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

/// The robot that settings with a `urdf` describe; `read` reads that file, `origin` stands for the
/// settings' file in error sentences.
Robot make_robot(RobotSettings settings, const RobotOverrides& overrides, const std::string& origin,
                 const std::function<TreeSpec(const std::string& urdf)>& read,
                 const SrdfFile& srdf = {});

}  // namespace burnish
