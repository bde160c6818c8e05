// What a polishing run leaves: tables, plots, reports, its page and recording.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"
#include "record/run_files.hpp"

namespace burnish::polishing {

/// A run that is to be, or was, made.
struct PolishJob {
  std::string name;          ///< of its folder, such as table_mpc
  std::string place;         ///< of the task, such as table
  std::string command = {};  ///< that makes this run alone; empty: of its task.yaml
  RunSpec spec;
};

/// See write_run_files().
std::vector<std::string> write_run(const PolishJob& job, const RunResult& result,
                                   const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages);

/// Everything in numbers.
nlohmann::ordered_json run_json(const PolishJob& job, const RunResult& result);

/// All that the page of a run shows. Its rows are among those of a table of every `record_every`th.
RunPage make_run_page(const PolishJob& job, const RunResult& result, int record_every);

}  // namespace burnish::polishing
