// Files that a polishing run writes: tables, plots, reports, page and recording.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"
#include "record/run_files.hpp"

namespace burnish::polishing {

/// Planned or completed run with its name.
struct PolishJob {
  std::string name;          ///< Name of the run's folder, such as "table_mpc".
  std::string place;         ///< Name of the task's surface, such as "table".
  std::string command = {};  ///< Command that repeats this run; empty: `burnish polish task.yaml`.
  RunSpec spec;
};

/// Writes the files of a run into `folder` by write_run_files(). Returns the names of the files.
std::vector<std::string> write_run(const PolishJob& job, const RunResult& result,
                                   const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages);

/// Returns all numbers of a run, for metrics.json.
nlohmann::ordered_json run_json(const PolishJob& job, const RunResult& result);

/// Returns the contents of a run's HTML page, with every `record_every`th row of the trace.
RunPage make_run_page(const PolishJob& job, const RunResult& result, int record_every);

}  // namespace burnish::polishing
