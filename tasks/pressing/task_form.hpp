// Parts that the task files of all pressing tasks have in common.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "burnish/sim/disturbances.hpp"
#include "document/described.hpp"
#include "files/described_file.hpp"
#include "sim/descriptions.gen.hpp"

namespace burnish::pressing {

/// Reads `disturbances: word`, or `preset: word` in the section `disturbances`. A preset sets all
/// disturbances except the seed. `friction`: key of the surface's friction, such as
/// "surface.friction". A stated value of this key overrides the preset, unless
/// disturbances.surface_friction is stated too.
template <class Task>
void read_presets(files::DescribedFile& form, const std::string& friction = "") {
  form.reads<Task>("disturbances", "preset",
                   [](Task& task, const files::Reader& reader) {
                     const std::uint64_t seed = task.disturbances.seed;
                     task.disturbances = disturbance_preset(reader.word(disturbance_presets()));
                     task.disturbances.seed = seed;
                   })
      .word("disturbances", "preset");
  if (friction.empty()) return;
  form.settles<Task>([friction](Task& task, const std::vector<files::Reader>& texts) {
    const auto state = [&](const std::string& key) {
      return std::any_of(texts.begin(), texts.end(), [&](const files::Reader& text) {
        return files::stated(text, key).has_value();
      });
    };
    if (state(friction) && !state("disturbances.surface_friction"))
      task.disturbances.surface_friction.reset();
  });
}

/// Reads and checks a task file. Errors name the file, or the override, with line and key.
template <class Task>
Task parse_task_text(const std::string& text, const std::string& name,
                     const std::vector<std::string>& overrides) {
  const files::SpecTexts<Task> said = files::parse_said<Task>(text, name, overrides);
  files::placed(said.texts, [&] { check_task(said.spec); });
  return said.spec;
}
template <class Task>
Task read_task_file(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return parse_task_text<Task>(read_text(file, "YAML file"), file.string(), overrides);
}

/// Applies overrides to a task, without a check of the result.
template <class Task>
void change_task(Task& task, const std::vector<std::string>& overrides) {
  files::SpecTexts<Task> said{.spec = task};
  files::change(said, overrides);
  task = said.spec;
}

/// Returns the keys of the disturbances that only robots on feet have.
inline const std::vector<std::string>& disturbances_of_standing() {
  static const std::vector<std::string> keys{"support_force_noise",
                                             "support_moment_noise",
                                             "gyro_noise",
                                             "gyro_bias_range",
                                             "gyro_bias_walk",
                                             "gyro_step",
                                             "accelerometer_noise",
                                             "accelerometer_bias_range",
                                             "accelerometer_bias_walk",
                                             "accelerometer_step",
                                             "imu_faults",
                                             "slippery_ground"};
  return keys;
}

/// Adds a note if the plant has no disturbances and therefore equals the controller's model.
inline void note_ideal_world(const Disturbances& disturbances, std::vector<std::string>& notes) {
  const Disturbances none;
  for (const Field& field : description_of(&none).fields)
    if (field.name != "seed" &&
        document::entry_text(field, &disturbances) != document::entry_text(field, &none))
      return;
  notes.emplace_back(
      "the world is ideal: the plant is the controller's own model, without noise, delays or joint "
      "friction; the shipped tasks and `burnish polish` without a file use `disturbances: "
      "mismatch`; state `disturbances: none` if an ideal world is intended");
}

/// Returns whether the texts state disturbances. The word `none` counts, a seed alone does not.
inline bool states_disturbances(const std::vector<files::Reader>& texts) {
  return std::any_of(texts.begin(), texts.end(), [](const files::Reader& text) {
    const auto section = files::stated(text, "disturbances");
    if (!section || !section->is_map()) return section.has_value();
    const auto items = section->items();
    return std::any_of(items.begin(), items.end(),
                       [](const auto& item) { return item.first != "seed"; });
  });
}

}  // namespace burnish::pressing
