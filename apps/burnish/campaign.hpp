// An experiment as a command line states it, and the folder that says which one its runs are of.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "polishing/experiments/experiment.hpp"
#include "record/run_folder.hpp"

namespace burnish::app {

/// All words that change the results, and no others.
struct Campaign {
  std::string name, plant, ranges, folder;
  std::vector<std::string> surfaces, robots, tools, overrides;
  int seeds = 0, first_seed = 0;
  bool quick = false;

  bool operator==(const Campaign&) const = default;
  /// What repeats the results: "burnish", "experiment", NAME, ...
  std::vector<std::string> command_words() const;
  std::string command() const;
  polishing::ExperimentSpec spec() const;
};

/// What a folder with results of runs says of them, in its file campaign.json.
struct CampaignFile {
  static constexpr const char* name = "campaign.json";
  /// Stands in place of an experiment's name where burnish sweep left the runs, of which the words
  /// say nothing.
  static constexpr const char* sweep = "sweep";
  Campaign campaign;
  std::string version;
  std::string shard = {};  ///< "2/4"; empty: all of it

  void write(const std::filesystem::path& folder) const;
  /// Nothing where there is none. Throws Error for a file that says something else.
  static std::optional<CampaignFile> read(const std::filesystem::path& folder);
};

/// The folder of a campaign's folder that holds the results.
inline constexpr const char* results_folder = "runs";

/// Throws Error for words that are bad or do not go together, before anything is run, and warns of
/// odd robots.
void check_campaign(const Campaign& campaign, bool strict);

/// Writes what came out, and prints it unless `quiet`; the exit code. What cannot be written is
/// printed all the same before that is thrown as an Error.
int write_report(const polishing::ExperimentReport& report, const Campaign& campaign,
                 RunFolder& folder, bool quiet);

}  // namespace burnish::app
