// Results of runs in files of their own: no run is made twice, and many machines share a campaign.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// Of `count` shards some: run I, I + count, I + 2 count, ... for each number I of them.
struct Shard {
  std::vector<int> numbers{1};  ///< ascending
  int count = 1;
  bool has(std::size_t run) const {
    const int number = static_cast<int>(run % static_cast<std::size_t>(count)) + 1;
    return std::binary_search(numbers.begin(), numbers.end(), number);
  }
};

/// All of a robot that a run depends on, as numbers.
std::string numbers_of(const Robot& robot);

/// A folder of results, or several. A result is two files: NAME.json, which is the same on every
/// machine with the same kernels, and NAME.times.json with what was measured and what made it.
class RunStore {
 public:
  /// Results are looked for in all folders, in this order, and kept in the first one, which need
  /// not be there yet. `experiment` and `version` are part of what names them.
  RunStore(std::string experiment, std::string version, std::vector<std::filesystem::path> folders);

  /// 32 hexadecimal digits of all that a result depends on: version, experiment, the run's name,
  /// its task, its robot in numbers, its controller and plant.
  std::string name_of(const std::string& run, const RunSpec& spec) const;
  /// The same of a run of any task, by the text of all that its result depends on.
  std::string name_of(const std::string& run, const std::string& depends_on) const;
  /// Throws Error for a file that is no result.
  std::optional<RunFigures> find(const std::string& name) const;
  /// Throws Error where the files cannot be written; they are there whole or not at all.
  void keep(const std::string& name, const RunFigures& run) const;

 private:
  std::string experiment_, version_;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace burnish::polishing
