// Batches of runs over several threads; results do not depend on the number of threads.
#pragma once

#include <functional>

#include "polishing/experiments/experiment.hpp"
#include "polishing/experiments/run_figures.hpp"

namespace burnish::polishing {

/// One run of a batch.
struct BatchRun {
  std::string name;
  RunSpec spec = {};
  std::string curves = {};  ///< Name under which the curves of the run are kept; empty: not kept.
  /// Returns additional measurements of a completed run; empty: none.
  std::function<std::vector<MeasuredFigure>(const RunResult& result)> measure = {};
  /// If set, this function makes the run in place of run_task(spec), and only the seed of `spec` is
  /// used. It returns figures with `made` set, unless the progress function stopped the run.
  std::function<RunFigures(const RunProgress& progress)> perform = {};
  std::string depends_on = {};  ///< Text of all inputs of the result; used only with `perform`.
};

/// Adds runs of the task on the plant of `spec`, with `seeds` consecutive seeds that start at
/// spec.first_seed. The name of a run consists of `name` and the seed.
void add_seeds(const ExperimentSpec& spec, const std::string& name, const Task& task, int seeds,
               std::vector<BatchRun>& runs);

/// Calls work(0) to work(count - 1), from `threads` threads (0: one per core). If calls throw,
/// rethrows the exception of the lowest index after all calls have ended.
void for_each_index(int count, int threads, const std::function<void(int index)>& work);

/// Makes the runs in the shard of `spec` whose results are missing in the store of `spec`. Returns
/// the statistics of all runs in order. An Error of a run becomes its outcome. The outcome "not
/// run" marks runs of other shards, and runs that did not begin before spec.stopped returned true.
/// Throws Error if a result cannot be written, or was made with kernels for another processor.
std::vector<RunFigures> run_batch(const ExperimentSpec& spec, const std::vector<BatchRun>& runs);

/// Batches of one experiment, where later batches depend on results of earlier batches. Run counts
/// and progress cover all batches together.
class BatchSeries {
 public:
  /// `expected`: approximate number of runs of all batches. `spec` must outlive the series.
  BatchSeries(const ExperimentSpec& spec, std::size_t expected);
  BatchSeries(const BatchSeries&) = delete;
  BatchSeries& operator=(const BatchSeries&) = delete;
  /// Makes the first batch by run_batch().
  std::vector<RunFigures> run(const std::vector<BatchRun>& runs);
  /// Makes a later batch, including the runs of other shards.
  std::vector<RunFigures> run_all(const std::vector<BatchRun>& runs);

 private:
  std::vector<RunFigures> add(const ExperimentSpec& of, const std::vector<BatchRun>& runs);

  const ExperimentSpec& spec_;
  std::size_t expected_, before_ = 0;
  RunCounts counts_;
};

/// Adds failures to the report: one sentence for every run that did not polish, and one sentence
/// for all stopped runs. Also marks an interrupted report, and adds a finding if runs used kernels
/// for different processors.
void note_failures(const ExperimentSpec& spec, const std::vector<RunFigures>& runs,
                   ExperimentReport& report);

}  // namespace burnish::polishing
