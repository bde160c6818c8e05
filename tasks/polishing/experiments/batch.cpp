#include "polishing/experiments/batch.hpp"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "dynamics/instruction_set.hpp"

namespace burnish::polishing {
namespace {

/// Progress of a batch, computed from the progress of each run.
class Progress {
 public:
  Progress(const ExperimentSpec& spec, std::size_t runs) : spec_(spec), fractions_(runs, 0.0) {}

  void report(std::size_t index, double fraction, const std::string& name) {
    if (!spec_.progress) return;
    const std::lock_guard lock(mutex_);
    fractions_[index] = std::clamp(fraction, 0.0, 1.0);
    const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
    spec_.progress(sum / static_cast<double>(fractions_.size()), name);
  }

 private:
  const ExperimentSpec& spec_;
  std::vector<double> fractions_;
  std::mutex mutex_;
};

/// Returns the CPU time of this thread, which does not count waiting while the machine is busy or
/// suspended [s].
double computed() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Limit of a run's computing time: a stated limit, or a multiple of the 95 % quantile of the
/// earlier runs' times. A multiple of the median would be too small for runs with plans, because
/// runs without plans are much faster.
class TimeLimit {
 public:
  explicit TimeLimit(double stated) : stated_(stated) {}

  void note(double seconds) {
    const std::lock_guard lock(mutex_);
    seen_.push_back(seconds);
  }
  double seconds() {
    constexpr double factor = 10.0;      // ratio of the limit to the quantile; chosen by hand
    constexpr double min_limit = 120.0;  // [s]; the slowest shipped runs take 10 s
    constexpr std::size_t min_runs = 5;  // number of earlier runs that the quantile needs
    if (stated_ > 0.0) return stated_;
    const std::lock_guard lock(mutex_);
    if (seen_.size() < min_runs) return std::numeric_limits<double>::infinity();
    return std::max(min_limit, factor * quantile_of(seen_, 0.95));
  }

 private:
  double stated_;
  std::vector<double> seen_;
  std::mutex mutex_;
};

/// Indices of runs in a batch.
using Indices = std::vector<std::size_t>;

/// Reads results from the store into `figures`. Returns the indices of runs in the shard that must
/// be made, because the store lacks a complete result.
Indices find_results(const ExperimentSpec& spec, const std::vector<BatchRun>& runs,
                     const std::vector<std::string>& names, std::vector<RunFigures>& figures,
                     RunCounts& counts) {
  Indices missing;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    figures[i].name = runs[i].name;
    figures[i].outcome = "not run";
    figures[i].seed = runs[i].spec.task.disturbances.seed;
    if (!spec.shard.has(i)) continue;
    ++counts.wanted;
    std::optional<RunFigures> found;
    if (spec.store != nullptr) found = spec.store->find(names[i]);
    // A run that reached its time limit is repeated, because the limit may be larger now.
    if (!found || (found->late && !spec.only_found)) {
      missing.push_back(i);
      continue;
    }
    figures[i] = std::move(*found);
    ++counts.found;
  }
  return missing;
}

[[noreturn]] void refuse_missing(const std::vector<BatchRun>& runs, const Indices& missing) {
  throw Error(std::to_string(missing.size()) + " of " + std::to_string(runs.size()) +
              " runs are missing, the first is " + in_quotes(runs[missing[0]].name) + " (number " +
              std::to_string(missing[0] + 1) + "); wanted all shards, each with all of its runs");
}

std::string kernels_text(const std::vector<RunFigures>& runs, std::size_t& sets) {
  std::map<std::string, int> counts;
  for (const RunFigures& run : runs)
    if (run.made) ++counts[run.kernels];
  sets = counts.size();
  std::string text;
  for (const auto& [kernels, count] : counts)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " with " + kernels;
  return text;
}

/// Throws Error if results were made with different kernels and spec.mixed is false.
void check_kernels(const ExperimentSpec& spec, std::vector<RunFigures> figures, bool makes_some) {
  if (spec.mixed) return;
  if (makes_some) figures.push_back({.made = true, .kernels = instruction_set()});
  std::size_t sets = 0;
  const std::string text = kernels_text(figures, sets);
  if (sets > 1)
    throw Error("the runs were made with kernels for different processors (" + text +
                (makes_some ? ", including those of this program" : "") +
                "), whose results differ in their last digits; wanted runs with the same kernels, "
                "or --mixed");
}

std::string name_in(const RunStore& store, const BatchRun& run) {
  if (run.perform) return store.name_of(run.name, run.depends_on);
  return store.name_of(run.name + (run.curves.empty() ? "" : ", curves " + run.curves), run.spec);
}

RunFigures perform(const BatchRun& run, const RunProgress& progress) {
  if (run.perform) return run.perform(progress);
  RunSpec spec = run.spec;
  spec.progress = progress;
  const RunResult result = run_task(spec);
  RunFigures figure = figures_of(run.name, spec.task, result);
  if (run.measure && figure.succeeded) figure.measured = run.measure(result);
  if (!run.curves.empty()) figure.curves = curves_of(result, run.curves);
  figure.made = !result.interrupted;
  return figure;
}

RunFigures make_run(const BatchRun& run, const RunProgress& goes_on, TimeLimit& limit) {
  RunFigures figure{.name = run.name, .seed = run.spec.task.disturbances.seed};
  const double begin = computed(), allowed = limit.seconds();
  const auto progress = [&](double time, double end) {
    figure.late = computed() - begin > allowed;
    return goes_on(time, end) && !figure.late;
  };
  try {
    RunFigures made = perform(run, progress);
    if (figure.late) {
      figure.outcome = "ended by its time limit";
      figure.made = true;
    } else {
      figure = std::move(made);
    }
  } catch (const Error& error) {
    figure.outcome = error.what();
    figure.refused = figure.made = true;
  }
  figure.computing = computed() - begin;
  figure.kernels = instruction_set();
  if (figure.made && !figure.refused && !figure.late) limit.note(figure.computing);
  return figure;
}

}  // namespace

void add_seeds(const ExperimentSpec& spec, const std::string& name, const Task& task, int seeds,
               std::vector<BatchRun>& runs) {
  for (int seed = spec.first_seed; seed < spec.first_seed + seeds; ++seed) {
    BatchRun run;
    run.name = name + ", seed " + std::to_string(seed);
    run.spec.task = task;
    run.spec.task.disturbances.seed = static_cast<std::uint64_t>(seed);
    run.spec.plant = spec.plant;
    runs.push_back(std::move(run));
  }
}

void for_each_index(int count, int threads, const std::function<void(int index)>& work) {
  if (count <= 0) return;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int wanted = std::min(count, threads > 0 ? threads : cores);
  std::vector<std::exception_ptr> thrown(to_size(count));
  std::atomic<int> next = 0;
  const auto take = [&] {
    for (int index = next++; index < count; index = next++) {
      try {
        work(index);
      } catch (...) {
        thrown[to_size(index)] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < wanted; ++i) others.emplace_back(take);
    take();
  }
  for (const std::exception_ptr& each : thrown)
    if (each) std::rethrow_exception(each);
}

std::vector<RunFigures> run_batch(const ExperimentSpec& spec, const std::vector<BatchRun>& runs) {
  std::vector<std::string> names(runs.size());
  for (std::size_t i = 0; i < runs.size() && spec.store != nullptr; ++i)
    if (spec.shard.has(i)) names[i] = name_in(*spec.store, runs[i]);
  std::vector<RunFigures> figures(runs.size());
  if (spec.list) {
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (spec.shard.has(i)) spec.list(i, names[i], runs[i].name);
    return figures;
  }
  RunCounts counts{.all = static_cast<int>(runs.size())};
  const Indices missing = find_results(spec, runs, names, figures, counts);
  if (spec.only_found && !missing.empty()) refuse_missing(runs, missing);
  check_kernels(spec, figures, !missing.empty());

  Progress progress(spec, runs.size());
  TimeLimit limit(spec.time_limit);
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (figures[i].made) {
      progress.report(i, 1.0, runs[i].name);
      if (!figures[i].refused && !figures[i].late) limit.note(figures[i].computing);
    }
  std::atomic<bool> unwritten = false;  // set by a failed write, which stops all other runs
  const auto stopped = [&] { return unwritten || (spec.stopped && spec.stopped()); };
  for_each_index(static_cast<int>(missing.size()), spec.threads, [&](int i) {
    const std::size_t index = missing[to_size(i)];
    const BatchRun& run = runs[index];
    if (stopped()) return;
    const RunFigures made = make_run(
        run,
        [&](double time, double end) {
          progress.report(index, time / std::max(end, 1e-9), run.name);
          return !stopped();
        },
        limit);
    figures[index] = made;
    progress.report(index, 1.0, run.name);
    if (!made.made || spec.store == nullptr) return;
    try {
      spec.store->keep(names[index], made);
    } catch (...) {
      unwritten = true;
      throw;
    }
  });
  for (const RunFigures& run : figures) {
    counts.made += run.made ? 1 : 0;
    counts.failed += run.made && !run.succeeded ? 1 : 0;
  }
  counts.made -= counts.found;
  if (spec.counts != nullptr) *spec.counts = counts;
  return figures;
}

BatchSeries::BatchSeries(const ExperimentSpec& spec, std::size_t expected)
    : spec_(spec), expected_(expected) {}

std::vector<RunFigures> BatchSeries::run(const std::vector<BatchRun>& runs) {
  return add(spec_, runs);
}

std::vector<RunFigures> BatchSeries::run_all(const std::vector<BatchRun>& runs) {
  ExperimentSpec spec = spec_;
  spec.shard = {};
  return add(spec, runs);
}

std::vector<RunFigures> BatchSeries::add(const ExperimentSpec& of,
                                         const std::vector<BatchRun>& runs) {
  ExperimentSpec spec = of;
  RunCounts counts;
  spec.counts = &counts;
  const double before = static_cast<double>(before_), all = static_cast<double>(runs.size());
  const double expected = std::max(static_cast<double>(expected_), before + all);
  if (spec_.progress)
    spec.progress = [&](double fraction, const std::string& what) {
      spec_.progress((before + fraction * all) / expected, what);
    };
  std::vector<RunFigures> figures = run_batch(spec, runs);
  before_ += runs.size();
  counts_.all += counts.all;
  counts_.wanted += counts.wanted;
  counts_.found += counts.found;
  counts_.made += counts.made;
  counts_.failed += counts.failed;
  if (spec_.counts != nullptr) *spec_.counts = counts_;
  return figures;
}

void note_failures(const ExperimentSpec& spec, const std::vector<RunFigures>& runs,
                   ExperimentReport& report) {
  report.interrupted = report.interrupted || (spec.stopped && spec.stopped());
  long stopped = 0;
  for (const RunFigures& run : runs) {
    stopped += run.made ? 0 : 1;
    if (run.made && !run.succeeded) report.failures.push_back(run.name + ": " + run.outcome);
  }
  if (stopped > 0)
    report.failures.push_back(std::to_string(stopped) + " of " + std::to_string(runs.size()) +
                              " runs were stopped or not made");
  std::size_t sets = 0;
  if (const std::string text = kernels_text(runs, sets); sets > 1)
    report.findings.push_back(
        "Runs were made with kernels for different processors, whose results "
        "differ in their last digits: " +
        text + ".");
}

}  // namespace burnish::polishing
