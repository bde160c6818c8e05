#include "tick_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace burnish::app {

void print_times(const std::vector<polishing::PolishJob>& jobs,
                 const std::vector<polishing::RunResult>& results) {
  fmt::print(
      "\ntime of a tick [ms]       rate [Hz]   ticks  median     p99     max   first   late\n");
  for (std::size_t i = 0; i < results.size(); ++i) {
    const polishing::TickTimes& t = results[i].ticks;
    fmt::print("{:<24}  {:9.0f}  {:6d}  {:6.3f}  {:6.3f}  {:6.3f}  {:6.1f}  {:5d}\n", jobs[i].name,
               1.0 / t.period, t.count, 1e3 * t.median, 1e3 * t.p99, 1e3 * t.maximum,
               1e3 * results[i].first_tick, t.late);
    if (!results[i].metrics || !results[i].metrics->solver) continue;
    const SolverFigures& s = *results[i].metrics->solver;
    fmt::print("{:<24}  {:9.0f}  {:6d}  {:6.3f}  {:6.3f}  {:6.3f}\n", "  of these, with a plan",
               jobs[i].spec.task.update_rate, s.updates, 1e3 * s.median, 1e3 * s.p99,
               1e3 * s.maximum);
  }
}

void print_timing(const std::vector<polishing::PolishJob>& jobs,
                  const std::vector<polishing::RunResult>& results) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    const polishing::Task& task = jobs[i].spec.task;
    if (!results[i].metrics || !results[i].metrics->solver || task.timing != PlanTiming::Fixed ||
        results[i].metrics->solver->p99 <= task.solver_delay)
      continue;
    const std::string used =
        task.solver_delay > 0.0
            ? fmt::format(
                  "plans are used {:g} ms after their measurement, independent of their computing "
                  "time (controller.timing fixed)",
                  1e3 * task.solver_delay)
            : "plans take no time in this simulation (controller.timing fixed, solver_delay 0)";
    const std::string late = std::isinf(task.limits.deadline) ? ", and none counts as late" : "";
    return fmt::print("{}{}: --set controller.timing=measured uses the times of the table\n", used,
                      late);
  }
}

}  // namespace burnish::app
