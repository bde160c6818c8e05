#include "robots/robot_settings.hpp"

#include <algorithm>
#include <limits>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "document/geometry.hpp"
#include "robots/read_inertia.hpp"

namespace burnish {
namespace {

using document::Reader;

FrameSpec read_frame(const std::string& name, const Reader& reader) {
  FrameSpec frame;
  frame.name = name;
  frame.placement = document::read_placement(reader, {"parent"});
  const auto parent = reader.find("parent");
  if (!parent) reader.refuse("key 'parent' is missing; wanted the name of a frame");
  frame.parent = parent->text();
  return frame;
}

/// {between: [link, link], first: placement, second: placement, directions: [x, y, z]}.
LoopSpec read_loop(const std::string& name, const Reader& reader) {
  reader.allow_only({"between", "first", "second", "directions"});
  LoopSpec loop;
  loop.name = name;
  const std::vector<std::string> links = reader["between"].texts();
  if (links.size() != 2)
    reader["between"].refuse("it has " + std::to_string(links.size()) +
                             " entries; wanted two links, one of which may be 'world'");
  loop.first_link = links[0];
  loop.second_link = links[1];
  if (const auto first = reader.find("first")) loop.first = document::read_placement(*first);
  if (const auto second = reader.find("second")) loop.second = document::read_placement(*second);
  if (const auto directions = reader.find("directions")) {
    std::string words;
    for (const std::string& word : directions->texts()) words += (words.empty() ? "" : ",") + word;
    loop.directions = directions->named([&] { return Directions::parse(words); });
  }
  return loop;
}

/// `known`: those above it, one of which it may begin as.
Posture read_posture(const Reader& reader, const std::map<std::string, Posture>& known) {
  Posture posture;
  if (const auto from = reader.find("from")) {
    std::vector<std::string> names;
    for (const auto& [name, other] : known) names.push_back(name);
    const auto found = known.find(from->text());
    if (found == known.end())
      from->refuse("posture " + in_quotes(from->text()) + " is none of those above it" +
                   did_you_mean(from->text(), names));
    posture = found->second;
  }
  for (const auto& [joint, value] : reader.items()) {
    if (joint == "from") continue;
    const Eigen::VectorXd values =
        value.is_list() ? value.numbers() : Eigen::VectorXd::Constant(1, value.number());
    posture[joint].assign(values.begin(), values.end());
  }
  return posture;
}

/// A limit, which may be infinite: as YAML writes it or as C++ does.
double read_limit(const Reader& reader) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const char* word : {".inf", "+.inf", "inf", "+inf"})
    if (reader.is(word)) return infinity;
  return reader.is("-.inf") || reader.is("-inf") ? -infinity : reader.number();
}

JointLimits read_limits(const Reader& reader) {
  reader.allow_only({"lower", "upper", "velocity", "effort"});
  JointLimits limits;
  for (const auto& [key, limit] : {std::pair("lower", &limits.lower),
                                   {"upper", &limits.upper},
                                   {"velocity", &limits.velocity},
                                   {"effort", &limits.effort}})
    if (const auto value = reader.find(key)) *limit = read_limit(*value);
  return limits;
}

JointFigures read_figures(const Reader& reader) {
  reader.allow_only(
      {"armature", "damping", "friction", "stiffness", "rest", "rotor_inertia", "gear_ratio"});
  JointFigures figures;
  for (const auto& [key, figure] : {std::pair("armature", &figures.armature),
                                    {"damping", &figures.damping},
                                    {"friction", &figures.friction},
                                    {"stiffness", &figures.stiffness},
                                    {"rest", &figures.rest},
                                    {"rotor_inertia", &figures.rotor_inertia},
                                    {"gear_ratio", &figures.gear_ratio}}) {
    const auto value = reader.find(key);
    if (!value) continue;
    *figure = value->number();
    const bool any_sign = figure == &figures.rest || figure == &figures.gear_ratio;
    if (!any_sign && **figure < 0.0) value->refuse("wanted zero or a positive number");
  }
  if (figures.gear_ratio && !figures.rotor_inertia)
    reader.refuse("key 'gear_ratio' stands without 'rotor_inertia'; state both, or the armature");
  return figures;
}

/// The keys of a file or of a variant; `also`: one that only the file has.
RobotSettings read_settings(const Reader& reader, const std::vector<std::string>& also) {
  std::vector<std::string> keys{
      "urdf",   "mjcf",   "srdf",    "description",     "base",     "base_placement",
      "lock",   "free",   "posture", "default_posture", "postures", "frames",
      "limits", "joints", "loops",   "inertias",        "payload"};
  keys.insert(keys.end(), also.begin(), also.end());
  reader.allow_only(keys);
  RobotSettings settings;
  for (const auto& [key, text] : {std::pair("urdf", &settings.urdf),
                                  {"mjcf", &settings.mjcf},
                                  {"srdf", &settings.srdf},
                                  {"description", &settings.description},
                                  {"posture", &settings.posture},
                                  {"default_posture", &settings.default_posture}})
    if (const auto value = reader.find(key)) *text = value->text();
  if (const auto base = reader.find("base"))
    settings.base = base->word({"fixed", "free_flyer"}) == "fixed" ? Base::Fixed : Base::FreeFlyer;
  if (const auto placement = reader.find("base_placement"))
    settings.base_placement = document::read_placement(*placement);
  if (const auto lock = reader.find("lock")) settings.lock = lock->texts();
  if (const auto free = reader.find("free")) {
    settings.free = free->texts();
    if (settings.free->empty()) free->refuse("wanted at least one joint name");
  }
  if (settings.urdf && settings.mjcf)
    reader.refuse("keys 'urdf' and 'mjcf' are both stated; a robot has one description");
  if (settings.lock && settings.free)
    reader.refuse("keys 'lock' and 'free' are both stated; state one, the other follows");
  if (const auto postures = reader.find("postures"))
    for (const auto& [name, posture] : postures->items())
      settings.postures[name] = read_posture(posture, settings.postures);
  if (const auto frames = reader.find("frames"))
    for (const auto& [name, frame] : frames->items())
      settings.frames.push_back(read_frame(name, frame));
  if (const auto limits = reader.find("limits"))
    for (const auto& [joint, limit] : limits->items()) settings.limits[joint] = read_limits(limit);
  if (const auto joints = reader.find("joints"))
    for (const auto& [joint, figures] : joints->items())
      settings.joints[joint] = read_figures(figures);
  if (const auto loops = reader.find("loops"))
    for (const auto& [name, loop] : loops->items()) settings.loops.push_back(read_loop(name, loop));
  if (const auto inertias = reader.find("inertias"))
    for (const auto& [link, inertia] : inertias->items())
      settings.inertias[link] = read_inertia(inertia);
  if (const auto payload = reader.find("payload")) settings.payload = read_payload(*payload);
  return settings;
}

/// Puts what has a name in the place of that which has the same, or behind the others.
template <class Named>
void replace_or_add(const std::vector<Named>& added, std::vector<Named>& all) {
  for (const Named& entry : added) {
    const auto same = std::find_if(all.begin(), all.end(),
                                   [&](const Named& other) { return other.name == entry.name; });
    if (same != all.end()) {
      *same = entry;
    } else {
      all.push_back(entry);
    }
  }
}

}  // namespace

RobotSettingsFile parse_robot_settings(const std::string& text, const std::string& name) {
  const Reader top = Reader::parse(text, name);
  if (!top.is_map()) top.refuse("wanted keys with values, such as 'urdf: robot.urdf'");
  RobotSettingsFile result;
  result.common = read_settings(top, {"variants"});
  if (const auto variants = top.find("variants"))
    for (const auto& [variant, value] : variants->items())
      result.variants[variant] = read_settings(value, {});
  if (!result.common.urdf && !result.common.mjcf)
    top.refuse(
        "key 'urdf' is missing; wanted the name of a URDF file, or 'mjcf' with an MJCF file");
  return result;
}

RobotSettingsFile read_robot_settings(const std::filesystem::path& file) {
  return parse_robot_settings(read_text(file, "settings file"), file.string());
}

RobotSettings with_variant(RobotSettings common, const RobotSettings& variant) {
  if (variant.urdf || variant.mjcf) {
    common.urdf = variant.urdf;
    common.mjcf = variant.mjcf;
  }
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
  for (const auto& [joint, figures] : variant.joints) common.joints[joint] = figures;
  replace_or_add(variant.frames, common.frames);
  replace_or_add(variant.loops, common.loops);
  for (const auto& [link, inertia] : variant.inertias) common.inertias[link] = inertia;
  if (variant.payload) common.payload = variant.payload;
  return common;
}

}  // namespace burnish
