// Tables of the durations of control ticks.
#pragma once

#include <vector>

#include "polishing/record/run_files.hpp"

namespace burnish::app {

/// Prints a row for all ticks of each run and, with MPC, a row for the ticks that computed a plan.
void print_times(const std::vector<polishing::PolishJob>& jobs,
                 const std::vector<polishing::RunResult>& results);

/// Prints a note if computing the plans took longer than the delay that the simulation applies.
void print_timing(const std::vector<polishing::PolishJob>& jobs,
                  const std::vector<polishing::RunResult>& results);

}  // namespace burnish::app
