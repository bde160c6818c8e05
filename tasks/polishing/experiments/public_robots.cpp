#include "polishing/experiments/public_robots.hpp"

#include <algorithm>
#include <map>

#include "base/sentence.hpp"
#include "base/text_file.hpp"
#include "document/reader.hpp"
#include "polishing/experiments/shipped_tasks.hpp"

namespace burnish::polishing {
namespace {

namespace fs = std::filesystem;
using document::Reader;
using Commits = std::map<std::string, std::string>;

std::string text_at(const Reader& map, const char* key) {
  const auto value = map.find(key);
  return value ? value->text() : std::string();
}

/// Reads the keys that entries of arms and entries of robots with legs have in common.
PublicRobot read_source(const std::string& name, const Reader& map, const Commits& commits) {
  PublicRobot robot{
      .name = name, .repository = text_at(map, "repository"), .file = map["file"].text()};
  if (!robot.repository.empty()) {
    const auto found = commits.find(robot.repository);
    if (found == commits.end())
      map["repository"].refuse("repository " + in_quotes(robot.repository) +
                               " has no commit under the key 'repositories'");
    robot.commit = found->second;
  }
  if (const auto changes = map.find("set")) robot.changes = changes->texts();
  robot.because = text_at(map, "because");
  if (robot.changes.empty() != robot.because.empty())
    map.refuse("only one of the keys 'set' and 'because' is given; wanted both or none");
  return robot;
}

PublicRobot read_arm(const std::string& name, const Reader& map, const Commits& commits) {
  map.allow_only({"repository", "file", "tool", "set", "because"});
  PublicRobot robot = read_source(name, map, commits);
  robot.tool = map["tool"].text();
  return robot;
}

PublicRobot read_legged(const std::string& name, const Reader& map, const Commits& commits) {
  map.allow_only({"repository", "file", "feet", "task", "set", "because"});
  PublicRobot robot = read_source(name, map, commits);
  robot.feet = map["feet"].texts();
  if (robot.feet.empty()) map["feet"].refuse("the list is empty; wanted the frames of the feet");
  std::vector<std::string> tasks;
  for (const auto& [task, text] : shipped_stand_texts()) tasks.emplace_back(task);
  robot.task = map["task"].word(tasks);
  return robot;
}

/// Returns a cell with the text, or "-" for an empty text.
ResultCell cell(const std::string& text) {
  return text.empty() ? ResultCell("-") : ResultCell(text);
}

}  // namespace

std::string PublicRobot::url() const {
  if (repository.empty()) return file;
  return "https://github.com/" + repository + "/blob/" + commit + "/" + file;
}

std::vector<PublicRobot> parse_public_robots(const std::string& text, const std::string& name) {
  const Reader map = Reader::parse(text, name);
  map.allow_only({"repositories", "arms", "legged"});
  Commits commits;
  if (const auto repositories = map.find("repositories"))
    for (const auto& [repository, commit] : repositories->items())
      commits[repository] = commit.text();
  std::vector<PublicRobot> robots;
  const auto add = [&](const char* key, auto read) {
    const auto entries = map.find(key);
    if (!entries) return;
    for (const auto& [robot, entry] : entries->items())
      robots.push_back(read(robot, entry, commits));
  };
  add("arms", read_arm);
  add("legged", read_legged);
  if (robots.empty())
    map.refuse("there are no robots; wanted entries under the keys 'arms' and 'legged'");
  return robots;
}

std::vector<PublicRobot> shipped_public_robots() {
  return parse_public_robots(std::string(public_robots_text()), "public_robots.yaml");
}

std::optional<fs::path> find_description(const fs::path& folder, const PublicRobot& robot) {
  std::vector<std::string> places{""};
  if (!robot.repository.empty()) {
    const std::size_t slash = robot.repository.find('/');
    std::string joined = robot.repository;
    std::replace(joined.begin(), joined.end(), '/', '+');
    places = {joined, robot.repository, robot.repository.substr(slash + 1)};
  }
  std::error_code ignored;
  for (const std::string& place : places)
    if (fs::path file = folder / place / robot.file; fs::exists(file, ignored)) return file;
  return std::nullopt;
}

std::vector<PublicRobotFile> public_robots_in(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw Error("folder " + in_quotes(folder.string()) +
                " does not exist; wanted a folder of robot descriptions");
  const fs::path own = folder / public_robots_file;
  std::vector<PublicRobotFile> all;
  bool any = false;
  for (PublicRobot& robot :
       fs::exists(own, ignored)
           ? parse_public_robots(read_text(own, "list of robots"), own.string())
           : shipped_public_robots()) {
    auto file = find_description(folder, robot);
    any = any || file;
    all.push_back({std::move(robot), std::move(file)});
  }
  if (any) return all;
  const PublicRobot& first = all.front().robot;
  throw Error("folder " + in_quotes(folder.string()) + " has none of the " +
              std::to_string(all.size()) + " descriptions in the list of public robots; wanted " +
              in_quotes((fs::path(first.repository) / first.file).string()) + " or others");
}

ResultTable public_robots_table(const std::vector<PublicRobot>& robots) {
  ResultTable table{.name = "public_robots", .title = "Public robots"};
  table.columns = {{"robot"}, {"repository"}, {"commit"},  {"file"},
                   {"tool"},  {"feet"},       {"changes"}, {"because"}};
  const auto list = [](const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
  };
  for (const PublicRobot& robot : robots)
    table.add({robot.name, cell(robot.repository), cell(robot.commit.substr(0, 12)), robot.file,
               cell(robot.tool), cell(list(robot.feet)), cell(list(robot.changes)),
               cell(robot.because)});
  return table;
}

}  // namespace burnish::polishing
