// Options of the command `burnish polish`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run_arguments.hpp"

namespace burnish::app {

/// Values of the command's options; members of options that were not given are empty.
struct PolishArguments : RunArguments {
  std::string controller = {}, disturbances = {}, write_posture = {};
  std::vector<std::string> surfaces = {};
  std::optional<double> duration = {};
  bool time = false, assume_rotors = false;
  /// True for `burnish run`: a single run writes its files into the output folder itself, and
  /// prints its own metrics.
  bool is_run = false;

  /// Adds the options to `command`; each sets one of the members above.
  void add_to(CLI::App& command);
};

/// Makes the runs that the arguments select, and returns the exit code.
int polish(const PolishArguments& arguments);

}  // namespace burnish::app
