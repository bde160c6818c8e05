#include "draft_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/entry_error.hpp"
#include "base/to_size.hpp"
#include "base/whole_file.hpp"
#include "base/yaml_word.hpp"
#include "burnish/base/error.hpp"
#include "burnish/model/state.hpp"
#include "draft_feet.hpp"
#include "pressing/arm.hpp"
#include "pressing/tool_direction.hpp"
#include "robots/description.hpp"
#include "robots/grippers.hpp"
#include "show_json.hpp"
#include "urdf/srdf.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

/// Returns an angle as text, rounded to 0.1 urad.
std::string angle(double value) {
  constexpr double digits = 1e7;
  return fmt::format("{:.7g}", std::round(digits * value) / digits + 0.0);
}

/// Returns a number with four significant digits, for values that users will edit.
std::string brief(double value) { return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value); }

/// Returns the joint value nearest to zero that is at least a tenth of the joint's range away from
/// the limits. If only one limit is finite, the value may be at this limit.
double away_from_limits(const JointSpec& joint) {
  if (joint.type == JointType::Continuous) return 0.0;
  const double lower = joint.lower, upper = joint.upper;
  if (!std::isfinite(lower) || !std::isfinite(upper)) {
    return std::isfinite(lower) ? std::max(0.0, lower) : std::min(0.0, upper);
  }
  const double margin = 0.1 * (upper - lower);
  return std::clamp(0.0, lower + margin, upper - margin);
}

/// Returns the posture of the SRDF file that the draft should use as default; empty if none is
/// within the limits. Names such as "ready" are preferred. For each preferred posture beyond the
/// limits, a comment is appended to `passed_over`.
std::string likely_default(const Robot& robot, std::string& passed_over) {
  std::vector<std::string> names;
  for (const char* name : {"ready", "home", "half_sitting", "standing"})
    if (robot.postures.contains(name)) names.emplace_back(name);
  for (const auto& [name, posture] : robot.postures)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  for (const std::string& name : names) {
    const std::string beyond = beyond_limits(robot.model, robot.posture(name));
    if (beyond.empty()) return name;
    passed_over += fmt::format("# Posture {}: {}.\n", name, beyond);
  }
  return {};
}

/// Inputs from which the parts of a draft are written.
struct DraftInput {
  const Robot& robot;
  const TreeSpec& tree;        ///< Description of the robot, before any joints are locked.
  std::set<std::string> held;  ///< Moving joints that the draft locks.

  const JointSpec& spec(const Joint& joint) const {
    return *std::find_if(tree.joints.begin(), tree.joints.end(),
                         [&](const JointSpec& spec) { return spec.name == joint.name; });
  }
  /// Calls use(joint) for each joint with one velocity entry that the draft does not lock.
  template <class Use>
  void each_free(const Use& use) const {
    for (const Joint& joint : robot.model.joints)
      if (joint.nv == 1 && !held.contains(joint.name)) use(joint);
  }
};

/// Returns the values of locked joints whose range excludes zero, such as ", finger: 0.1".
std::string held_values(const DraftInput& drafted) {
  std::string text;
  for (const JointSpec& joint : drafted.tree.joints)
    if (drafted.held.contains(joint.name) && !joint.mimic &&
        (joint.lower > 0.0 || joint.upper < 0.0))
      text += fmt::format(", {}: {}", yaml_word(joint.name), brief(away_from_limits(joint)));
  return text;
}

std::string default_posture_text(const DraftInput& drafted, const DraftedFeet& feet) {
  std::string passed_over;
  const std::string stated = likely_default(drafted.robot, passed_over);
  if (!stated.empty()) return passed_over + fmt::format("default_posture: {}\n", yaml_word(stated));
  if (!feet.posture.empty())
    return passed_over +
           "default_posture: standing\npostures:\n"
           "  # Level soles; the base is a fifth lower than with straight legs.\n"
           "  standing: " +
           feet.posture + "\n";
  std::string text =
      passed_over +
      "default_posture: start\npostures:\n"
      "  # Zero, or a tenth of the range from a limit. Replace by a posture for the task;\n"
      "  # burnish polish --write-posture NAME adds a posture found by search.\n"
      "  start: {";
  bool first = true;
  drafted.each_free([&](const Joint& joint) {
    text += fmt::format("{}{}: {}", first ? "" : ", ", yaml_word(joint.name),
                        brief(away_from_limits(drafted.spec(joint))));
    first = false;
  });
  return text + held_values(drafted) + "}\n";
}

/// Returns the rotation of the frame `tool` relative to its parent. With this rotation, the tool
/// presses along its z or -z axis, in the direction of pressing::tool_direction() for the parent.
Eigen::Matrix3d tool_axes(const Model& model, const std::string& parent) {
  const auto [along, decided] = pressing::tool_direction(parent, std::nullopt, model);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  const bool is_along_z = std::abs(along.z()) > 1.0 - 1e-6;
  if (!is_along_z && !decided) return axes;
  if (!is_along_z)
    axes = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along).toRotationMatrix();
  Model with_tool = model;
  Frame frame = model.frames[to_size(model.frame_index(parent))];
  frame.name = "tool";
  frame.kind = FrameKind::User;
  frame.placement.linear() = frame.placement.linear() * axes;
  with_tool.frames.push_back(frame);
  const Eigen::Vector3d pressed =
      axes * pressing::tool_direction("tool", std::nullopt, with_tool).axis;
  if (pressed.dot(along) > 0.0) return axes;
  return axes * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

/// Returns whether a link is part of a leg.
bool is_on_leg(const Model& model, const std::string& link, const std::set<std::string>& legs) {
  for (int body = model.frames[to_size(model.frame_index(link))].body; body >= 0;
       body = model.joints[to_size(body)].parent)
    if (legs.contains(model.joints[to_size(body)].name)) return true;
  return false;
}

std::string tool_text(const DraftInput& drafted, const DraftedFeet& feet, const std::string& tool) {
  const Model& model = drafted.robot.model;
  if (model.has_frame("tool")) return "";
  std::vector<std::string> candidates = tool_candidates(model, drafted.held);
  std::erase_if(candidates,
                [&](const std::string& link) { return is_on_leg(model, link, feet.legs); });
  const std::string parent = tool.empty() && !candidates.empty() ? candidates.front() : tool;
  if (parent.empty()) return "";
  std::string text =
      "  # Default tool of the commands. The origin is the centre of a round tip, which presses\n"
      "  # along z or -z, away from the arm. Move it to the contact: xyz in m, rpy in rad.\n";
  if (tool.empty() && candidates.size() > 1) {
    text += "  # Other links at the end of a chain:";
    constexpr std::size_t max_listed = 12;
    for (std::size_t i = 1; i < std::min(candidates.size(), max_listed); ++i)
      text += fmt::format("{} {}", i == 1 ? "" : ",", candidates[i]);
    text += candidates.size() > max_listed ? ", ...\n" : "\n";
  }
  const Eigen::Vector3d rpy = roll_pitch_yaw(tool_axes(model, parent));
  return text + fmt::format("  tool: {{parent: {}, xyz: [0, 0, 0], rpy: [{}, {}, {}]}}\n",
                            yaml_word(parent), angle(rpy.x()), angle(rpy.y()), angle(rpy.z()));
}

/// Returns the limits in the robot's description, as lines. The efforts of followers, which the
/// model adds to the effort of their leader, are not included.
std::string limits_text(const DraftInput& drafted) {
  std::string text;
  drafted.each_free([&](const Joint& joint) {
    const JointSpec& spec = drafted.spec(joint);
    std::string entries;
    const auto add = [&](const char* key, double value) {
      if (std::isfinite(value))
        entries += fmt::format("{}{}: {}", entries.empty() ? "" : ", ", key, value);
    };
    if (joint.kind != JointKind::Continuous) {
      add("lower", spec.lower);
      add("upper", spec.upper);
    }
    add("velocity", spec.velocity_limit);
    add("effort", spec.effort_limit);
    text += fmt::format("  {}: {{{}}}\n", yaml_word(joint.name), entries);
  });
  if (text.empty()) return "";
  return "limits:\n  # Copied from the description, in rad, m, s, Nm and N. Values here replace "
         "those of the\n  # description. A missing limit means unlimited; an effort of 0 means a "
         "joint without a motor.\n" +
         text;
}

std::string lock_text(const DraftInput& drafted) {
  std::vector<std::string> names = drafted.robot.model.locked_joints;
  names.insert(names.end(), drafted.held.begin(), drafted.held.end());
  if (names.empty()) return "";
  std::string text = drafted.held.empty()
                         ? ""
                         : "# Locked joints: fingers of a gripper and, with --tool, joints that do "
                           "not carry the tool.\n# Remove joints from this list that move.\n";
  text += "lock: [";
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : ", ") + yaml_word(names[i]);
  return text + "]\n";
}

/// Throws Error for an unknown tool. Also throws Error if a tool is given although the robot has a
/// frame `tool`, which commands use by default.
void check_tool(const Model& model, const std::string& tool) {
  if (tool.empty()) return;
  if (!model.has_frame(tool))
    throw Error("--tool: the tool's frame " + pressing::none_of(model, tool, true));
  if (model.has_frame("tool") && tool != "tool")
    throw Error(fmt::format(
        "--tool: the draft would add a frame 'tool', but robot '{}' already has this frame; "
        "wanted --tool tool",
        model.name));
}

/// Returns the link of a body that most likely carries a tool. Links with names such as "tcp" are
/// preferred, then links far from the joint; of equally distant links, the last one is returned.
std::string outermost_link(const Model& model, int body) {
  constexpr double same = 1e-3;  // distances that differ by less count as equal [m]; chosen by hand
  const Frame* outermost = nullptr;
  for (const char* word : {"tcp", "tool", "end_effector", "ee_link", "eef", "flange", ""}) {
    for (const Frame& frame : model.frames) {
      if (frame.kind != FrameKind::Link || frame.body != body ||
          frame.name.find(word) == std::string::npos)
        continue;
      const double distance = frame.placement.translation().norm();
      if (outermost == nullptr || distance > outermost->placement.translation().norm() - same)
        outermost = &frame;
    }
    if (outermost != nullptr) return outermost->name;
  }
  return {};
}

/// Returns the joints that a draft locks. These are fingers and, for an arm with a given tool,
/// joints that do not carry the tool.
std::set<std::string> held_joints(const TreeSpec& tree, const Model& model,
                                  const std::string& tool) {
  std::set<std::string> held;
  const std::set<std::string> fingers = finger_joints(tree);
  const bool is_arm =
      !tool.empty() && !model.joints.empty() && model.joints.front().kind != JointKind::FreeFlyer;
  std::set<int> carrying;
  if (is_arm) {
    const Frame& frame = model.frames[to_size(model.frame_index(tool))];
    for (const int v : model.support(frame.body)) carrying.insert(v);
  }
  for (const Joint& joint : model.joints)
    if (fingers.contains(joint.name) || (is_arm && !carrying.contains(joint.v_index)))
      held.insert(joint.name);
  return held;
}

}  // namespace

std::vector<std::string> tool_candidates(const Model& model, const std::set<std::string>& fingers) {
  struct Leaf {
    std::string name;
    std::size_t moved_by;
  };
  std::vector<bool> carries(model.joints.size(), false);
  for (const Joint& joint : model.joints)
    if (joint.parent >= 0 && !fingers.contains(joint.name)) carries[to_size(joint.parent)] = true;
  std::vector<Leaf> leaves;
  for (std::size_t body = 0; body < model.joints.size(); ++body) {
    if (carries[body] || fingers.contains(model.joints[body].name)) continue;
    const std::string link = outermost_link(model, static_cast<int>(body));
    if (!link.empty()) leaves.push_back({link, model.support(static_cast<int>(body)).size()});
  }
  std::stable_sort(leaves.begin(), leaves.end(),
                   [](const Leaf& a, const Leaf& b) { return a.moved_by > b.moved_by; });
  std::vector<std::string> names;
  for (const Leaf& leaf : leaves) names.push_back(leaf.name);
  return names;
}

std::string draft_settings(const Robot& robot, const TreeSpec& tree, const DraftPlace& place) {
  const Model& model = robot.model;
  const DraftInput drafted{robot, tree, held_joints(tree, model, place.tool)};
  // In an MJCF file, a floating base is a joint of the file, so that no key is needed.
  const bool floats = place.key == "urdf" && !model.joints.empty() &&
                      model.joints[0].name == "root_joint" &&
                      model.joints[0].kind == JointKind::FreeFlyer;
  std::string text =
      "# Settings of a robot, drafted by burnish show --write-settings. Correct them where "
      "needed.\n"
      "# docs/robots.md describes every key.\n";
  text += fmt::format("{}: {}\n", place.key, yaml_word(place.file));
  if (!place.srdf.empty()) text += fmt::format("srdf: {}\n", yaml_word(place.srdf));
  text += fmt::format("description: {}\n",
                      yaml_word(fmt::format("{}, {} joints", model.name, model.joints.size())));
  const DraftedFeet feet = place.fixed ? DraftedFeet{} : draft_feet(place.origin, floats);
  text += fmt::format("base: {}\n", floats || (feet.any() && place.key == "urdf")
                                        ? "free_flyer"
                                        : "fixed  # or free_flyer, for robots that walk or fly");
  text += "base_placement: {xyz: [0, 0, 0], rpy: [0, 0, 0]}  # root link in the world, m and rad\n";
  const std::string frames = feet.frames + tool_text(drafted, feet, place.tool);
  return text + feet.comment + lock_text(drafted) + default_posture_text(drafted, feet) +
         (frames.empty() ? "" : "frames:\n" + frames) + limits_text(drafted);
}

fs::path write_settings(const Robot& robot, const RobotArguments& arguments, const fs::path& folder,
                        const std::string& tool) {
  const std::string& from = arguments.robot;
  std::error_code error;
  if (!fs::is_regular_file(from, error))
    throw Error(fmt::format(
        "{}: this is not a regular file; wanted a URDF or MJCF file to draft settings for", from));
  const std::string extension = fs::path(from).extension().string();
  if (extension == ".yaml" || extension == ".yml")
    throw Error(
        fmt::format("{}: this robot already has settings; wanted a URDF or MJCF file", from));
  check_tool(robot.model, tool);
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw Error(fmt::format("cannot create the folder '{}'{}", folder.string(),
                            error ? ": " + error.message() : ""));
  fs::path file = folder / "robot.yaml";
  if (fs::exists(file, error))
    throw Error(fmt::format("{}: the file already exists; wanted another folder", file.string()));
  const auto beside = [&](const fs::path& other) {
    return other.empty() ? "" : fs::proximate(fs::absolute(other), fs::absolute(folder)).string();
  };
  const fs::path srdf = arguments.srdf.empty() ? srdf_of(from) : fs::path(arguments.srdf);
  write_whole_file(file,
                   draft_settings(robot, read_description(from),
                                  {description_key(from), beside(from), beside(srdf), tool, from,
                                   arguments.fixed || (!tool.empty() && !arguments.free_flyer)}));
  return file;
}

}  // namespace burnish::app
