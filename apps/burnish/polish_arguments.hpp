// The command line of burnish polish.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace burnish::app {

/// Values of the options of the command; empty for options that the user did not give.
struct PolishArguments {
  std::string file, robot, tool, controller, plant, disturbances, out, write_task, write_posture;
  std::vector<std::string> surfaces, overrides;
  std::vector<int> seeds;
  std::optional<double> duration;
  int record_every = 10;
  bool quiet = false, json = false, time = false, unchecked = false, assume_rotors = false;
  bool no_page = false, plots = false, mcap = false, force = false, strict = false;

  /// Returns whether to print human-readable text to standard output.
  bool talks() const { return !quiet && !json; }
  /// Adds the options that set these members to `command`.
  void add_to(CLI::App& command);
};

}  // namespace burnish::app
