// Computing times of linear-quadratic problems with limits in a receding horizon of 100 knots, each
// solved from the previous solution, compared with the Riccati recursion alone. All times are CPU
// times. `Time`: mean of a tick; `p50`, `p95`: quantiles of the ticks; `recursion`: median of the
// backward recursion alone; `ratio`: p50 over `recursion`; `active`: number of active rows; `open`:
// fraction of ticks not solved to the tolerance within the budget.
// `limits/next_knot`: a tick lasts one knot, and solutions are shifted by a knot.
// `limits/tenth_of_knot`: a tick lasts a tenth of a knot, and solutions are not shifted.
// Arguments: nv, filtered, nu, feet, soles, and the load in percent, which sets how many limits are
// active.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

#include "limited_horizon.hpp"

namespace burnish::bench {
namespace {

constexpr int horizon = 100, first_ticks = 5;
/// Budget of a controller's plan.
constexpr LimitedLqBudget budget{.factorizations = 8, .sweeps = 8, .tolerance = 1e-5};

/// Returns the CPU time of this thread, which excludes other load of the machine [s].
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds(const Work& work) {
  const double begin = processor_time();
  work();
  return processor_time() - begin;
}

double quantile(std::vector<double> of, double fraction) {
  std::sort(of.begin(), of.end());
  return of[static_cast<std::size_t>(fraction * static_cast<double>(of.size() - 1))];
}

/// Closed loop of plans and plant. The plant is the model of the plans with small random
/// disturbances.
class Loop {
 public:
  Loop(const RobotSize& size, double load, int ticks_per_knot)
      : robot_(size, load),
        horizon_(robot_, horizon),
        ticks_per_knot_(ticks_per_knot),
        x_(robot_.start()) {}

  LimitedHorizon& problem() { return horizon_; }
  int shift() const { return ticks_per_knot_ == 1 ? 1 : 0; }
  void load() {
    stages_ = robot_.horizon(time_, horizon);
    horizon_.load(stages_, x_);
  }
  void move() {
    const Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd>(horizon_.z(0), robot_.nz());
    x_ += (robot_.next(stages_[0], z) - x_) / ticks_per_knot_;
    for (int i = 0; i < robot_.size.nv; ++i) x_[robot_.size.nv + i] += 0.002 * normal_(random_);
    time_ += LimitedRobot::knot_step / ticks_per_knot_;
  }

 private:
  LimitedRobot robot_;
  LimitedHorizon horizon_;
  int ticks_per_knot_;
  double time_ = 0.0;
  Eigen::VectorXd x_;
  std::vector<LimitedStage> stages_;
  std::mt19937 random_{5};
  std::normal_distribution<double> normal_;
};

void run(benchmark::State& state, int ticks_per_knot) {
  const auto argument = [&](int i) { return static_cast<int>(state.range(i)); };
  Loop loop({argument(0), argument(1), argument(2), argument(3), argument(4) != 0},
            0.01 * argument(5), ticks_per_knot);
  loop.load();
  loop.problem().solve_cold({.factorizations = 200, .sweeps = 80, .tolerance = budget.tolerance});
  std::vector<double> solves, bare;
  double factorizations = 0.0, sweeps = 0.0, active = 0.0, open = 0.0;
  const auto tick = [&] {
    loop.move();
    loop.load();
    LimitedLqResult result;
    solves.push_back(seconds([&] { result = loop.problem().solve_warm(budget, loop.shift()); }));
    factorizations += result.factorizations;
    sweeps += result.sweeps;
    open += !result.converged;
    active += loop.problem().active();
    bare.push_back(seconds([&] { benchmark::DoNotOptimize(loop.problem().recursion()); }));
  };
  for (int i = 0; i < first_ticks; ++i) tick();
  solves.clear(), bare.clear();
  factorizations = sweeps = active = open = 0.0;
  for (auto _ : state) {
    tick();
    state.SetIterationTime(solves.back());
  }
  const auto mean = [&](double sum) {
    return benchmark::Counter(sum, benchmark::Counter::kAvgIterations);
  };
  const double p50 = quantile(solves, 0.5), recursion = quantile(bare, 0.5);
  state.counters = {{"p50", p50},
                    {"p95", quantile(solves, 0.95)},
                    {"recursion", recursion},
                    {"ratio", p50 / recursion},
                    {"active", mean(active)},
                    {"factorizations", mean(factorizations)},
                    {"sweeps", mean(sweeps)},
                    {"open", mean(open)}};
}

void next_knot(benchmark::State& state) { run(state, 1); }
void tenth_of_knot(benchmark::State& state) { run(state, 10); }

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"nv", "filtered", "nu", "feet", "soles", "load"})->UseManualTime();
  b->Unit(benchmark::kMicrosecond);
  for (const int load : {10, 85, 105}) b->Args({6, 0, 6, 1, 0, load});
  for (const int load : {10, 80, 105}) b->Args({6, 6, 6, 1, 0, load});
  for (const int load : {10, 75, 80}) b->Args({36, 0, 30, 2, 1, load});
}
BENCHMARK(next_knot)->Name("limits/next_knot")->Apply(sizes)->Iterations(400);
BENCHMARK(tenth_of_knot)->Name("limits/tenth_of_knot")->Apply(sizes)->Iterations(400);

}  // namespace
}  // namespace burnish::bench
