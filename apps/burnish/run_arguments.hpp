// Options that the commands `burnish run` and `burnish polish` have in common.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace burnish::app {

/// Values of the options; members of options that were not given are empty.
struct RunArguments {
  std::string file, robot, tool, plant, out, write_task;
  std::vector<std::string> overrides;
  std::vector<int> seeds;
  int record_every = 10;
  bool no_page = false, plots = false, mcap = false, force = false, strict = false;
  bool unchecked = false, quiet = false, json = false;

  /// Returns whether to print text for people on the standard output.
  bool talks() const { return !quiet && !json; }
};

/// Help texts that differ between the commands: default values, and what is printed.
struct RunTexts {
  std::string robot, tool, out;  ///< Values of options that are not given.
  std::string key;               ///< Placeholder for an override, such as "KEY=VALUE".
  std::string quiet, json;       ///< What is printed with these options.
};

/// Adds the options to `command`; each sets a member of `a`. Adds neither the task file nor
/// options of one command only.
void add_run_options(CLI::App& command, RunArguments& a, const RunTexts& texts);

}  // namespace burnish::app
