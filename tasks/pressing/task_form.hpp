// What files of tasks that press have in common.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "burnish/sim/disturbances.hpp"
#include "files/described_file.hpp"

namespace burnish::pressing {

/// `disturbances: word`, or `preset: word` in that section: all of them but the seed. A preset's
/// friction of the surface gives way to `friction`, the surface's own key such as
/// "surface.friction", where the same text or command states it.
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

/// Disturbances of what a robot stands on, which a robot with a fixed base does not have.
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

}  // namespace burnish::pressing
