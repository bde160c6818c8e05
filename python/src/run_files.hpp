// What burnish polish leaves of a run, from Python.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"

namespace burnish::python {

struct FolderOptions {
  std::string name;  ///< of the run
  int record_every = 10;
  bool page = true, recording = false;
};

/// The names of the files that were written. Throws Error if they cannot be, or in a build without
/// them.
std::vector<std::string> write_run_folder(const polishing::RunSpec& spec,
                                          const polishing::RunResult& result,
                                          const std::filesystem::path& folder,
                                          const FolderOptions& options);

}  // namespace burnish::python
