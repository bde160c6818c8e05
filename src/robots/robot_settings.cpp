#include "robots/robot_settings.hpp"

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "document/described.hpp"
#include "document/geometry.hpp"
#include "robots/descriptions.gen.hpp"
#include "robots/read_inertia.hpp"

namespace burnish {
namespace {

using document::Reader;

FrameSpec read_frame(const std::string& name, const Reader& reader) {
  if (name == "world") reader.refuse("the name 'world' is reserved; wanted another name");
  FrameSpec frame;
  frame.name = name;
  frame.placement = document::read_placement(reader, {"parent"});
  const auto parent = reader.find("parent");
  if (!parent) reader.refuse("key 'parent' is missing; wanted the name of a frame");
  frame.parent = parent->text();
  return frame;
}

/// Reads {between: [link, link], first: placement, second: placement, directions: [x, y, z]}.
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

/// Reads a posture. `earlier` are the postures above it in the file; key `from` copies one of them.
Posture read_posture(const Reader& reader, const std::map<std::string, Posture>& earlier) {
  Posture posture;
  if (const auto from = reader.find("from")) {
    std::vector<std::string> names;
    for (const auto& [name, other] : earlier) names.push_back(name);
    const auto found = earlier.find(from->text());
    if (found == earlier.end())
      from->refuse("posture " + in_quotes(from->text()) +
                   " is not one of the postures earlier in the file" +
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

using Postures = std::map<std::string, Posture>;

Postures read_postures(const Reader& reader) {
  Postures postures;
  for (const auto& [name, posture] : reader.items())
    postures[name] = read_posture(posture, postures);
  return postures;
}

JointFigures read_figures(const Reader& reader) {
  JointFigures figures;
  document::read_described(description_of(&figures), &figures, reader);
  if (figures.gear_ratio && !figures.rotor_inertia)
    reader.refuse(
        "key 'gear_ratio' is stated without 'rotor_inertia'; wanted both keys, or only 'armature'");
  if (figures.gear_ratio == 0.0)
    reader["gear_ratio"].refuse(
        "it is 0; wanted a number of rotor turns per joint turn other than 0");
  return figures;
}

/// Reads a map of named entries into a list, in the order of the file.
template <class Named>
std::vector<Named> read_named(const Reader& reader,
                              Named (*read)(const std::string& name, const Reader& reader)) {
  std::vector<Named> all;
  for (const auto& [name, value] : reader.items()) all.push_back(read(name, value));
  return all;
}

/// Returns readers for the types that read_described() cannot read by itself.
document::Reading forms() {
  using document::read_by;
  return {.types = {read_by([](const Reader& at) { return document::read_placement(at); }),
                    read_by([](const Reader& at) { return read_named(at, read_frame); }),
                    read_by([](const Reader& at) { return read_named(at, read_loop); }),
                    read_by([](const Reader& at) { return read_inertia(at); }),
                    read_by(read_payload), read_by(read_postures), read_by(read_figures)}};
}

/// Reads the keys of a file or of a variant. `also` are keys that only the file may have.
RobotSettings read_settings(const Reader& reader, const std::vector<std::string>& also) {
  document::Reading reading = forms();
  reading.also = also;
  RobotSettings settings;
  document::read_described(description_of(&settings), &settings, reader, reading);
  if (settings.free && settings.free->empty())
    reader["free"].refuse("the list is empty; wanted at least one joint name");
  if (settings.urdf && settings.mjcf)
    reader.refuse("keys 'urdf' and 'mjcf' are both stated; wanted only one");
  if (settings.lock && settings.free)
    reader.refuse("keys 'lock' and 'free' are both stated; wanted only one");
  return settings;
}

}  // namespace

RobotSettingsFile parse_robot_settings(const std::string& text, const std::string& name) {
  const Reader top = Reader::parse(text, name);
  if (!top.is_map())
    top.refuse("the file has no keys; wanted keys with values, such as 'urdf: robot.urdf'");
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
  if (variant.urdf || variant.mjcf) common.urdf = common.mjcf = std::nullopt;
  if (variant.lock || variant.free) common.lock = common.free = std::nullopt;
  put_over(description_of(&common), &common, &variant);
  return common;
}

}  // namespace burnish
