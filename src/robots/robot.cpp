#include "burnish/robots/robot.hpp"

#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "base/findings.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "base/words_in.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/mjcf/mjcf.hpp"
#include "burnish/model/state.hpp"
#include "burnish/urdf/urdf.hpp"
#include "model/loops.hpp"
#include "robots/carrying_joints.hpp"
#include "robots/description.hpp"
#include "robots/joint_settings.hpp"
#include "robots/known_robots.hpp"
#include "robots/robot_settings.hpp"
#include "urdf/srdf.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

constexpr const char* settings_name = "robot.yaml";

/// File and variant that a robot's name refers to.
struct Place {
  fs::path file;        ///< Description or settings file
  std::string variant;  ///< Name of the variant, empty for none
};

std::string lower_extension(const fs::path& file) { return lower_case(file.extension().string()); }
bool is_settings(const fs::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".yaml" || extension == ".yml";
}

/// Returns the file at a path, or the robot.yaml in a folder. Returns nothing if it does not exist.
std::optional<fs::path> file_at(const fs::path& path) {
  std::error_code ignored;  // an inaccessible file counts as missing
  if (fs::is_directory(path, ignored)) {
    const fs::path settings = path / settings_name;
    return fs::exists(settings, ignored) ? std::optional(settings) : std::nullopt;
  }
  return fs::exists(path, ignored) ? std::optional(path) : std::nullopt;
}

template <class Value>
std::vector<std::string> keys_of(const std::map<std::string, Value>& named) {
  std::vector<std::string> names;
  for (const auto& [name, value] : named) names.push_back(name);
  return names;
}

[[noreturn]] void refuse_name(const std::string& name) {
  if (is_robot_path(name)) {
    std::error_code ignored;
    const std::string hint =
        fs::is_directory(name, ignored) ? " has no robot.yaml" : " does not exist";
    constexpr std::size_t max_length = 300;  // longer names are shortened, chosen by hand
    const std::string path = name.size() > max_length ? name.substr(0, max_length) + "..." : name;
    refuse(path, "it" + hint + "; wanted a .urdf file, a .yaml file or a folder with robot.yaml");
  }
  const std::vector<std::string> existing = keys_of(known_robots());
  std::string nearest = did_you_mean(name, existing);
  if (nearest.empty()) {
    for (const std::string& robot : existing) nearest += (nearest.empty() ? "" : ", ") + robot;
    nearest = "; available robots: " + (nearest.empty() ? "none" : nearest);
  }
  throw Error("robot " + in_quotes(name) + " does not exist" + nearest);
}

Place find_robot(const std::string& name) {
  if (const auto file = robot_file(name)) return {*file, ""};
  const std::size_t colon = name.rfind(':');
  if (colon == std::string::npos) refuse_name(name);
  const std::string robot = name.substr(0, colon);
  const std::string variant = name.substr(colon + 1);
  const auto file = robot_file(robot);
  if (!file) refuse_name(robot);
  if (variant.empty()) {
    throw Error("robot " + in_quotes(name) + " ends with a colon; wanted a variant after it");
  }
  if (!is_settings(*file)) {
    throw Error("robot " + in_quotes(name) + " has the variant " + in_quotes(variant) + ", but " +
                in_quotes(robot) +
                " is a description, and only settings files have variants; wanted a settings file, "
                "or no variant");
  }
  return {*file, variant};
}

RobotSettings settings_at(const Place& place) {
  if (!is_settings(place.file)) return {};
  RobotSettingsFile file = read_robot_settings(place.file);
  if (place.variant.empty()) return std::move(file.common);
  const auto variant = file.variants.find(place.variant);
  if (variant == file.variants.end()) {
    refuse(place.file.string(), "variant " + in_quotes(place.variant) + " does not exist" +
                                    did_you_mean(place.variant, keys_of(file.variants)));
  }
  return with_variant(std::move(file.common), variant->second);
}

/// Returns the posture `name`. Error messages use `key`, the source of the name.
const Posture& find_posture(const RobotSettings& settings, const std::string& name,
                            const std::string& origin, const std::string& key) {
  const auto found = settings.postures.find(name);
  if (found != settings.postures.end()) return found->second;
  refuse(origin, key + ": posture " + in_quotes(name) + " does not exist" +
                     did_you_mean(name, keys_of(settings.postures)));
}

/// Returns the posture at which joints are locked.
Posture locking_posture(const RobotSettings& settings, const RobotOverrides& overrides,
                        const std::string& origin) {
  if (!overrides.posture.empty()) {
    return find_posture(settings, overrides.posture, origin, "requested posture");
  }
  if (settings.posture) return find_posture(settings, *settings.posture, origin, "key 'posture'");
  if (!settings.default_posture) return {};
  return find_posture(settings, *settings.default_posture, origin, "key 'default_posture'");
}

ModelOptions options_of(const RobotSettings& settings, const RobotOverrides& overrides,
                        const std::string& origin) {
  ModelOptions options;
  options.strict = overrides.strict;
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
    // In ModelOptions, an empty list of free joints leaves all joints free.
    refuse(origin, "all joints in the list `free` are locked; wanted at least one free joint");
  }
  return options;
}

/// Adds postures of the description to the settings, except those that the settings replace.
/// Removes from the description the frames that the settings replace. If the settings have no
/// default posture, `home` or `qpos0` of the description becomes the default posture.
void take_over(TreeSpec& tree, RobotSettings& settings) {
  const auto is_stated = [&](const FrameSpec& frame) {
    return std::any_of(settings.frames.begin(), settings.frames.end(),
                       [&](const FrameSpec& stated) { return stated.name == frame.name; });
  };
  tree.frames.erase(std::remove_if(tree.frames.begin(), tree.frames.end(), is_stated),
                    tree.frames.end());
  for (const auto& [name, posture] : tree.postures) settings.postures.emplace(name, posture);
  if (settings.default_posture) return;
  for (const char* usual : {"home", "qpos0"}) {
    if (!tree.postures.contains(usual)) continue;
    settings.default_posture = usual;
    return;
  }
}

/// Adds the loops of the settings. They replace loops of the description with the same names.
void put_loops(const std::vector<LoopSpec>& loops, TreeSpec& tree) {
  for (const LoopSpec& loop : loops) {
    std::erase_if(tree.loops, [&](const LoopSpec& other) { return other.name == loop.name; });
    tree.loops.push_back(loop);
  }
}

void set_inertia(TreeSpec& tree, const std::string& name, const InertiaSpec& inertia,
                 const std::string& origin) {
  const auto link = std::find_if(tree.links.begin(), tree.links.end(),
                                 [&](const LinkSpec& spec) { return spec.name == name; });
  if (link == tree.links.end()) {
    std::vector<std::string> existing;
    for (const LinkSpec& spec : tree.links) existing.push_back(spec.name);
    refuse(origin,
           "inertias: link " + in_quotes(name) + " does not exist" + did_you_mean(name, existing));
  }
  link->inertia = inertia;
}

/// Returns the model with the payload of the settings.
Model loaded(Model model, const std::optional<Payload>& payload, const std::string& origin) {
  if (!payload) return model;
  try {
    return with_payload(std::move(model), *payload);
  } catch (const Error& error) {
    refuse(origin, error.what());
  }
}

/// Adds the postures of the SRDF file whose names the settings do not have. Returns their names.
std::vector<std::string> add_srdf(const SrdfFile& srdf, const TreeSpec& tree,
                                  RobotSettings& settings, Findings& findings) {
  std::map<std::string, Posture> postures;
  const auto read = [&] { postures = read_srdf(srdf.file, tree, findings); };
  if (srdf.asked_for) {
    read();
  } else {
    findings.attempt_or_warn(read, "; the file is ignored");
  }
  std::vector<std::string> names;
  for (auto& [name, posture] : postures) {
    if (settings.postures.emplace(name, std::move(posture)).second) names.push_back(name);
  }
  return names;
}

/// Removes the postures of an SRDF file that are not valid for the robot, with a warning.
void drop_bad_postures(const std::vector<std::string>& names, Robot& robot, Findings& findings) {
  for (const std::string& name : names) {
    try {
      closed_configuration(robot.model, robot.postures.at(name));
    } catch (const Error& error) {
      findings.warn("posture " + in_quotes(name) + ": " + error.what() +
                    "; this posture is ignored");
      robot.postures.erase(name);
    }
  }
}

/// Throws Error for an invalid posture. This reports errors on loading, before a posture is used.
void check_postures(const Robot& robot, const std::string& origin) {
  for (const auto& [name, posture] : robot.postures) {
    try {
      configuration(robot.model, posture);
    } catch (const Error& error) {
      refuse(origin, "posture " + in_quotes(name) + ": " + error.what());
    }
  }
}

/// Warns of postures with joints beyond their limits, which would end runs and solves at the first
/// step. Checks only joints with a value in the posture; loops may move the others.
void warn_beyond_limits(const Robot& robot, Findings& findings) {
  for (const auto& [name, posture] : robot.postures) {
    Eigen::VectorXd q = configuration(robot.model, posture);
    for (const Joint& joint : robot.model.joints)
      if (joint.nq == 1 && !posture.contains(joint.name))
        q[joint.q_index] = robot.model.q_lower[joint.q_index];
    const std::string beyond = beyond_limits(robot.model, q);
    if (!beyond.empty()) findings.warn("posture " + in_quotes(name) + ": " + beyond);
  }
}

/// Returns true if the posture has a value for every moving joint.
bool names_every_joint(const Model& model, const Posture& posture) {
  return std::all_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
    return joint.follows || joint.kind == JointKind::FreeFlyer || posture.contains(joint.name);
  });
}

/// Checks that the postures close the loops. Reports postures that cannot be closed as problems.
/// Warns of postures with values for all joints that leave a loop open.
void check_loops_closed(const Robot& robot, Findings& findings) {
  if (robot.model.loops.empty()) return;
  if (robot.default_posture.empty()) {
    try {
      closed_configuration(robot.model, {});
    } catch (const Error& error) {
      findings.problem("neutral posture: " + std::string(error.what()) +
                       "; wanted a default_posture near a posture that closes the loop");
    }
  }
  for (const auto& [name, posture] : robot.postures) {
    const std::string what = "posture " + in_quotes(name) + ": ";
    try {
      closed_configuration(robot.model, posture);
    } catch (const Error& error) {
      findings.problem(what + error.what());
      continue;
    }
    if (!names_every_joint(robot.model, posture)) continue;
    for (const LoopMiss& miss : loop_misses(robot.model, configuration(robot.model, posture))) {
      const LoopDistance distance{miss.translation, miss.rotation};
      if (!distance.closes())
        findings.warn(what + "its values leave loop " + in_quotes(miss.loop) + " open by " +
                      distance.text() + "; burnish moves the joints until the loop closes");
    }
  }
}

RobotDescription read_urdf_file(const fs::path& file) {
  const std::string text = read_text(file, "URDF file");
  return {parse_urdf(text, file.string()), parse_collisions(text, file.string())};
}

/// Returns the solids of links, placed on the bodies that carry the links.
std::vector<Visual> on_bodies(const std::vector<LinkSolid>& solids, const Model& model) {
  std::map<std::string, const Frame*> links;
  for (const Frame& frame : model.frames)
    if (frame.kind == FrameKind::Link) links.emplace(frame.name, &frame);
  std::vector<Visual> placed;
  for (const LinkSolid& solid : solids) {
    const auto link = links.find(solid.link);
    if (link == links.end()) continue;
    placed.push_back({solid.link, link->second->body, link->second->placement * solid.placement,
                      solid.shape, VisualSpec{}.rgba});
  }
  return placed;
}

/// Returns share/burnish/robots in the folder of this program or library, or in a folder above it.
/// This finds the robots of an installation that was moved.
std::optional<fs::path> robots_beside_the_library() {
#if __has_include(<dlfcn.h>)
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&robot_search_path), &info) == 0) return std::nullopt;
  std::error_code ignored;
  fs::path folder = fs::canonical(info.dli_fname, ignored).parent_path();
  // The deepest place in an installation is lib/python3.11/site-packages/burnish.
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
  if (found != postures.end()) return closed_configuration(model, found->second);
  refuse("robot " + in_quotes(model.name),
         "posture " + in_quotes(name) + " does not exist" + did_you_mean(name, keys_of(postures)));
}

Eigen::VectorXd Robot::reference_configuration() const {
  return default_posture.empty() ? closed_configuration(model, {}) : posture(default_posture);
}

bool is_robot_path(const std::string& name) {
  const std::string extension = lower_extension(name);
  return name.find('/') != std::string::npos || extension == ".urdf" || extension == ".xml" ||
         extension == ".mjcf" || is_settings(name);
}

std::optional<fs::path> robot_file(const std::string& name) {
  if (name.empty()) return std::nullopt;
  std::error_code ignored;
  if (is_robot_path(name)) return file_at(name);
  // Robots of the search path take precedence over the working folder.
  for (const fs::path& folder : robot_search_path()) {
    if (!fs::is_directory(folder / name, ignored)) continue;
    if (auto file = file_at(folder / name)) return file;
  }
  return fs::is_directory(name, ignored) || fs::is_regular_file(name, ignored) ? file_at(name)
                                                                               : std::nullopt;
}

fs::path description_file(const std::string& name) {
  try {
    const Place place = find_robot(name);
    const RobotSettings settings = settings_at(place);
    const fs::path folder = place.file.parent_path();
    if (settings.urdf) return folder / *settings.urdf;
    if (settings.mjcf) return folder / *settings.mjcf;
    return place.file;
  } catch (const Error&) {
    return {};
  }
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

Robot make_robot(RobotSettings settings, const RobotOverrides& overrides, const std::string& origin,
                 TreeSpec tree, const SrdfFile& srdf) {
  take_over(tree, settings);
  for (const auto& [joint, limits] : settings.limits) set_limits(tree, joint, limits, origin);
  for (const auto& [joint, figures] : settings.joints) set_figures(tree, joint, figures, origin);
  put_loops(settings.loops, tree);
  for (const auto& [link, inertia] : settings.inertias) set_inertia(tree, link, inertia, origin);
  Findings of_srdf(srdf.file.string());
  std::vector<std::string> from_srdf;
  if (!srdf.file.empty()) from_srdf = add_srdf(srdf, tree, settings, of_srdf);
  ModelOptions options = options_of(settings, overrides, origin);
  if (tree.gravity) options.gravity = *tree.gravity;
  std::vector<std::string> fingers;
  if (options.free.empty() && !overrides.carrying.empty())
    options.free = arm_joints(tree, overrides.carrying, fingers);
  Robot robot;
  robot.model = loaded(build_model(tree, options), settings.payload, origin);
  robot.postures = settings.postures;
  drop_bad_postures(from_srdf, robot, of_srdf);
  if (settings.default_posture) {
    find_posture(settings, *settings.default_posture, origin, "key 'default_posture'");
    robot.default_posture = *settings.default_posture;
  }
  check_postures(robot, origin);
  Findings of_postures(origin);
  check_loops_closed(robot, of_postures);
  of_postures.refuse_problems();
  warn_beyond_limits(robot, of_postures);
  if (overrides.strict) refuse_warnings(of_srdf.origin(), of_srdf.warnings());
  if (overrides.strict) refuse_warnings(of_postures.origin(), of_postures.warnings());
  robot.notes = robot.model.notes;
  for (const std::string& joint : fingers)
    robot.notes.push_back("joint " + in_quotes(joint) +
                          " is treated as a finger of a gripper and held at zero, although it "
                          "carries " +
                          in_quotes(overrides.carrying));
  robot.warnings = robot.model.warnings;
  robot.warnings.insert(robot.warnings.end(), of_srdf.warnings().begin(), of_srdf.warnings().end());
  robot.warnings.insert(robot.warnings.end(), of_postures.warnings().begin(),
                        of_postures.warnings().end());
  return robot;
}

Robot load_robot(const std::string& name, const RobotOverrides& overrides) {
  const Place place = find_robot(name);
  RobotOverrides applying = overrides;
  if (is_settings(place.file)) applying.carrying.clear();
  RobotSettings settings = settings_at(place);
  const fs::path folder = place.file.parent_path();
  SrdfFile srdf{overrides.srdf, true};
  if (srdf.file.empty() && settings.srdf) srdf.file = folder / *settings.srdf;
  if (srdf.file.empty() && !is_settings(place.file)) srdf = {srdf_of(place.file), false};
  RobotDescription file = settings.urdf   ? read_urdf_file(folder / *settings.urdf)
                          : settings.mjcf ? RobotDescription{read_mjcf(folder / *settings.mjcf)}
                                          : read_robot_description(place.file);
  Robot robot =
      make_robot(std::move(settings), applying, place.file.string(), std::move(file.tree), srdf);
  robot.collisions = on_bodies(file.collisions, robot.model);
  return robot;
}

}  // namespace burnish
