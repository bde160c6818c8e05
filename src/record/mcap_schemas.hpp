// Structure of the messages in a recording, as JSON Schema.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace burnish::mcap {

using Members = std::vector<std::pair<std::string, std::string>>;

inline std::string object(const Members& members) {
  std::string text = R"({"type":"object","properties":{)";
  for (const auto& [name, schema] : members)
    text += (text.back() == '{' ? "\"" : ",\"") + name + "\":" + schema;
  return text + "}}";
}
inline std::string list(const std::string& of) { return R"({"type":"array","items":)" + of + "}"; }

inline const std::string number = R"({"type":"number"})";
inline const std::string word = R"({"type":"string"})";
inline const std::string truth = R"({"type":"boolean"})";
inline const std::string moment =
    R"({"type":"object","title":"time","properties":{"sec":{"type":"integer","minimum":0},)"
    R"("nsec":{"type":"integer","minimum":0,"maximum":999999999}}})";
inline const std::string vector = object({{"x", number}, {"y", number}, {"z", number}});
inline const std::string quaternion =
    object({{"x", number}, {"y", number}, {"z", number}, {"w", number}});
inline const std::string pose = object({{"position", vector}, {"orientation", quaternion}});
inline const std::string color =
    object({{"r", number}, {"g", number}, {"b", number}, {"a", number}});

/// Schema foxglove.PoseInFrame.
inline std::string pose_in_frame() {
  return object({{"timestamp", moment}, {"frame_id", word}, {"pose", pose}});
}
/// Schema foxglove.FrameTransforms.
inline std::string frame_transforms() {
  return object({{"transforms", list(object({{"timestamp", moment},
                                             {"parent_frame_id", word},
                                             {"child_frame_id", word},
                                             {"translation", vector},
                                             {"rotation", quaternion}}))}});
}
/// Schema foxglove.SceneUpdate, reduced to the fields in use.
inline std::string scene_update() {
  const auto solid = [](Members members) {
    members.insert(members.begin(), {"pose", pose});
    members.emplace_back("color", color);
    return list(object(members));
  };
  return object({{"deletions", list(object({}))},
                 {"entities", list(object({{"timestamp", moment},
                                           {"frame_id", word},
                                           {"id", word},
                                           {"frame_locked", truth},
                                           {"cubes", solid({{"size", vector}})},
                                           {"spheres", solid({{"size", vector}})},
                                           {"cylinders", solid({{"size", vector},
                                                                {"bottom_scale", number},
                                                                {"top_scale", number}})}}))}});
}
/// Schema of a message with a time stamp and named numbers.
inline std::string numbers(const std::vector<std::string>& names) {
  Members members{{"timestamp", moment}};
  for (const std::string& name : names) members.emplace_back(name, number);
  return object(members);
}
inline std::string joint_states() {
  return object({{"timestamp", moment},
                 {"name", list(word)},
                 {"position", list(number)},
                 {"velocity", list(number)},
                 {"effort", list(number)}});
}

}  // namespace burnish::mcap
