// How long the ticks of controllers took.
#pragma once

#include <vector>

#include "polishing/record/run_files.hpp"

namespace burnish::app {

/// Prints a row for each run, and below it one for the ticks that made a plan.
void print_times(const std::vector<polishing::PolishJob>& jobs,
                 const std::vector<polishing::RunResult>& results);

/// Prints what the times of plans stand beside: they do not pass in a simulation unless a task says
/// so.
void print_timing(const std::vector<polishing::PolishJob>& jobs,
                  const std::vector<polishing::RunResult>& results);

}  // namespace burnish::app
