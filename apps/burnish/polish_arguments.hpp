// Options of the command `burnish polish`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace burnish::app {

/// Values of the command's options; members of options that were not given are empty.
struct PolishArguments {
  std::string file, robot, tool, controller, plant, disturbances, out, write_task, write_posture;
  std::vector<std::string> surfaces, overrides;
  std::vector<int> seeds;
  std::optional<double> duration;
  int record_every = 10;
  bool quiet = false, json = false, time = false, unchecked = false, assume_rotors = false;
  bool no_page = false, plots = false, mcap = false, force = false, strict = false;

  /// Returns whether to print text for people on the standard output.
  bool talks() const { return !quiet && !json; }
  /// Adds the options to `command`; each sets one of the members above.
  void add_to(CLI::App& command);
};

}  // namespace burnish::app
