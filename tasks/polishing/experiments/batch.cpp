#include "polishing/experiments/batch.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

namespace burnish::polishing {
namespace {

/// How much of all runs is done, as their progress functions tell.
class Progress {
 public:
  Progress(const ExperimentSpec& spec, std::size_t runs) : spec_(spec), shares_(runs, 0.0) {}

  void tell(std::size_t index, double share, const std::string& name) {
    if (!spec_.progress) return;
    const std::lock_guard lock(mutex_);
    shares_[index] = std::clamp(share, 0.0, 1.0);
    const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
    spec_.progress(sum / static_cast<double>(shares_.size()), name);
  }

 private:
  const ExperimentSpec& spec_;
  std::vector<double> shares_;
  std::mutex mutex_;
};

}  // namespace

void for_each_index(int count, int threads, const std::function<void(int index)>& work) {
  if (count <= 0) return;
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int wanted = std::min(count, threads > 0 ? threads : cores);
  std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(count));
  std::atomic<int> next = 0;
  const auto take = [&] {
    for (int index = next++; index < count; index = next++) {
      try {
        work(index);
      } catch (...) {
        thrown[static_cast<std::size_t>(index)] = std::current_exception();
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

std::vector<RunFigures> run_batch(
    const ExperimentSpec& spec, const std::vector<BatchRun>& runs,
    const std::function<void(int index, const RunResult& result)>& look) {
  std::vector<RunFigures> figures(runs.size());
  Progress progress(spec, runs.size());
  const auto stopped = [&] { return spec.stopped && spec.stopped(); };
  for_each_index(static_cast<int>(runs.size()), spec.threads, [&](int i) {
    const auto index = static_cast<std::size_t>(i);
    RunFigures& figure = figures[index];
    figure.name = runs[index].name;
    figure.outcome = "not run";
    figure.seed = runs[index].spec.task.disturbances.seed;
    if (stopped()) return;
    RunSpec run = runs[index].spec;
    run.progress = [&](double time, double end) {
      progress.tell(index, time / std::max(end, 1e-9), figure.name);
      return !stopped();
    };
    try {
      const RunResult result = run_task(run);
      figure = figures_of(runs[index].name, run.task, result);
      figure.made = !result.interrupted;
      if (look) look(i, result);
    } catch (const Error& error) {
      figure.outcome = error.what();
      figure.made = true;
    }
    progress.tell(index, 1.0, figure.name);
  });
  return figures;
}

void note_failures(const ExperimentSpec& spec, const std::vector<RunFigures>& runs,
                   ExperimentReport& report) {
  report.interrupted = report.interrupted || (spec.stopped && spec.stopped());
  long stopped = 0;
  for (const RunFigures& run : runs) {
    stopped += run.made ? 0 : 1;
    if (run.made && !run.polished) report.failures.push_back(run.name + ": " + run.outcome);
  }
  if (stopped > 0)
    report.failures.push_back(std::to_string(stopped) + " of " + std::to_string(runs.size()) +
                              " runs were stopped before their end, or not made");
}

}  // namespace burnish::polishing
