// burnish merge: the tables of an experiment whose runs were made in shards.
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
        fmt::format("'{}' holds no runs of an experiment: there is no {}; wanted a folder "
                    "that `burnish experiment NAME --shard I/N` left",
                    folder, CampaignFile::name));
  if (file->version != program_version())
    throw Error(
        fmt::format("'{}' holds runs of burnish {}, and this is {}; wanted all of one version",
                    folder, file->version, program_version()));
  return *file;
}

/// The campaign that all folders are of.
Campaign common_campaign(const std::vector<std::string>& folders) {
  const Campaign campaign = campaign_in(folders.front()).campaign;
  for (const std::string& folder : folders)
    if (const Campaign other = campaign_in(folder).campaign; !(other == campaign))
      throw Error(fmt::format("'{}' holds runs of `{}`, and '{}' of `{}`; wanted shards of one",
                              folder, other.command(), folders.front(), campaign.command()));
  return campaign;
}

/// Shards of which there is no folder: " shards 2/4 and 3/4 are missing" and the like.
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
  return missing.empty() ? "" : fmt::format(" (no folder is of {})", fmt::join(missing, ", "));
}

/// Whether burnish sweep left it.
bool is_sweep(const std::string& folder) {
  const std::optional<CampaignFile> file = CampaignFile::read(folder);
  return file && file->campaign.name == CampaignFile::sweep;
}

/// Python knows what a campaign's file says.
[[noreturn]] void merge_sweep(const MergeArguments& a) {
  if (a.force)
    throw Error(
        "--force is not for campaigns that a file states; wanted another folder for --out, or that "
        "of a shard");
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
      const bool lacks_runs = sentence.find("are not there") != std::string::npos;
      throw Error(sentence + (lacks_runs ? missing_shards(a.folders) : ""));
    }
  }();
  // The tables may stand beside the runs.
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
      "merge", "The tables of an experiment or a campaign whose runs were made in shards");
  const auto arguments = std::make_shared<MergeArguments>();
  MergeArguments& a = *arguments;
  command
      ->add_option("SHARD", a.folders,
                   "Folders that burnish experiment --shard, or burnish sweep --shard, left")
      ->required()
      ->type_name("DIR");
  command->add_flag("--mixed", a.mixed,
                    "Merge runs that kernels for different processors made, and say so");
  command
      ->add_option(
          "--out", a.out,
          "Folder for what is written [a new one: experiment_NAME, experiment_NAME_2, ...]")
      ->type_name("DIR");
  command->add_flag("--force", a.force, "Replace the run that the folder of --out holds");
  command->add_flag("--quiet", a.quiet, "Print nothing");
  command->footer(
      "Examples:\n"
      "  burnish experiment seeds --shard 1/2 --out part_1    # on one machine\n"
      "  burnish experiment seeds --shard 2/2 --out part_2    # on another\n"
      "  burnish merge part_1 part_2\n"
      "  burnish sweep friction.yaml --shard 1/2 --out part_1 # and the same with these\n"
      "\n"
      "What it writes is what one process would have written, byte for byte. Shards of other\n"
      "experiments, words or versions are refused, and those that lack runs.\n"
      "docs/campaigns.md has job arrays and the like.\n"
      "Exit codes: 0 all runs polished; 1 some did not; 2 bad input.");
  command->callback([arguments, &exit_code] { exit_code = merge(*arguments); });
}

}  // namespace burnish::app
