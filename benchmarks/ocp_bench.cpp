// Computing times of optimal control with 100 knots: values and expansion of the horizon, Riccati
// recursion, sequential rollout, one iteration, one MPC step. README.md describes names and use.
#include <benchmark/benchmark.h>

#include <functional>
#include <map>

#include "burnish/robots/robot.hpp"
#include "burnish/solver/ddp.hpp"
#include "polishing/pressing_controller.hpp"
#include "polishing/reference_problem.hpp"
#include "support/standing_problem.hpp"

namespace burnish::bench {
namespace {

constexpr int usual_knots = 100;

/// Problem with a guess near its solution, and the memory of its expansion.
class Horizon {
 public:
  explicit Horizon(const ProblemSpec& spec) : problem(spec) {
    const int knots = problem.knots();
    const int nx = problem.state().nx;
    const Eigen::Map<const Eigen::VectorXd> x0(problem.initial_state(), nx);
    const Eigen::VectorXd u0 = problem.quasi_static(0, x0).control;
    xs = x0.transpose().replicate(knots + 1, 1);
    us = u0.transpose().replicate(knots, 1);
    next = xs;
    values.resize(static_cast<std::size_t>(knots) + 1);
  }
  TrajectoryView view() const { return {xs.data(), us.data()}; }

  Problem problem;
  RowMatrix xs, us, next;
  std::vector<KnotValue> values;
};

ProblemSpec make(const std::string& name, int knots) {
  if (name == "talos_two_feet") {
    const Robot robot = load_robot("talos");
    return test::standing_problem(robot.model, {"left_sole_link", "right_sole_link"},
                                  robot.posture("half_sitting"), knots);
  }
  const Robot robot = load_robot("talos:right_arm");
  const Eigen::VectorXd q0 = robot.posture("table");
  ProblemSpec spec = polishing::reference_problem(robot.model, "tool", q0, knots);
  if (name == "talos_right_arm_filter") {
    spec.torque_model = TorqueModel{.cutoff = 100.0};
    const Eigen::Index nx = spec.initial_state.size();
    spec.initial_state.conservativeResize(nx + robot.model.nv);
    spec.initial_state.tail(robot.model.nv).setZero();
  }
  return spec;
}

Horizon& horizon(const std::string& name, int knots = usual_knots) {
  static std::map<std::pair<std::string, int>, std::unique_ptr<Horizon>> made;
  auto& entry = made[{name, knots}];
  if (!entry) entry = std::make_unique<Horizon>(make(name, knots));
  return *entry;
}

void values(benchmark::State& state, const std::string& name) {
  Horizon& h = horizon(name);
  for (auto _ : state)
    for (const KnotRange& range : h.problem.ranges())
      h.problem.evaluate(0, range, h.view(), h.next.data(), h.values.data());
}

void rollout(benchmark::State& state, const std::string& name) {
  Horizon& h = horizon(name);
  const int nx = h.problem.state().nx, nu = h.problem.max_controls();
  for (auto _ : state)
    for (int k = 0; k < usual_knots; ++k)
      h.problem.roll(0, k, h.xs.data() + k * nx, h.us.data() + k * nu, h.next.data() + k * nx);
}

/// Measures one iteration, always from the same guess, and its phases.
void iteration(benchmark::State& state, const std::string& name, int knots, DdpOptions options) {
  Horizon& h = horizon(name, knots);
  options.max_iterations = 1;
  DdpSolver solver(h.problem, options);
  double expand = 0.0, backward = 0.0, trial = 0.0;
  for (auto _ : state) {
    solver.set_guess(h.view());
    const DdpSummary& summary = solver.solve();
    expand += summary.seconds.expand;
    backward += summary.seconds.backward;
    trial += summary.seconds.trial;
  }
  const auto each = [](double seconds) {
    return benchmark::Counter(seconds, benchmark::Counter::kAvgIterations);
  };
  state.counters["expand"] = each(expand);
  state.counters["backward"] = each(backward);
  state.counters["trial"] = each(trial);
}

/// Measures a tick of a controller that computes a plan at every tick.
void tick(benchmark::State& state) {
  const std::string name = "talos_right_arm";
  polishing::PressingController controller(make(name, usual_knots), "tool");
  for (auto _ : state) controller.tick();
  if (controller.fault().kind != FaultKind::None)
    state.SkipWithError(controller.fault().text().c_str());
}

void add(const std::string& name) {
  const auto settings = [](benchmark::internal::Benchmark* b) {
    b->Unit(benchmark::kMillisecond)->UseRealTime();
  };
  settings(benchmark::RegisterBenchmark(("values/" + name).c_str(), values, name));
  settings(benchmark::RegisterBenchmark(("rollout/" + name).c_str(), rollout, name));
  for (const StepUpdate update : {StepUpdate::Rollout, StepUpdate::MultipleShooting})
    for (const int threads : {1, 2})
      settings(benchmark::RegisterBenchmark(
          ("iteration/" + name +
           (update == StepUpdate::Rollout ? "/rollout/threads:" : "/shooting/threads:") +
           std::to_string(threads))
              .c_str(),
          iteration, name, usual_knots, DdpOptions{.update = update, .threads = threads}));
}

/// Adds benchmarks of long horizons that are solved in segments.
void add_segments(const std::string& name, int knots) {
  for (const int segments : {1, 3, 5, 9, 17})
    for (const int threads : {1, 2}) {
      if (threads == 2 && segments > 5) continue;
      const std::string title = "segments/" + name + "/knots:" + std::to_string(knots) +
                                "/segments:" + std::to_string(segments) +
                                "/threads:" + std::to_string(threads);
      benchmark::RegisterBenchmark(
          title.c_str(), iteration, name, knots,
          DdpOptions{
              .update = StepUpdate::MultipleShooting, .threads = threads, .segments = segments})
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    }
}

}  // namespace
}  // namespace burnish::bench

int main(int argc, char** argv) {
  for (const char* name : {"talos_right_arm", "talos_right_arm_filter", "talos_two_feet"})
    burnish::bench::add(name);
  benchmark::RegisterBenchmark("tick/talos_right_arm", burnish::bench::tick)
      ->Unit(benchmark::kMillisecond);
  burnish::bench::add_segments("talos_right_arm", 100);
  burnish::bench::add_segments("talos_right_arm", 500);
  burnish::bench::add_segments("talos_right_arm", 2000);
  burnish::bench::add_segments("talos_right_arm_filter", 500);
  burnish::bench::add_segments("talos_two_feet", 100);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
