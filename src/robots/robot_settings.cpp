#include "robots/robot_settings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "base/parse_number.hpp"
#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "robots/yaml_text.hpp"

namespace burnish {
namespace {

/// A node and where it stands: the file, and the keys that lead to it.
struct Entry {
  const std::string& file;
  std::string path;  // e.g. "variants.right_arm.base"
  YAML::Node node;

  [[noreturn]] void refuse(const std::string& what) const {
    const YAML::Mark mark = node.Mark();
    const std::string line = mark.is_null() ? "" : "line " + std::to_string(mark.line + 1) + ": ";
    burnish::refuse(file, line + (path.empty() ? "" : path + ": ") + what);
  }
  Entry child(const std::string& key, const YAML::Node& value) const {
    return {file, path.empty() ? key : path + "." + key, value};
  }
};

/// Calls visit(key, entry) for each entry of a map, in the order of the file.
void for_each(const Entry& entry,
              const std::function<void(const std::string&, const Entry&)>& visit) {
  if (!entry.node.IsMap()) entry.refuse("wanted keys with values");
  std::set<std::string> seen;
  for (const auto& pair : entry.node) {
    if (!pair.first.IsScalar()) entry.refuse("its keys must be names");
    const std::string key = pair.first.Scalar();
    if (!seen.insert(key).second) {
      entry.refuse("key " + in_quotes(key) + " is stated twice; state it once");
    }
    visit(key, entry.child(key, pair.second));
  }
}

std::string text_of(const Entry& entry) {
  if (!entry.node.IsScalar() || entry.node.Scalar().empty()) entry.refuse("wanted a text");
  return entry.node.Scalar();
}

double number_of(const Entry& entry) {
  if (!entry.node.IsScalar()) entry.refuse("wanted a number");
  const std::optional<double> value = parse_number(entry.node.Scalar());
  if (!value) entry.refuse(in_quotes(entry.node.Scalar()) + " is not a number");
  if (!std::isfinite(*value)) entry.refuse(number(*value) + " is not finite");
  return *value;
}

std::vector<double> numbers_of(const Entry& entry) {
  std::vector<double> values;
  for (const auto& item : entry.node) {
    values.push_back(number_of(Entry{entry.file, entry.path, item}));
  }
  return values;
}

std::vector<std::string> names_of(const Entry& entry) {
  if (!entry.node.IsSequence()) entry.refuse("wanted a list of joint names");
  std::vector<std::string> names;
  for (const auto& item : entry.node) {
    names.push_back(text_of(Entry{entry.file, entry.path, item}));
  }
  return names;
}

Eigen::Vector3d vector_of(const Entry& entry) {
  const std::vector<double> values =
      entry.node.IsSequence() ? numbers_of(entry) : std::vector<double>();
  if (values.size() != 3) entry.refuse("wanted a list of 3 numbers");
  return {values[0], values[1], values[2]};
}

[[noreturn]] void refuse_key(const Entry& entry, const std::string& key,
                             const std::vector<std::string>& known) {
  const std::size_t cut = entry.path.size() - key.size();
  const Entry above{entry.file, cut == 0 ? "" : entry.path.substr(0, cut - 1), entry.node};
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  const std::string nearest = did_you_mean(key, known);
  above.refuse("key " + in_quotes(key) + " is unknown" +
               (nearest.empty() ? "; known are " + all : nearest));
}

/// Reads xyz or rpy into a placement. False for any other key.
bool read_placement_key(const std::string& key, const Entry& entry, Eigen::Isometry3d& placement) {
  if (key == "xyz") {
    placement.translation() = vector_of(entry);
    return true;
  }
  if (key != "rpy") return false;
  const Eigen::Vector3d rpy = vector_of(entry);
  placement.linear() = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                        Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                           .toRotationMatrix();
  return true;
}

Eigen::Isometry3d placement_of(const Entry& entry) {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  for_each(entry, [&](const std::string& key, const Entry& value) {
    if (!read_placement_key(key, value, placement)) refuse_key(value, key, {"xyz", "rpy"});
  });
  return placement;
}

FrameSpec frame_of(const std::string& name, const Entry& entry) {
  FrameSpec frame;
  frame.name = name;
  for_each(entry, [&](const std::string& key, const Entry& value) {
    if (key == "parent") {
      frame.parent = text_of(value);
    } else if (!read_placement_key(key, value, frame.placement)) {
      refuse_key(value, key, {"parent", "xyz", "rpy"});
    }
  });
  if (frame.parent.empty()) entry.refuse("key 'parent' is missing; wanted the name of a frame");
  return frame;
}

Posture posture_of(const Entry& entry) {
  Posture posture;
  for_each(entry, [&](const std::string& joint, const Entry& value) {
    if (value.node.IsSequence()) {
      posture[joint] = numbers_of(value);
    } else {
      posture[joint] = {number_of(value)};
    }
  });
  return posture;
}

/// A limit, which may be infinite: as YAML writes it or as C++ does.
double limit_of(const Entry& entry) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::string text = entry.node.IsScalar() ? entry.node.Scalar() : "";
  for (const char* word : {".inf", "+.inf", "inf", "+inf"}) {
    if (text == word) return infinity;
  }
  return text == "-.inf" || text == "-inf" ? -infinity : number_of(entry);
}

JointLimits limits_of(const Entry& entry) {
  JointLimits limits;
  for_each(entry, [&](const std::string& key, const Entry& value) {
    if (key == "lower") {
      limits.lower = limit_of(value);
    } else if (key == "upper") {
      limits.upper = limit_of(value);
    } else if (key == "velocity") {
      limits.velocity = limit_of(value);
    } else if (key == "effort") {
      limits.effort = limit_of(value);
    } else {
      refuse_key(value, key, {"lower", "upper", "velocity", "effort"});
    }
  });
  return limits;
}

Base base_of(const Entry& entry) {
  const std::string name = text_of(entry);
  if (name == "fixed") return Base::Fixed;
  if (name == "free_flyer") return Base::FreeFlyer;
  entry.refuse(in_quotes(name) + " is unknown; wanted fixed or free_flyer");
}

using Handler = std::function<void(const Entry&)>;

/// What each key does. One list serves reading and the sentence about unknown keys.
std::vector<std::pair<std::string, Handler>> handlers_of(RobotSettings& settings) {
  return {
      {"urdf", [&](const Entry& e) { settings.urdf = text_of(e); }},
      {"srdf", [&](const Entry& e) { settings.srdf = text_of(e); }},
      {"description", [&](const Entry& e) { settings.description = text_of(e); }},
      {"base", [&](const Entry& e) { settings.base = base_of(e); }},
      {"base_placement", [&](const Entry& e) { settings.base_placement = placement_of(e); }},
      {"lock", [&](const Entry& e) { settings.lock = names_of(e); }},
      {"free",
       [&](const Entry& e) {
         settings.free = names_of(e);
         if (settings.free->empty()) e.refuse("wanted at least one joint name");
       }},
      {"posture", [&](const Entry& e) { settings.posture = text_of(e); }},
      {"default_posture", [&](const Entry& e) { settings.default_posture = text_of(e); }},
      {"postures",
       [&](const Entry& e) {
         for_each(e, [&](const std::string& name, const Entry& value) {
           settings.postures[name] = posture_of(value);
         });
       }},
      {"frames",
       [&](const Entry& e) {
         for_each(e, [&](const std::string& name, const Entry& value) {
           settings.frames.push_back(frame_of(name, value));
         });
       }},
      {"limits",
       [&](const Entry& e) {
         for_each(e, [&](const std::string& joint, const Entry& value) {
           settings.limits[joint] = limits_of(value);
         });
       }},
  };
}

/// Reads the keys of a file or of a variant; `variants` is the handler of the file's own key.
RobotSettings settings_of(const Entry& entry, const Handler& variants) {
  RobotSettings settings;
  auto handlers = handlers_of(settings);
  if (variants) handlers.emplace_back("variants", variants);
  for_each(entry, [&](const std::string& key, const Entry& value) {
    const auto found = std::find_if(handlers.begin(), handlers.end(),
                                    [&](const auto& handler) { return handler.first == key; });
    if (found != handlers.end()) return found->second(value);
    std::vector<std::string> known;
    for (const auto& handler : handlers) known.push_back(handler.first);
    refuse_key(value, key, known);
  });
  if (settings.lock && settings.free) {
    entry.refuse("keys 'lock' and 'free' are both stated; state one, the other follows");
  }
  return settings;
}

}  // namespace

RobotSettingsFile parse_robot_settings(const std::string& text, const std::string& name) {
  const YAML::Node root = parse_yaml(text, name);
  const Entry top{name, "", root};
  if (!root.IsMap()) top.refuse("wanted keys with values, such as 'urdf: robot.urdf'");
  RobotSettingsFile result;
  result.common = settings_of(top, [&](const Entry& variants) {
    for_each(variants, [&](const std::string& variant, const Entry& value) {
      result.variants[variant] = settings_of(value, nullptr);
    });
  });
  if (!result.common.urdf) top.refuse("key 'urdf' is missing; wanted the name of a URDF file");
  return result;
}

RobotSettingsFile read_robot_settings(const std::filesystem::path& file) {
  return parse_robot_settings(read_text(file, "settings file"), file.string());
}

RobotSettings with_variant(RobotSettings common, const RobotSettings& variant) {
  if (variant.urdf) common.urdf = variant.urdf;
  if (variant.srdf) common.srdf = variant.srdf;
  if (variant.description) common.description = variant.description;
  if (variant.base) common.base = variant.base;
  if (variant.base_placement) common.base_placement = variant.base_placement;
  if (variant.posture) common.posture = variant.posture;
  if (variant.default_posture) common.default_posture = variant.default_posture;
  if (variant.lock || variant.free) {
    common.lock = variant.lock;
    common.free = variant.free;
  }
  for (const auto& [name, posture] : variant.postures) common.postures[name] = posture;
  for (const auto& [joint, limits] : variant.limits) common.limits[joint] = limits;
  for (const FrameSpec& frame : variant.frames) {
    const auto same = std::find_if(common.frames.begin(), common.frames.end(),
                                   [&](const FrameSpec& f) { return f.name == frame.name; });
    if (same != common.frames.end()) {
      *same = frame;
    } else {
      common.frames.push_back(frame);
    }
  }
  return common;
}

}  // namespace burnish
