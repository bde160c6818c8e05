// burnish report: HTML page of earlier runs.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/renames.hpp"
#include "burnish/base/error.hpp"
#include "command.hpp"
#include "record/page_files.hpp"
#include "record/page_json.hpp"

namespace burnish::app {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> runs;
  std::string out = "report.html";
};

constexpr const char* wanted_run =
    "wanted a folder with run.json, as burnish polish, run and solve write";

/// Returns the run.json files that an argument refers to: a single file, the file in a run's
/// folder, or all files below a folder.
std::vector<fs::path> files_of(const std::string& argument) {
  const fs::path path = argument;
  std::error_code ignored;
  if (!fs::exists(path, ignored))
    throw Error(fmt::format("'{}' does not exist; {}", argument, wanted_run));
  if (!fs::is_directory(path, ignored)) return {path};
  if (fs::exists(path / "run.json", ignored)) return {path / "run.json"};
  std::vector<fs::path> files;
  constexpr auto readable = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(path, readable, ignored), end; at != end;
       at.increment(ignored))
    if (at->path().filename() == "run.json") files.push_back(at->path());
  if (files.empty()) throw Error(fmt::format("'{}' holds no run; {}", argument, wanted_run));
  std::sort(files.begin(), files.end());
  return files;
}

/// Renames the entries of a list that have a "name": columns, figures or phases.
void rename_entries(Json& list, std::string_view (*current)(std::string_view)) {
  if (!list.is_array()) return;
  for (Json& entry : list)
    if (entry.is_object() && entry.contains("name") && entry["name"].is_string()) {
      const auto name = entry["name"].get<std::string>();
      const std::size_t tail = name.rfind('.') + 1;  // keeps a prefix such as "solver."
      entry["name"] = name.substr(0, tail) + std::string(current(name.substr(tail)));
    }
}

/// Returns whether a run is of a task whose robot has no tool. Files of version 0.3 state a tool
/// frame for such robots too.
bool is_without_tool(const Json& run) {
  const Json facts = run.value("facts", Json::array());
  return std::any_of(facts.begin(), facts.end(), [](const Json& fact) {
    return fact == Json{"task", "stand"} || fact == Json{"task", "push_wall"};
  });
}

/// Replaces names and entries of a run from version 0.3 by the current ones.
Json with_current_names(Json runs) {
  for (Json& run : runs) {
    for (const char* table : {"series", "envelopes"})
      if (run.contains(table) && run[table].is_object() && run[table].contains("columns"))
        rename_entries(run[table]["columns"], current_column);
    if (run.contains("metrics")) rename_entries(run["metrics"], current_column);
    if (run.contains("phases")) rename_entries(run["phases"], current_phase);
    if (!run.contains("polished")) continue;
    run["succeeded"] = run["polished"];
    run.erase("polished");
    if (is_without_tool(run)) run["tool"] = {{"frame", ""}, {"tip_radius", 0.0}};
  }
  return runs;
}

/// Returns the runs in a file.
Json runs_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(fmt::format("'{}' cannot be opened", file.string()));
  const Json page = Json::parse(stream, nullptr, false);
  if (page.is_discarded() || !page.is_object())
    throw Error(fmt::format("'{}' is not a run: it is not a JSON object", file.string()));
  const auto format = page.find("format");
  if (format == page.end() || !format->is_string())
    throw Error(fmt::format("'{}' is not a run: the key 'format' is missing; {}", file.string(),
                            wanted_run));
  if (format->get<std::string>() != page_format)
    throw Error(fmt::format("'{}' has the format '{}'; wanted '{}'", file.string(),
                            format->get<std::string>(), page_format));
  const auto runs = page.find("runs");
  if (runs == page.end() || !runs->is_array() || runs->empty())
    throw Error(fmt::format("'{}' holds no run", file.string()));
  for (const Json& run : *runs)
    if (!run.is_object() || !run.contains("name") || !run["name"].is_string() ||
        !run.contains("series"))
      throw Error(
          fmt::format("'{}' holds a run without the key 'name' or 'series'", file.string()));
  return with_current_names(*runs);
}

/// Makes the names of runs unique by adding the name of the parent folder, or else a number.
void make_names_unique(std::vector<Json>& runs, const std::vector<fs::path>& files) {
  std::vector<std::string> names, given;
  for (const Json& run : runs) given.push_back(run["name"].get<std::string>());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::string name = given[i];
    std::error_code ignored;
    if (std::count(given.begin(), given.end(), name) > 1)
      name = fs::absolute(files[i], ignored).parent_path().parent_path().filename().string() + "/" +
             name;
    const std::string plain = name;
    for (int n = 2; std::find(names.begin(), names.end(), name) != names.end(); ++n)
      name = fmt::format("{} ({})", plain, n);
    names.push_back(name);
    runs[i]["name"] = name;
  }
}

void report(const ReportArguments& arguments) {
  std::vector<Json> runs;
  std::vector<fs::path> files;
  for (const std::string& argument : arguments.runs)
    for (const fs::path& file : files_of(argument))
      for (Json& run : runs_in(file)) {
        runs.push_back(std::move(run));
        files.push_back(file);
      }
  make_names_unique(runs, files);
  std::vector<std::string> names, texts;
  for (const Json& run : runs) {
    names.push_back(run["name"].get<std::string>());
    texts.push_back(run.dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  write_runs_page(names, texts, arguments.out);
  fmt::print("{} {} in {}\n", runs.size(), runs.size() == 1 ? "run" : "runs", arguments.out);
}

}  // namespace

void add_report(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("report", "Write one page of earlier runs");
  const auto arguments = std::make_shared<ReportArguments>();
  command
      ->add_option(
          "RUN", arguments->runs,
          "Folders with runs of burnish polish, run or solve, searched with their subfolders")
      ->type_name("")
      ->required();
  command->add_option("--out", arguments->out, "File for the page [report.html]")
      ->type_name("FILE");
  command->footer(
      "Examples:\n"
      "  burnish report polishing_run/table_mpc\n"
      "  burnish report before/table_mpc after/table_mpc --out comparison.html");
  command->callback([arguments, &exit_code] {
    report(*arguments);
    exit_code = exit_ok;
  });
}

}  // namespace burnish::app
