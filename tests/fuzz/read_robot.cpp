#include <filesystem>
#include <map>

#include "burnish/urdf/urdf.hpp"
#include "fuzz/readers.hpp"
#include "robots/robot_settings.hpp"

namespace burnish::fuzz {
namespace {

/// Returns one of the descriptions in the source tree for any name in the settings. Each is read
/// once; no other file is read.
const TreeSpec& description(const std::string& urdf) {
  static const auto trees = [] {
    std::map<std::string, TreeSpec> result;
    for (const char* name : {"arm7", "crane", "four_bar", "pendulum", "quadruped", "talos"}) {
      const std::string file = std::string(name) + ".urdf";
      result[file] = read_urdf(std::filesystem::path(BURNISH_ROBOTS_DIR) / name / file);
    }
    return result;
  }();
  const auto found = trees.find(urdf);
  return found == trees.end() ? trees.at("arm7.urdf") : found->second;
}

void load(const RobotSettings& settings) {
  make_robot(settings, {}, "robot.yaml", description(settings.urdf.value_or("")));
}

void read(const std::string& text) {
  const RobotSettingsFile file = parse_robot_settings(text, "robot.yaml");
  // Three variants are enough, because a robot is loaded with a single variant.
  int variants = 3;
  for (const auto& [name, variant] : file.variants) {
    if (variants-- == 0) break;
    try {
      load(with_variant(file.common, variant));
    } catch (const Error&) {
      // Tries the next variant.
    }
  }
  load(file.common);
}

}  // namespace

const Reader robot{"robot", read};

}  // namespace burnish::fuzz
