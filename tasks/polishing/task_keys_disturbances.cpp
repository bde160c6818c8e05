// Keys of a task file: what makes the plant differ from what the controller believes.
#include "burnish/tasks/polishing/task_file.hpp"
#include "files/described.hpp"
#include "polishing/task_keys.hpp"
#include "sim/descriptions.hpp"

namespace burnish::polishing {
namespace {

using files::YamlReader;

TaskKey preset_key() {
  return {"preset", "",
          [](Task& task, const YamlReader& reader) {
            const std::uint64_t seed = task.disturbances.seed;
            task.disturbances = disturbance_preset(reader.word(disturbance_presets()));
            task.disturbances.seed = seed;
          },
          [](const Task& /*task*/) -> std::optional<std::string> { return std::nullopt; }};
}

}  // namespace

TaskSection disturbances_section() {
  TaskSection section{"disturbances",
                      "What the controller does not know. Or one word: none, sensors, mismatch, "
                      "joint_friction; or\n"
                      "`preset: word` and keys that differ from it.",
                      {preset_key()},
                      "preset"};
  const Description& description = description_of(static_cast<const Disturbances*>(nullptr));
  for (const Field& field : description.fields)
    section.keys.push_back(
        {field.key, field.comment(),
         [&field](Task& task, const YamlReader& reader) {
           files::read_entry(field, &task.disturbances, reader);
         },
         [&field](const Task& task) { return files::entry_text(field, &task.disturbances); }});
  return section;
}

}  // namespace burnish::polishing
