// What files of tasks that press have in common.
#pragma once

#include "burnish/sim/disturbances.hpp"
#include "files/described_file.hpp"

namespace burnish::pressing {

/// `disturbances: word`, or `preset: word` in that section: all of them but the seed.
template <class Task>
void read_presets(files::DescribedFile& form) {
  form.reads<Task>("disturbances", "preset",
                   [](Task& task, const files::Reader& reader) {
                     const std::uint64_t seed = task.disturbances.seed;
                     task.disturbances = disturbance_preset(reader.word(disturbance_presets()));
                     task.disturbances.seed = seed;
                   })
      .word("disturbances", "preset");
}

}  // namespace burnish::pressing
