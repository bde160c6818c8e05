// Experiments: many runs of the polishing task, with tables and figures of their results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burnish/report/svg_plot.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/results_table.hpp"
#include "polishing/experiments/run_store.hpp"

namespace burnish::polishing {

/// Largest number of seeds. Bounds the memory that holds all runs before the first one is made.
inline constexpr int max_seeds = 10'000;

/// Numbers of runs of an experiment.
struct RunCounts {
  int all = 0;     ///< All runs of the experiment.
  int wanted = 0;  ///< Runs of the shard, the part of the experiment that this call makes.
  int found = 0;   ///< Runs of the shard whose results were in the store.
  int made = 0;    ///< Runs of the shard made by this call.
  int failed = 0;  ///< Runs, found or made, that did not polish.
};

/// Options of an experiment.
/// @described polishing
struct ExperimentSpec {
  /// Simulator; MUJOCO if this build includes it.
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  int seeds = 0;       ///< Number of seeds, at most 10 000; 0: the experiment's default.
  int first_seed = 0;  ///< First seed.
  int threads = 0;     ///< Number of parallel runs; 0: one per core.
  bool quick = false;  ///< Makes few and short runs, to test that the experiment works.
  std::vector<std::string> surfaces = {};  ///< Surfaces; empty: the experiment's surfaces.
  /// Ranges of the experiment `seeds`: usual, wide or curved; empty: usual.
  std::string ranges = {};
  /// Robots of the experiments `robots` and `force_test`; empty: the experiment's robots.
  std::vector<std::string> robots = {};
  /// Frames of the tools of `robots`, in order; "tool" for robots without an entry.
  std::vector<std::string> tools = {};
  /// Folder with descriptions of public robots for the experiment `robots`, in place of the bundled
  /// robots. The list of robots is robots.yaml in the folder, or else the bundled list. Empty:
  /// none.
  std::string folder = {};
  /// Changes of the task, in the notation of override_task(); keys that the experiment varies are
  /// set after them.
  std::vector<std::string> overrides = {};
  /// Called repeatedly with the completed fraction, 0 to 1, and the current run; from one thread at
  /// a time, but from different threads. Returning False stops the experiment.
  std::function<void(double share, const std::string& what)> progress = nullptr;
  /// Returns whether to stop; called from several threads at once. @undescribed
  std::function<bool()> stopped = nullptr;
  /// Store of results. Runs in the store are not repeated, and new results are added. Null: none.
  /// @undescribed
  const RunStore* store = nullptr;
  Shard shard = {};  ///< Runs to make. @undescribed
  /// If true, makes no run, and throws Error if the store lacks a result. @undescribed
  bool only_found = false;
  bool mixed = false;  ///< Accepts results made with other kernels. @undescribed
  /// Largest computing time of a run, on one core [s]; a longer run ends between two ticks. 0: ten
  /// times the 95 % quantile of earlier runs, at least 120 s; no limit for the first five runs.
  /// @undescribed
  double time_limit = 0.0;
  RunCounts* counts = nullptr;  ///< Receives the numbers of runs; null: not needed. @undescribed
  /// If set, no run is made; the function is called for each run instead. Its arguments are the
  /// run's index, the name of the run's result in the store, and the run's name. @undescribed
  std::function<void(std::size_t, const std::string& result, const std::string& run)> list =
      nullptr;

  /// Returns whether a report is made: not if runs are only listed or split into shards.
  bool reports() const { return !list && shard.count == 1; }
};

/// Plot with the name of its file.
/// @described polishing @result
struct Figure {
  std::string name;  ///< Name of the file, without extension.
  PlotSpec plot;
};

/// Task of a notable run, to repeat the run alone.
/// @described polishing @result
struct NamedTask {
  std::string name;  ///< Name of the file, without extension.
  Task task;
};

/// Results of an experiment.
/// @described polishing @result
struct ExperimentReport {
  std::string title;
  /// Tables; the first has a row for every run (force_test: for every figure and controller).
  std::vector<ResultTable> tables = {};
  std::vector<Figure> figures = {};
  std::vector<NamedTask> tasks = {};
  std::vector<std::string> findings = {};  ///< Main results, in sentences.
  /// Runs that did not polish, with the reasons; empty: all runs polished.
  std::vector<std::string> failures = {};
  bool interrupted = false;
};

struct Experiment {
  std::string name;
  std::string summary;  ///< Summary in one line.
  ExperimentReport (*perform)(const ExperimentSpec& spec);
};

/// Returns the list of all experiments.
const std::vector<Experiment>& experiments();
/// Returns the experiment of that name. Throws Error, with the nearest name, for unknown names.
const Experiment& experiment_named(const std::string& name);

/// Returns the default task on a surface, with the overrides of `spec`. `disturbances`: a preset.
/// `duration`: time on the path unless overridden [s]. Throws Error for an invalid override.
Task experiment_task(const ExperimentSpec& spec, const std::string& surface,
                     const std::string& disturbances, double duration);

/// Returns the number of seeds of `spec`, or `own` if `spec` has 0. Throws Error for more than
/// max_seeds.
int seeds_of(const ExperimentSpec& spec, int own);

/// Returns the task on a surface, to check it before any run. Throws Error for an invalid override
/// or an unknown surface.
Task check_experiment_task(const ExperimentSpec& spec, const std::string& surface);

}  // namespace burnish::polishing
