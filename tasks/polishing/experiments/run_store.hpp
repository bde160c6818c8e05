// Store of results, with files for each run. A run with a stored result is not repeated. Several
// machines can share the runs of one experiment.
#pragma once

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/to_size.hpp"
#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// Selected shards (parts) of an experiment. Of `count` shards, shard I contains the runs I,
/// I + count, I + 2 count, ... Shards and runs are counted from 1.
struct Shard {
  std::vector<int> numbers{1};  ///< Numbers of the selected shards, ascending.
  int count = 1;
  bool has(std::size_t run) const {
    const int number = static_cast<int>(run % to_size(count)) + 1;
    return std::binary_search(numbers.begin(), numbers.end(), number);
  }
};

/// Returns all numbers of a robot that affect a run, as text.
std::string numbers_of(const Robot& robot);

/// Store of results in one or several folders. Each result consists of two files. NAME.json is
/// identical on all machines whose kernels use the same instruction set. NAME.times.json contains
/// measured times and the instruction set.
class RunStore {
 public:
  /// The store searches all folders in the given order. It writes into the first folder, which is
  /// created if needed. The names of results depend on `experiment` and `version`.
  RunStore(std::string experiment, std::string version, std::vector<std::filesystem::path> folders);

  /// Returns the name of a result: a hash of all inputs in 32 hexadecimal digits. The inputs are
  /// version, experiment, name of the run, task, robot (all numbers), controller and plant.
  std::string name_of(const std::string& run, const RunSpec& spec) const;
  /// Returns the name of the result of a run of any task. `depends_on`: text that contains
  /// all inputs of the result.
  std::string name_of(const std::string& run, const std::string& depends_on) const;
  /// Returns the result with this name, or nothing if the store lacks it. Throws Error for a
  /// malformed file.
  std::optional<RunFigures> find(const std::string& name) const;
  /// Writes a result; an interrupted call leaves no incomplete file. Throws Error if the files
  /// cannot be written.
  void keep(const std::string& name, const RunFigures& run) const;

 private:
  std::string experiment_, version_;
  std::vector<std::filesystem::path> folders_;
};

}  // namespace burnish::polishing
