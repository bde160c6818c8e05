// The file of the task, read strictly.
#include <cmath>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "burnish/tasks/press_hold/press_hold.hpp"
#include "document/reader.hpp"
#include "document/text.hpp"

namespace burnish::press_hold {
namespace {

using document::Reader;

struct NumberKey {
  const char* name;
  double Task::*entry;
  double low, high;
};
constexpr double longest = 1e3;  // s

const std::vector<NumberKey>& number_keys() {
  static const std::vector<NumberKey> keys{
      {"tip_radius", &Task::tip_radius, 1e-4, 1.0},
      {"clearance", &Task::clearance, 1e-4, 1.0},
      {"force", &Task::force, 0.1, 1e4},
      {"touch_force", &Task::touch_force, 0.0, 1e4},
      {"approach_speed", &Task::approach_speed, 1e-3, 1.0},
      {"ramp_duration", &Task::ramp_duration, 1e-2, longest},
      {"aside_duration", &Task::aside_duration, 1e-2, longest},
      {"hold_duration", &Task::hold_duration, 1e-2, longest},
      {"retreat_duration", &Task::retreat_duration, 1e-2, longest},
      {"slip", &Task::slip, 1e-5, 1.0},
      {"posture_weight", &Task::posture_weight, 1e-6, 1e6},
      {"tick_rate", &Task::tick_rate, 100.0, 1e4},
      {"mass_scale", &Task::mass_scale, 0.1, 10.0},
      {"friction", &Task::friction, 0.0, 10.0},
      {"surface_height", &Task::surface_height, -1.0, 1.0}};
  return keys;
}

std::string word(const std::string& text) {
  return document::yaml_text({.kind = document::Kind::Text, .text = text});
}

}  // namespace

Task read_task(const std::filesystem::path& file) {
  return parse_task(read_text(file, "YAML file"), file.string());
}

Task parse_task(const std::string& text, const std::string& name) {
  const Reader file = Reader::parse(text, name);
  if (!file.has("task"))
    file.refuse(
        "key 'task' is missing; wanted 'task: press_hold' (a file of polishing names none: "
        "burnish polish)");
  std::vector<std::string> names{"task", "robot", "posture", "tool", "normal", "aside"};
  for (const NumberKey& key : number_keys()) names.emplace_back(key.name);
  file.allow_only(names);
  (void)file["task"].word({"press_hold"});
  Task task;
  for (const auto& [key, entry] : {std::pair("robot", &Task::robot), std::pair("tool", &Task::tool),
                                   std::pair("posture", &Task::posture)})
    if (const auto value = file.find(key)) task.*entry = value->text();
  if (const auto normal = file.find("normal")) {
    task.normal_world = normal->vector3();
    if (!(task.normal_world.norm() > 1e-9)) normal->refuse("a direction without length");
  }
  if (const auto aside = file.find("aside"))
    for (const auto& [joint, way] : aside->items()) task.aside[joint] = way.number(-10.0, 10.0);
  for (const NumberKey& key : number_keys())
    if (const auto value = file.find(key.name)) task.*key.entry = value->number(key.low, key.high);
  if (task.touch_force > task.force)
    file.refuse("touch_force of " + number(task.touch_force) + " N is more than the force of " +
                number(task.force) + " N; wanted at most that");
  return task;
}

std::string task_text(const Task& task) {
  using document::number_text;
  std::string text = "task: press_hold\n";
  for (const auto& [key, value] : {std::pair("robot", task.robot), std::pair("tool", task.tool),
                                   std::pair("posture", task.posture)})
    if (!value.empty()) text += std::string(key) + ": " + word(value) + "\n";
  const Eigen::Vector3d& n = task.normal_world;
  text += "normal: [" + number_text(n.x()) + ", " + number_text(n.y()) + ", " + number_text(n.z()) +
          "]\naside: {";
  for (const auto& [joint, way] : task.aside)
    text += (text.back() == '{' ? "" : ", ") + word(joint) + ": " + number_text(way);
  text += "}\n";
  for (const NumberKey& key : number_keys())
    text += std::string(key.name) + ": " + number_text(task.*key.entry) + "\n";
  return text;
}

}  // namespace burnish::press_hold
