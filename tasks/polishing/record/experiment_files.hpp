// What burnish experiment leaves behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "polishing/experiments/experiment.hpp"

namespace burnish::polishing {

/// results.md: findings, failures and the tables that are for people, with the command that
/// repeats it all.
std::string experiment_text(const ExperimentReport& report, const std::string& command);

/// results.md, results.json (everything), results.csv (the first table), the figures and the tasks.
std::vector<std::string> experiment_files(const ExperimentReport& report);
/// Writes them.
void write_experiment(const ExperimentReport& report, const std::string& name,
                      const std::string& command, const std::filesystem::path& folder);

}  // namespace burnish::polishing
