// Many runs, several at once, the same results for any number of threads.
#pragma once

#include <functional>

#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// A run that is to be made.
struct BatchRun {
  std::string name;
  RunSpec spec;
};

/// Calls `work` with 0 to count - 1, from `threads` threads (0: one per core). What a call throws
/// is thrown here, of the lowest number that threw, when all have ended.
void for_each_index(int count, int threads, const std::function<void(int index)>& work);

/// Makes the runs and keeps a few figures of each, in their order. `look` sees a whole result
/// before its trace is forgotten, called from several threads, each with its own index. An Error
/// of a run becomes its outcome. After `stopped` the runs that are left have the outcome "not run".
std::vector<RunFigures> run_batch(
    const ExperimentSpec& spec, const std::vector<BatchRun>& runs,
    const std::function<void(int index, const RunResult& result)>& look = nullptr);

/// Adds a sentence for every run that did not polish, one for all that were stopped, and notes an
/// interruption.
void note_failures(const ExperimentSpec& spec, const std::vector<RunFigures>& runs,
                   ExperimentReport& report);

}  // namespace burnish::polishing
