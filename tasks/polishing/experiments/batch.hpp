// Many runs, several at once, the same results for any number of threads.
#pragma once

#include <functional>

#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// A run that is to be made.
struct BatchRun {
  std::string name;
  RunSpec spec = {};
  std::string curves = {};  ///< name of the curves to keep; empty: none
  /// What is measured besides, of a run that came to its end; empty: nothing.
  std::function<std::vector<MeasuredFigure>(const RunResult& result)> measure = {};
  /// Makes the run in the place of run_task(spec), of which the seed alone counts then. Its figures
  /// are `made` unless the progress function stopped it.
  std::function<RunFigures(const RunProgress& progress)> perform = {};
  std::string depends_on = {};  ///< with `perform`: all that its result depends on
  /// Computing time that the run is allowed even where the runs before it were quicker [s]. The
  /// specification's time_limit goes before it.
  double usual_limit = 10.0;
};

/// Adds a run of the task on the spec's plant for each of `seeds` seeds from the spec's first on,
/// called `name` and its seed.
void add_seeds(const ExperimentSpec& spec, const std::string& name, const Task& task, int seeds,
               std::vector<BatchRun>& runs);

/// Calls `work` with 0 to count - 1, from `threads` threads (0: one per core). What a call throws
/// is thrown here, of the lowest number that threw, when all have ended.
void for_each_index(int count, int threads, const std::function<void(int index)>& work);

/// Makes the runs of the spec's shard that its store does not hold, and keeps a few figures of
/// each, in their order. An Error of a run becomes its outcome. Runs of other shards, and those
/// that are left after `stopped`, have the outcome "not run". Throws Error where a result cannot be
/// kept or is of other kernels.
std::vector<RunFigures> run_batch(const ExperimentSpec& spec, const std::vector<BatchRun>& runs);

/// Batches of one experiment, of which the later ones depend on what came out of the first: their
/// counts are added, and their progress is one.
class BatchSeries {
 public:
  /// `expected`: runs of all batches, about. The specification outlives the series.
  BatchSeries(const ExperimentSpec& spec, std::size_t expected);
  BatchSeries(const BatchSeries&) = delete;
  BatchSeries& operator=(const BatchSeries&) = delete;
  /// The first batch: run_batch() of the spec.
  std::vector<RunFigures> run(const std::vector<BatchRun>& runs);
  /// One that follows: all of its runs are made, in whatever shard.
  std::vector<RunFigures> run_all(const std::vector<BatchRun>& runs);

 private:
  std::vector<RunFigures> add(const ExperimentSpec& of, const std::vector<BatchRun>& runs);

  const ExperimentSpec& spec_;
  std::size_t expected_, before_ = 0;
  RunCounts counts_;
};

/// Adds a sentence for every run that did not polish, one for all that were stopped, and notes an
/// interruption and results of several kernels.
void note_failures(const ExperimentSpec& spec, const std::vector<RunFigures>& runs,
                   ExperimentReport& report);

}  // namespace burnish::polishing
