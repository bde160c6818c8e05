// What burnish polish leaves behind: tables, plots and reports of its runs.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "burnish/tasks/polishing/run.hpp"

namespace burnish::app {

/// A run that is to be, or was, made.
struct PolishJob {
  std::string name;          ///< of its folder, such as table_mpc
  std::string place;         ///< of the task, such as table
  std::string command = {};  ///< that makes this run alone
  polishing::RunSpec spec;
};

/// Creates the folder. Throws Error if that cannot be done.
void make_folder(const std::filesystem::path& folder);
void write_text(const std::filesystem::path& file, const std::string& text);

/// Writes trace.csv (every `record_every`th row), metrics.json, task.yaml, the plots and, after a
/// fault, fault.txt and last_second.csv; their names.
std::vector<std::string> write_run(const PolishJob& job, const polishing::RunResult& result,
                                   int record_every, const std::filesystem::path& folder);

/// Everything in numbers.
nlohmann::ordered_json run_json(const PolishJob& job, const polishing::RunResult& result);

/// force.svg, path.svg, torques.svg, solver.svg (where plans were made); their names.
std::vector<std::string> write_polish_plots(const PolishJob& job,
                                            const polishing::RunResult& result,
                                            const std::filesystem::path& folder);

}  // namespace burnish::app
