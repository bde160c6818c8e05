// What an experiment is: many runs of the polishing task, and what they show.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burnish/report/svg_plot.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "polishing/experiments/results_table.hpp"
#include "polishing/experiments/run_store.hpp"

namespace burnish::polishing {

/// What is more is refused: every run is kept in mind before the first one is made.
inline constexpr int max_seeds = 10'000;

/// What became of the runs of an experiment.
struct RunCounts {
  int all = 0;     ///< of the experiment
  int wanted = 0;  ///< of these, of the shard
  int found = 0;   ///< of the shard's, that were there
  int made = 0;    ///< of the shard's, by this call
  int failed = 0;  ///< of those that are there now, that did not polish
};

/// How an experiment is performed.
/// @described polishing
struct ExperimentSpec {
  /// MUJOCO where this build has it
  PlantKind plant = has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal;
  int seeds = 0;  ///< at most 10 000; 0: the experiment's own number
  int first_seed = 0;
  int threads = 0;                         ///< runs at once; 0: as many as there are cores
  bool quick = false;                      ///< few and short runs, to see whether it works
  std::vector<std::string> surfaces = {};  ///< empty: the experiment's own
  std::string ranges = {};                 ///< of `seeds`: usual, wide or curved; empty: usual
  /// of the experiments `robots` and `force_test`; empty: their own
  std::vector<std::string> robots = {};
  /// the frame that each of these holds its tool with; "tool" for those that lack one
  std::vector<std::string> tools = {};
  /// of the experiment `robots`: a folder with descriptions of public robots, which are tried in
  /// place of those that come along; its list is robots.yaml there, or the shipped one; empty: none
  std::string folder = {};
  /// changes to the task, as override_task() takes them; what the experiment sweeps is set after
  /// them
  std::vector<std::string> overrides = {};
  /// called now and then with the share that is done, 0 to 1, and what is being done; from one
  /// thread at a time, but not always the same one. Returning False stops the experiment.
  std::function<void(double share, const std::string& what)> progress = nullptr;
  /// Whether to stop; called from several threads at once. @undescribed
  std::function<bool()> stopped = nullptr;
  /// Runs that it holds are not made again, and those that are made are kept in it; null: no run is
  /// kept. @undescribed
  const RunStore* store = nullptr;
  Shard shard = {};  ///< which runs are made @undescribed
  /// no run is made; throws Error where one is missing in the store @undescribed
  bool only_found = false;
  bool mixed = false;  ///< results of other kernels are taken too @undescribed
  /// s of computing (of a core, not of the clock) that a run may take; 0: 20 times the median of
  /// those before it, from the fifth on, and not less than 10. It ends between two ticks.
  /// @undescribed
  double time_limit = 0.0;
  RunCounts* counts = nullptr;  ///< where to put them @undescribed
  /// No run is made; it is called with each one's number from 0 on, its name in the store and its
  /// own. @undescribed
  std::function<void(std::size_t, const std::string& result, const std::string& run)> list =
      nullptr;

  /// Whether anybody reads the report: a list or a part of the runs has none.
  bool reports() const { return !list && shard.count == 1; }
};

/// A plot, and its file's name without ending.
/// @described polishing @result
struct Figure {
  std::string name;  ///< of its file, without ending
  PlotSpec plot;
};

/// A task worth running again by itself.
/// @described polishing @result
struct NamedTask {
  std::string name;  ///< of its file, without ending
  Task task;
};

/// What came out of an experiment.
/// @described polishing @result
struct ExperimentReport {
  std::string title;
  /// the first one has a row for every run (force_test: for every figure and controller)
  std::vector<ResultTable> tables = {};
  std::vector<Figure> figures = {};
  std::vector<NamedTask> tasks = {};
  std::vector<std::string> findings = {};  ///< sentences
  std::vector<std::string> failures = {};  ///< runs that did not polish, and why; empty: all did
  bool interrupted = false;
};

struct Experiment {
  std::string name;
  std::string summary;  ///< one line
  ExperimentReport (*perform)(const ExperimentSpec& spec);
};

/// paper, orientation, frames, seeds, tilt, surfaces, robots, force_test, standing, tick.
const std::vector<Experiment>& experiments();
/// Throws Error with the nearest known name.
const Experiment& experiment_named(const std::string& name);

/// The default task on a surface under a preset of disturbances, with the spec's overrides.
/// `duration`: s on the path, before the overrides. Throws Error as override_task() does.
Task experiment_task(const ExperimentSpec& spec, const std::string& surface,
                     const std::string& disturbances, double duration);

/// The spec's number of seeds, or else the experiment's own. Throws Error for too many.
int seeds_of(const ExperimentSpec& spec, int own);

/// The task on a surface. Throws Error where an override is bad or the surface is not known, before
/// anything is run.
Task check_experiment_task(const ExperimentSpec& spec, const std::string& surface);

}  // namespace burnish::polishing
