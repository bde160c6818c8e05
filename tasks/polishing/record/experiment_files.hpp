// Files that `burnish experiment` writes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "polishing/experiments/experiment.hpp"

namespace burnish::polishing {

/// Returns the text of results.md: findings, failures, tables for readers, and `command`, which
/// repeats the experiment.
std::string experiment_text(const ExperimentReport& report, const std::string& command);

/// Returns the names of the files: results.md, results.json (all numbers), results.csv (the first
/// table), figures and tasks.
std::vector<std::string> experiment_files(const ExperimentReport& report);
/// Writes the files of experiment_files() into `folder`.
void write_experiment(const ExperimentReport& report, const std::string& name,
                      const std::string& command, const std::filesystem::path& folder);

}  // namespace burnish::polishing
