#include "burnish/model/robot.hpp"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "burnish/model/urdf.hpp"
#include "model/known_robots.hpp"
#include "model/robot_settings.hpp"
#include "model/sentence.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* settings_name = "robot.yaml";

/// Where a robot's name leads.
struct Place {
  fs::path file;        // a URDF or a settings file
  std::string variant;  // empty for none
};

bool is_urdf(const fs::path& file) { return file.extension() == ".urdf"; }
bool is_settings(const fs::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}
bool looks_like_a_path(const std::string& name) {
  return name.find('/') != std::string::npos || is_urdf(name) || is_settings(name);
}

/// The file that a path means, if there is one.
std::optional<fs::path> file_at(const fs::path& path) {
  std::error_code ignored;  // what cannot be looked at does not exist here
  if (fs::is_directory(path, ignored)) {
    const fs::path settings = path / settings_name;
    return fs::exists(settings, ignored) ? std::optional(settings) : std::nullopt;
  }
  if (!fs::exists(path, ignored) || !(is_urdf(path) || is_settings(path))) return std::nullopt;
  return path;
}

std::optional<fs::path> file_of(const std::string& name) {
  if (name.empty()) return std::nullopt;
  if (auto file = file_at(name)) return file;
  if (looks_like_a_path(name)) return std::nullopt;
  for (const fs::path& folder : robot_search_path()) {
    if (auto file = file_at(folder / name)) return file;
  }
  return std::nullopt;
}

template <class Value>
std::vector<std::string> keys_of(const std::map<std::string, Value>& named) {
  std::vector<std::string> names;
  for (const auto& [name, value] : named) names.push_back(name);
  return names;
}

[[noreturn]] void refuse_name(const std::string& name) {
  if (looks_like_a_path(name)) {
    std::error_code ignored;
    const std::string hint =
        fs::is_directory(name, ignored) ? " holds no robot.yaml" : " does not exist";
    // No path is as long as text can be.
    constexpr std::size_t longest = 300;
    const std::string path = name.size() > longest ? name.substr(0, longest) + "..." : name;
    refuse(path, "it" + hint + "; wanted a .urdf file, a .yaml file or a folder with robot.yaml");
  }
  const std::vector<std::string> known = keys_of(known_robots());
  std::string nearest = did_you_mean(name, known);
  if (nearest.empty()) {
    for (const std::string& robot : known) nearest += (nearest.empty() ? "" : ", ") + robot;
    nearest = "; known are: " + (nearest.empty() ? "none" : nearest);
  }
  throw Error("robot " + in_quotes(name) + " is not known" + nearest);
}

Place find_robot(const std::string& name) {
  if (const auto file = file_of(name)) return {*file, ""};
  const std::size_t colon = name.rfind(':');
  if (colon == std::string::npos) refuse_name(name);
  const std::string robot = name.substr(0, colon);
  const std::string variant = name.substr(colon + 1);
  const auto file = file_of(robot);
  if (!file) refuse_name(robot);
  if (variant.empty()) {
    throw Error("robot " + in_quotes(name) + " ends with a colon; wanted a variant behind it");
  }
  if (is_urdf(*file)) {
    throw Error("robot " + in_quotes(name) + " asks for a variant of a URDF file; only settings " +
                "files have variants");
  }
  return {*file, variant};
}

RobotSettings settings_at(const Place& place) {
  if (is_urdf(place.file)) {
    RobotSettings settings;
    settings.urdf = place.file.filename().string();
    return settings;
  }
  RobotSettingsFile file = read_robot_settings(place.file);
  if (place.variant.empty()) return std::move(file.common);
  const auto variant = file.variants.find(place.variant);
  if (variant == file.variants.end()) {
    refuse(place.file.string(), "variant " + in_quotes(place.variant) + " does not exist" +
                                    did_you_mean(place.variant, keys_of(file.variants)));
  }
  return with_variant(std::move(file.common), variant->second);
}

/// The posture of that name; `key` says who asked for it.
const Posture& find_posture(const RobotSettings& settings, const std::string& name,
                            const std::string& origin, const std::string& key) {
  const auto found = settings.postures.find(name);
  if (found != settings.postures.end()) return found->second;
  refuse(origin, key + ": posture " + in_quotes(name) + " does not exist" +
                     did_you_mean(name, keys_of(settings.postures)));
}

/// Where locked joints are held.
Posture locking_posture(const RobotSettings& settings, const RobotOverrides& overrides,
                        const std::string& origin) {
  if (!overrides.posture.empty()) {
    return find_posture(settings, overrides.posture, origin, "posture asked for");
  }
  if (settings.posture) return find_posture(settings, *settings.posture, origin, "key 'posture'");
  if (!settings.default_posture) return {};
  return find_posture(settings, *settings.default_posture, origin, "key 'default_posture'");
}

ModelOptions options_of(const RobotSettings& settings, const RobotOverrides& overrides,
                        const std::string& origin) {
  ModelOptions options;
  options.base = overrides.base.value_or(settings.base.value_or(Base::Fixed));
  if (settings.base_placement) options.base_placement = *settings.base_placement;
  options.frames = settings.frames;
  options.posture = locking_posture(settings, overrides, origin);
  if (!overrides.free.empty()) {
    options.free = overrides.free;
    options.locked = overrides.locked;
    return options;
  }
  options.locked = settings.lock.value_or(std::vector<std::string>());
  options.locked.insert(options.locked.end(), overrides.locked.begin(), overrides.locked.end());
  if (!settings.free) return options;
  for (const std::string& name : *settings.free) {
    const auto& locked = overrides.locked;
    if (std::find(locked.begin(), locked.end(), name) == locked.end()) options.free.push_back(name);
  }
  if (options.free.empty()) {
    // An empty list would free every joint.
    refuse(origin, "every joint that the settings leave free is to be locked; leave one free");
  }
  return options;
}

/// A posture is used long after loading: what is wrong with it is said now.
void check_postures(const Robot& robot, const std::string& origin) {
  for (const auto& [name, posture] : robot.postures) {
    try {
      configuration(robot.model, posture);
    } catch (const Error& error) {
      refuse(origin, "posture " + in_quotes(name) + ": " + error.what());
    }
  }
}

/// share/burnish/robots in the folder of the program or library that this code is part of, or in
/// one of the folders around it: where an installation has it, wherever it was moved to.
std::optional<fs::path> robots_beside_the_library() {
#if __has_include(<dlfcn.h>)
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&robot_search_path), &info) == 0) return std::nullopt;
  std::error_code ignored;
  fs::path folder = fs::canonical(info.dli_fname, ignored).parent_path();
  // lib/python3.11/site-packages/burnish is the deepest that an installation puts it.
  constexpr int levels = 5;
  for (int level = 0; level < levels && folder.has_relative_path(); ++level) {
    const fs::path robots = folder / "share/burnish/robots";
    if (fs::is_directory(robots, ignored)) return robots;
    folder = folder.parent_path();
  }
#endif
  return std::nullopt;
}

}  // namespace

Eigen::VectorXd Robot::posture(const std::string& name) const {
  const auto found = postures.find(name);
  if (found != postures.end()) return configuration(model, found->second);
  refuse("robot " + in_quotes(model.name),
         "posture " + in_quotes(name) + " does not exist" + did_you_mean(name, keys_of(postures)));
}

Eigen::VectorXd Robot::reference_configuration() const {
  return default_posture.empty() ? model.q_neutral : posture(default_posture);
}

std::vector<fs::path> robot_search_path() {
  std::vector<fs::path> folders;
  if (const char* listed = std::getenv("BURNISH_ROBOTS")) {
    std::istringstream stream(listed);
    for (std::string folder; std::getline(stream, folder, ':');) {
      if (!folder.empty()) folders.emplace_back(folder);
    }
  }
  if (const auto beside = robots_beside_the_library()) folders.push_back(*beside);
  folders.emplace_back(BURNISH_SOURCE_ROBOTS);
  folders.emplace_back(BURNISH_INSTALLED_ROBOTS);
  return folders;
}

std::map<std::string, fs::path> known_robots() {
  std::map<std::string, fs::path> files;
  for (const fs::path& folder : robot_search_path()) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
      const auto file = file_at(entry.path());
      if (file && entry.is_directory(ignored)) files.emplace(entry.path().filename(), *file);
    }
  }
  return files;
}

Robot make_robot(const RobotSettings& settings, const RobotOverrides& overrides,
                 const std::string& origin,
                 const std::function<TreeSpec(const std::string& urdf)>& read) {
  const ModelOptions options = options_of(settings, overrides, origin);
  Robot robot;
  robot.model = build_model(read(*settings.urdf), options);
  robot.postures = settings.postures;
  if (settings.default_posture) {
    find_posture(settings, *settings.default_posture, origin, "key 'default_posture'");
    robot.default_posture = *settings.default_posture;
  }
  check_postures(robot, origin);
  return robot;
}

Robot load_robot(const std::string& name, const RobotOverrides& overrides) {
  const Place place = find_robot(name);
  return make_robot(
      settings_at(place), overrides, place.file.string(),
      [&](const std::string& urdf) { return read_urdf(place.file.parent_path() / urdf); });
}

}  // namespace burnish
