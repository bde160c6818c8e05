#include "campaign.hpp"

#include <fmt/format.h>

#include <set>

#include "command.hpp"
#include "document/reader.hpp"
#include "polishing/experiments/disturbance_ranges.hpp"
#include "polishing/experiments/public_robots.hpp"
#include "polishing/record/experiment_files.hpp"
#include "record/json_text.hpp"
#include "robot_arguments.hpp"
#include "shell_word.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;
using document::Reader;
using polishing::PlantKind;

/// Calls see(key, member) for each option of a campaign, in the order of the command line. `key` is
/// the name of the option in files.
template <class See>
void each_word(const See& see) {
  see("seeds", &Campaign::seeds);
  see("first_seed", &Campaign::first_seed);
  see("ranges", &Campaign::ranges);
  see("surface", &Campaign::surfaces);
  see("robot", &Campaign::robots);
  see("tool", &Campaign::tools);
  see("folder", &Campaign::folder);
  see("plant", &Campaign::plant);
  see("quick", &Campaign::quick);
  see("set", &Campaign::overrides);
}

void read_word(const Reader& value, int& to) { to = value.count(0); }
void read_word(const Reader& value, bool& to) { to = value.yes_or_no(); }
void read_word(const Reader& value, std::string& to) {
  to = value.is_text() && value.node().text.empty() ? std::string() : value.text();
}
void read_word(const Reader& value, std::vector<std::string>& to) { to = value.texts(); }

}  // namespace

std::vector<std::string> Campaign::command_words() const {
  std::vector<std::string> words{"burnish", "experiment", name};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  if (seeds > 0) add("--seeds", std::to_string(seeds));
  if (first_seed > 0) add("--first-seed", std::to_string(first_seed));
  if (!ranges.empty()) add("--ranges", ranges);
  for (const std::string& surface : surfaces) add("--surface", surface);
  for (const std::string& robot : robots) add("--robot", robot);
  for (const std::string& tool : tools) add("--tool", tool);
  if (!folder.empty()) add("--folder", folder);
  if (!plant.empty()) add("--plant", plant);
  if (quick) words.emplace_back("--quick");
  for (const std::string& change : overrides) add("--set", change);
  return words;
}

std::string Campaign::command() const {
  std::string text;
  for (const std::string& word : command_words())
    text += (text.empty() ? "" : " ") + shell_word(word);
  return text;
}

polishing::ExperimentSpec Campaign::spec() const {
  polishing::ExperimentSpec spec;
  if (!plant.empty()) spec.plant = plant == "ideal" ? PlantKind::Ideal : PlantKind::Mujoco;
  spec.seeds = seeds;
  spec.first_seed = first_seed;
  spec.quick = quick;
  spec.surfaces = surfaces;
  spec.ranges = ranges;
  spec.robots = robots;
  spec.tools = tools;
  spec.folder = folder;
  spec.overrides = overrides;
  return spec;
}

void CampaignFile::write(const fs::path& folder) const {
  Json words;
  each_word([&](const char* key, auto member) { words[key] = campaign.*member; });
  const Json json{{"experiment", campaign.name},
                  {"command", campaign.command()},
                  {"version", version},
                  {"shard", shard},
                  {"words", words}};
  write_text(folder / name, json_text(json));
}

std::optional<CampaignFile> CampaignFile::read(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(folder / name, ignored)) return std::nullopt;
  const Reader map = Reader::load(folder / name);
  CampaignFile file;
  file.campaign.name = map["experiment"].text();
  file.version = map["version"].text();
  read_word(map["shard"], file.shard);
  if (file.campaign.name == CampaignFile::sweep) return file;
  const Reader words = map["words"];
  each_word([&](const char* key, auto member) {
    if (const auto word = words.find(key)) read_word(*word, file.campaign.*member);
  });
  return file;
}

void check_campaign(const Campaign& campaign, bool strict) {
  const polishing::Experiment& experiment = polishing::experiment_named(campaign.name);
  const bool any_robot = experiment.name == "robots" || experiment.name == "force_test";
  if (!any_robot && !(campaign.robots.empty() && campaign.tools.empty()))
    throw Error("--robot and --tool are for the experiments 'robots' and 'force_test'; wanted " +
                fmt::format("--set robot=NAME for '{}'", experiment.name));
  if (!campaign.folder.empty() && experiment.name != "robots")
    throw Error(
        fmt::format("--folder is for the experiment 'robots', not for '{}'", experiment.name));
  if (!campaign.folder.empty() && !campaign.robots.empty())
    throw Error("--folder selects the robots; wanted --folder without --robot and --tool");
  if (!campaign.folder.empty()) (void)polishing::public_robots_in(campaign.folder);
  (void)polishing::ranges_named(campaign.ranges);
  if (experiment.name != "seeds" && !campaign.ranges.empty())
    throw Error(
        fmt::format("--ranges is for the experiment 'seeds', not for '{}'", experiment.name));
  if (campaign.tools.size() > campaign.robots.size())
    throw Error(fmt::format(
        "--tool is given {} times and --robot {} times; wanted no more tools than robots",
        campaign.tools.size(), campaign.robots.size()));
  const polishing::ExperimentSpec spec = campaign.spec();
  std::set<std::string> robots;
  for (const std::string& surface :
       campaign.surfaces.empty() ? std::vector<std::string>{"table"} : campaign.surfaces)
    robots.insert(check_experiment_task(spec, surface).robot);
  for (const std::string& robot : robots) print_warnings_of(robot, strict);
}

int write_report(const polishing::ExperimentReport& report, const Campaign& campaign,
                 RunFolder& folder, bool quiet) {
  const std::string command = campaign.command();
  const std::vector<std::string> names = experiment_files(report);
  std::string unwritten;  // reason why files are missing
  try {
    folder.claim(names);
    write_experiment(report, campaign.name, command, folder.path());
    folder.finish();
  } catch (const Error& error) {
    unwritten = error.what();
  }
  if (!quiet) {
    fmt::print("{}", experiment_text(report, command));
    if (unwritten.empty())
      fmt::print("\nin {}: {}\n", folder.path().string(), fmt::join(names, ", "));
  }
  if (!unwritten.empty()) throw Error(unwritten);
  return report.failures.empty() && !report.interrupted ? exit_ok : exit_failed;
}

}  // namespace burnish::app
