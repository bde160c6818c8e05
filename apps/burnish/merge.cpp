// burnish merge: tables of an experiment whose runs were made in shards.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "campaign.hpp"
#include "command.hpp"
#include "hand_over.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

struct MergeArguments {
  std::vector<std::string> folders;
  std::string out;
  bool mixed = false, force = false, quiet = false;
};

CampaignFile campaign_in(const std::string& folder) {
  const std::optional<CampaignFile> file = CampaignFile::read(folder);
  if (!file)
    throw Error(
        fmt::format("'{}' holds no runs of an experiment: it has no file {}; wanted a folder "
                    "that `burnish experiment NAME --shard I/N` wrote",
                    folder, CampaignFile::name));
  if (file->version != program_version())
    throw Error(fmt::format(
        "'{}' holds runs of burnish {}, but this is burnish {}; wanted runs of this version",
        folder, file->version, program_version()));
  return *file;
}

/// Returns the campaign to which all folders belong. Throws Error if they belong to different
/// campaigns.
Campaign common_campaign(const std::vector<std::string>& folders) {
  const Campaign campaign = campaign_in(folders.front()).campaign;
  for (const std::string& folder : folders)
    if (const Campaign other = campaign_in(folder).campaign; !(other == campaign))
      throw Error(fmt::format(
          "'{}' holds runs of `{}`, but '{}' holds runs of `{}`; wanted shards of one experiment",
          folder, other.command(), folders.front(), campaign.command()));
  return campaign;
}

/// Returns the shards for which no folder was given, such as " (no folder holds 2/4, 3/4)".
std::string missing_shards(const std::vector<std::string>& folders) {
  std::set<int> numbers;
  int count = 0;
  for (const std::string& folder : folders) {
    int number = 0, of = 0;
    const std::string shard = campaign_in(folder).shard;
    if (std::sscanf(shard.c_str(), "%d/%d", &number, &of) != 2) return "";
    if (count != 0 && of != count) return "";
    count = of;
    numbers.insert(number);
  }
  std::vector<std::string> missing;
  for (int number = 1; number <= count; ++number)
    if (!numbers.contains(number)) missing.push_back(fmt::format("{}/{}", number, count));
  return missing.empty() ? "" : fmt::format(" (no folder holds {})", fmt::join(missing, ", "));
}

/// Returns whether `burnish sweep` wrote the folder.
bool is_sweep(const std::string& folder) {
  const std::optional<CampaignFile> file = CampaignFile::read(folder);
  return file && file->campaign.name == CampaignFile::sweep;
}

/// Merges shards of `burnish sweep` by the Python package burnish; does not return.
[[noreturn]] void merge_sweep(const MergeArguments& a) {
  if (a.force)
    throw Error(
        "--force does not work with campaigns of burnish sweep; wanted --out with a new folder or "
        "the folder of a shard");
  std::vector<std::string> words{"merge"};
  words.insert(words.end(), a.folders.begin(), a.folders.end());
  if (!a.out.empty()) words.insert(words.end(), {"--out", a.out});
  if (a.mixed) words.emplace_back("--mixed");
  if (a.quiet) words.emplace_back("--quiet");
  hand_over_to_python(words, "numpy");
}

int merge(const MergeArguments& a) {
  if (std::any_of(a.folders.begin(), a.folders.end(), is_sweep)) merge_sweep(a);
  const Campaign campaign = common_campaign(a.folders);
  std::vector<fs::path> results;
  for (const std::string& folder : a.folders) results.push_back(fs::path(folder) / results_folder);
  const polishing::RunStore store(campaign.name, program_version(), results);
  polishing::ExperimentSpec spec = campaign.spec();
  spec.store = &store;
  spec.only_found = true;
  spec.mixed = a.mixed;
  const polishing::ExperimentReport report = [&] {
    try {
      return polishing::experiment_named(campaign.name).perform(spec);
    } catch (const Error& error) {
      const std::string sentence = error.what();
      const bool lacks_runs = sentence.find("are missing") != std::string::npos;
      throw Error(sentence + (lacks_runs ? missing_shards(a.folders) : ""));
    }
  }();
  // If the tables are written into the folder of a shard, the runs of the shard are kept.
  const bool beside = std::any_of(a.folders.begin(), a.folders.end(), [&](const auto& each) {
    std::error_code ignored;
    return !a.out.empty() && fs::equivalent(each, a.out, ignored);
  });
  RunFolder folder({.out = a.out,
                    .name = "experiment_" + campaign.name,
                    .force = a.force && !beside,
                    .resume = beside});
  if (beside) folder.claim({CampaignFile::name, std::string(results_folder) + "/"});
  return write_report(report, campaign, folder, a.quiet);
}

}  // namespace

void add_merge(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "merge", "Make the tables of an experiment or a campaign from runs made in shards");
  const auto arguments = std::make_shared<MergeArguments>();
  MergeArguments& a = *arguments;
  command
      ->add_option("SHARD", a.folders,
                   "Folders that burnish experiment --shard or burnish sweep --shard wrote")
      ->required()
      ->type_name("DIR");
  command->add_flag("--mixed", a.mixed,
                    "Accept runs made on different kinds of processors, which differ in the last "
                    "digits; the results state it");
  command
      ->add_option("--out", a.out,
                   "Output folder [a new one: experiment_NAME, experiment_NAME_2, ...]")
      ->type_name("DIR");
  command->add_flag("--force", a.force, "Replace the results in the output folder");
  command->add_flag("--quiet", a.quiet, "Print nothing");
  command->footer(
      "Examples:\n"
      "  burnish experiment seeds --shard 1/2 --out part_1    # on one machine\n"
      "  burnish experiment seeds --shard 2/2 --out part_2    # on another\n"
      "  burnish merge part_1 part_2\n"
      "  burnish sweep friction.yaml --shard 1/2 --out part_1 # works for sweeps too\n"
      "\n"
      "The output equals that of one process, byte for byte. Shards of another experiment, with\n"
      "other options or of another version, and shards with missing runs are rejected.\n"
      "docs/campaigns.md describes job arrays and other schedulers.\n"
      "Exit codes: 0 all runs polished; 1 some did not; 2 invalid input.");
  command->callback([arguments, &exit_code] { exit_code = merge(*arguments); });
}

}  // namespace burnish::app
