// What a polishing run leaves: tables, plots, reports, its page and recording.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"
#include "record/page_files.hpp"

namespace burnish::polishing {

/// A run that is to be, or was, made.
struct PolishJob {
  std::string name;          ///< of its folder, such as table_mpc
  std::string place;         ///< of the task, such as table
  std::string command = {};  ///< that makes this run alone; empty: of its task.yaml
  RunSpec spec;
};

/// How much of a run is written.
struct RunFilesOptions {
  int record_every = 10;  ///< plant steps between two rows of trace.csv
  bool plots = false;     ///< as SVG files too, where the page has them
};

/// Writes trace.csv, metrics.json, task.yaml, the plots where they are asked for or there is no
/// page, after a fault fault.txt and last_second.csv, and what `pages` writes; their names. Throws
/// Error if a file cannot be written, and for a `record_every` that is not positive.
std::vector<std::string> write_run(const PolishJob& job, const RunResult& result,
                                   const RunFilesOptions& options,
                                   const std::filesystem::path& folder, PageWriter& pages);

/// Everything in numbers.
nlohmann::ordered_json run_json(const PolishJob& job, const RunResult& result);

/// force.svg, path.svg, torques.svg, solver.svg (where plans were made); their names.
std::vector<std::string> write_polish_plots(const PolishJob& job, const RunResult& result,
                                            const std::filesystem::path& folder);

/// All that the page of a run shows. Its rows are among those of a table of every `record_every`th.
RunPage make_run_page(const PolishJob& job, const RunResult& result, int record_every);

}  // namespace burnish::polishing
