// Words of a command line that define an experiment, and the file campaign.json. The file records
// these words in the folder of the results.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/experiment.hpp"
#include "record/run_folder.hpp"

namespace burnish::app {

/// Options of an experiment that affect its results. Options such as --threads are not included.
struct Campaign {
  std::string name, plant, ranges, folder;
  std::vector<std::string> surfaces, robots, tools, overrides;
  int seeds = 0, first_seed = 0;
  bool quick = false;

  bool operator==(const Campaign&) const = default;
  /// Command line that reproduces the results: "burnish", "experiment", NAME, ...
  std::vector<std::string> command_words() const;
  std::string command() const;
  polishing::ExperimentSpec spec() const;
};

/// Contents of campaign.json, which records the experiment whose runs are in the folder.
struct CampaignFile {
  static constexpr const char* name = "campaign.json";
  /// Value of campaign.name if `burnish sweep` made the runs; `campaign` then has no other values.
  static constexpr const char* sweep = "sweep";
  Campaign campaign;
  std::string version;
  std::string shard = {};  ///< Shard, such as "2/4"; empty: all runs.

  void write(const std::filesystem::path& folder) const;
  /// Reads campaign.json in `folder`. Returns nothing if the file does not exist. Throws Error if
  /// its contents are malformed.
  static std::optional<CampaignFile> read(const std::filesystem::path& folder);
};

/// Name of the subfolder with the stored results of runs.
inline constexpr const char* results_folder = "runs";

/// Throws Error for invalid or conflicting options, and prints warnings about the robots. Must be
/// called before the first run.
void check_campaign(const Campaign& campaign, bool strict);

/// Writes the report, prints it unless `quiet`, and returns the exit code. If writing fails, the
/// report is still printed before the Error is thrown.
int write_report(const polishing::ExperimentReport& report, const Campaign& campaign,
                 RunFolder& folder, bool quiet);

}  // namespace burnish::app
