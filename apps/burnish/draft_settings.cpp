#include "draft_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/whole_file.hpp"
#include "base/yaml_word.hpp"
#include "burnish/base/error.hpp"
#include "robots/description.hpp"
#include "urdf/srdf.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

/// Four digits are enough to edit.
std::string brief(double value) { return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value); }

bool one_coordinate(const Joint& joint) { return joint.nv == 1; }

/// Whether others follow the joint, so that its effort limit is theirs too.
bool leads(const Model& model, const Joint& joint) {
  return std::any_of(model.joints.begin(), model.joints.end(), [&](const Joint& other) {
    return other.follows && other.v_index == joint.v_index;
  });
}

/// Zero, or as near to it as a tenth of the range from its ends allows.
double away_from_limits(const Model& model, const Joint& joint) {
  if (joint.kind == JointKind::Continuous) return 0.0;
  const double lower = model.q_lower[joint.q_index], upper = model.q_upper[joint.q_index];
  if (!std::isfinite(lower) || !std::isfinite(upper)) {
    return std::isfinite(lower) ? std::max(0.0, lower) : std::min(0.0, upper);
  }
  const double margin = 0.1 * (upper - lower);
  return std::clamp(0.0, lower + margin, upper - margin);
}

/// That of the SRDF file which sounds like a beginning, or empty.
std::string likely_default(const Robot& robot) {
  for (const char* name : {"ready", "home", "half_sitting", "standing"}) {
    if (robot.postures.contains(name)) return name;
  }
  return robot.postures.empty() ? "" : robot.postures.begin()->first;
}

std::string posture_text(const Robot& robot) {
  const std::string stated = likely_default(robot);
  if (!stated.empty()) return fmt::format("default_posture: {}\n", yaml_word(stated));
  std::string text =
      "default_posture: start\npostures:\n"
      "  # Zero, or a tenth of the range off the limits. Put in where the tool works;\n"
      "  # a polishing task with posture: search finds such a place.\n"
      "  start: {";
  bool first = true;
  for (const Joint& joint : robot.model.joints) {
    if (!one_coordinate(joint)) continue;
    text += fmt::format("{}{}: {}", first ? "" : ", ", yaml_word(joint.name),
                        brief(away_from_limits(robot.model, joint)));
    first = false;
  }
  return text + "}\n";
}

std::string tool_text(const Model& model) {
  if (model.has_frame("tool")) return "";
  const std::vector<std::string> candidates = tool_candidates(model);
  if (candidates.empty()) return "";
  std::string text =
      "frames:\n  # What commands take as the tool. Move it to where it touches: xyz in m, rpy in "
      "rad.\n";
  if (candidates.size() > 1) {
    text += "  # Other links at the end of a chain:";
    constexpr std::size_t most = 12;
    for (std::size_t i = 1; i < std::min(candidates.size(), most); ++i)
      text += fmt::format("{} {}", i == 1 ? "" : ",", candidates[i]);
    text += candidates.size() > most ? ", ...\n" : "\n";
  }
  return text + fmt::format("  tool: {{parent: {}, xyz: [0, 0, 0], rpy: [0, 0, 0]}}\n",
                            yaml_word(candidates.front()));
}

std::string limits_text(const Model& model) {
  std::string text;
  for (const Joint& joint : model.joints) {
    if (!one_coordinate(joint)) continue;
    std::string entries;
    const auto add = [&](const char* key, double value) {
      if (std::isfinite(value))
        entries += fmt::format("{}{}: {}", entries.empty() ? "" : ", ", key, value);
    };
    if (joint.kind != JointKind::Continuous) {
      add("lower", model.q_lower[joint.q_index]);
      add("upper", model.q_upper[joint.q_index]);
    }
    add("velocity", model.velocity_limit[joint.v_index]);
    if (!leads(model, joint)) add("effort", model.effort_limit[joint.v_index]);
    text += fmt::format("  {}: {{{}}}\n", yaml_word(joint.name), entries);
  }
  if (text.empty()) return "";
  return "limits:\n  # Those of the description, in rad, m, s, Nm and N. What stands here goes "
         "before "
         "them; "
         "what is\n  # missing is unlimited, and an effort of 0 means a joint without a motor.\n" +
         text;
}

}  // namespace

std::vector<std::string> tool_candidates(const Model& model) {
  struct Leaf {
    std::string name;
    std::size_t moved_by;
  };
  std::vector<bool> carries(model.joints.size(), false);
  for (const Joint& joint : model.joints) {
    if (joint.parent >= 0) carries[static_cast<std::size_t>(joint.parent)] = true;
  }
  std::vector<Leaf> leaves;
  for (std::size_t body = 0; body < model.joints.size(); ++body) {
    if (carries[body]) continue;
    // Of the links of a body the last one is the farthest out.
    const auto last =
        std::find_if(model.frames.rbegin(), model.frames.rend(), [&](const Frame& frame) {
          return frame.kind == FrameKind::Link && frame.body == static_cast<int>(body);
        });
    if (last == model.frames.rend()) continue;
    leaves.push_back({last->name, model.support(static_cast<int>(body)).size()});
  }
  std::stable_sort(leaves.begin(), leaves.end(),
                   [](const Leaf& a, const Leaf& b) { return a.moved_by > b.moved_by; });
  std::vector<std::string> names;
  for (const Leaf& leaf : leaves) names.push_back(leaf.name);
  return names;
}

std::string draft_settings(const Robot& robot, const std::string& key, const std::string& file,
                           const std::string& srdf) {
  const Model& model = robot.model;
  // What floats by a joint of an MJCF file does so anyway.
  const bool floats = key == "urdf" && !model.joints.empty() &&
                      model.joints[0].name == "root_joint" &&
                      model.joints[0].kind == JointKind::FreeFlyer;
  std::string text =
      "# Settings of a robot, drafted by burnish show --write-settings: change what is not so.\n"
      "# docs/robots.md describes every key.\n";
  text += fmt::format("{}: {}\n", key, yaml_word(file));
  if (!srdf.empty()) text += fmt::format("srdf: {}\n", yaml_word(srdf));
  text += fmt::format("description: {}\n",
                      yaml_word(fmt::format("{}, {} joints", model.name, model.joints.size())));
  text += fmt::format("base: {}\n",
                      floats ? "free_flyer" : "fixed  # or free_flyer, for what walks or flies");
  text += "base_placement: {xyz: [0, 0, 0], rpy: [0, 0, 0]}  # of the root link in the world\n";
  if (!model.locked_joints.empty()) {
    text += "lock: [";
    for (std::size_t i = 0; i < model.locked_joints.size(); ++i)
      text += (i == 0 ? "" : ", ") + yaml_word(model.locked_joints[i]);
    text += "]\n";
  }
  return text + posture_text(robot) + tool_text(model) + limits_text(model);
}

fs::path write_settings(const Robot& robot, const std::string& from, const std::string& srdf,
                        const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(from, error))
    throw Error(fmt::format(
        "{}: settings are drafted for a URDF or MJCF file that stays where it is; this is none",
        from));
  const std::string extension = fs::path(from).extension().string();
  if (extension == ".yaml" || extension == ".yml")
    throw Error(
        fmt::format("{}: this robot has settings already; wanted a URDF or MJCF file", from));
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder))
    throw Error(fmt::format("cannot make the folder '{}'{}", folder.string(),
                            error ? ": " + error.message() : ""));
  fs::path file = folder / "robot.yaml";
  if (fs::exists(file, error))
    throw Error(fmt::format("{}: it is there already; name another folder", file.string()));
  const auto beside = [&](const fs::path& other) {
    return other.empty() ? "" : fs::proximate(fs::absolute(other), fs::absolute(folder)).string();
  };
  const std::string text = draft_settings(robot, description_key(from), beside(from),
                                          beside(srdf.empty() ? srdf_of(from) : fs::path(srdf)));
  write_whole_file(file, text);
  return file;
}

}  // namespace burnish::app
