#include "bench_measure.hpp"

#include <algorithm>
#include <chrono>
#include <functional>

#include "base/allocation_guard.hpp"
#include "burnish/contact/loops.hpp"
#include "burnish/derivatives/check.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/model/state.hpp"
#include "burnish/solver/ddp.hpp"
#include "derivatives/count_operations.hpp"
#include "derivatives/peak.hpp"
#include "polishing/pressing_controller.hpp"
#include "polishing/reference_problem.hpp"

namespace burnish::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int ring = 64;  ///< Number of different states, which are used in turn.

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void require(Status status, const char* what) {
  if (!is_usable(status))
    throw Error("bench: " + std::string(what) +
                " cannot be evaluated: " + std::string(describe(status)));
}

/// Repeats `work` for about `seconds`, but at least 20 times. Durations are divided by `pieces`,
/// the number of results per call.
BenchLine repeat(std::string group, std::string name, double seconds, int pieces,
                 const std::function<void()>& work,
                 const std::function<void(std::size_t)>& after = {}) {
  constexpr std::size_t min_count = 20, max_count = 200000;
  work();
  work();
  std::vector<double> times;
  times.reserve(max_count);
  long allocations = 0;
  const auto start = Clock::now();
  while (times.size() < min_count || (since(start) < seconds && times.size() < max_count)) {
    const AllocationGuard guard;
    const auto before = Clock::now();
    work();
    times.push_back(since(before) / pieces);
    allocations += guard.count();
    if (after) after(times.size() - 1);
  }
  BenchLine line{.group = std::move(group), .work = std::move(name)};
  line.allocations = AllocationGuard::unavailable() != nullptr
                         ? -1.0
                         : static_cast<double>(allocations) / static_cast<double>(times.size());
  std::sort(times.begin(), times.end());
  line.best = times.front();
  line.median = times[times.size() / 2];
  line.p99 = times[std::min(times.size() - 1, times.size() * 99 / 100)];
  return line;
}

/// Returns a contact of the tool along world z, and the contacts that close the robot's loops.
std::vector<ContactSpec> pressing(const Model& model, const std::string& tool) {
  ContactSpec contact{.name = "surface", .tool = tool, .directions = Directions::z()};
  return with_loops(model, {contact.with_gains(0.0, 50.0)});
}

/// Returns whether the tool can press along world z at q. A hanging pendulum, for example, cannot.
bool can_press(const Model& model, const std::string& tool, const Eigen::VectorXd& q) {
  ContactDynamics dynamics(model, pressing(model, tool));
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(model.nv);
  return is_usable(dynamics.forward(q, still, still));
}

/// Returns the requested posture. If none is requested, returns the first posture at which the tool
/// can press: the default posture, a named posture, or one of a few near the default. `name`:
/// receives the name of the posture.
Eigen::VectorXd usable_posture(const BenchSpec& spec, std::string& name) {
  const Robot& robot = spec.robot;
  name = spec.posture.empty() ? robot.default_posture : spec.posture;
  const Eigen::VectorXd q0 =
      spec.posture.empty() ? robot.reference_configuration() : robot.posture(spec.posture);
  if (can_press(robot.model, spec.tool, q0)) return q0;
  if (!spec.posture.empty())
    throw Error("bench: at posture '" + name + "' the tool '" + spec.tool +
                "' cannot press along world z: no joint moves the tool in this direction, or the "
                "mass matrix is singular; wanted another posture or tool");
  for (const auto& [other, posture] : robot.postures) {
    const Eigen::VectorXd q = robot.posture(other);
    name = other;
    if (can_press(robot.model, spec.tool, q)) return q;
  }
  name = "near " + (robot.default_posture.empty() ? "zero" : robot.default_posture);
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  for (int i = 0; i < 10; ++i) {
    const Eigen::VectorXd q =
        integrate(robot.model, q0,
                  Eigen::VectorXd::NullaryExpr(robot.model.nv, [&] { return uniform(generator); }));
    if (can_press(robot.model, spec.tool, q)) return q;
  }
  throw Error("bench: the tool '" + spec.tool +
              "' cannot press along world z at any posture tried: no joint moves the tool in "
              "this direction, or the mass matrix is singular; wanted another tool");
}

/// Measurement of contact dynamics, for single states and for packs (SIMD vectors) of states.
class States {
 public:
  States(const BenchSpec& spec, const Eigen::VectorXd& q0)
      : spec_(spec), model_(spec.robot.model), q_(model_.nq, ring), v_(model_.nv, ring) {
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto draw = [&](double size) {
      return Eigen::VectorXd(
          Eigen::VectorXd::NullaryExpr(model_.nv, [&] { return size * uniform(generator); }));
    };
    for (int i = 0; i < ring; ++i) {
      q_.col(i) = closed(integrate(model_, q0, draw(0.3)), q0);
      v_.col(i) = project_velocity_onto_loops(model_, q_.col(i), draw(1.0));
    }
    tau_ = Eigen::MatrixXd::Zero(model_.nv, ring);
    contacts_ = pressing(model_, spec.tool);
  }

  void measure(BenchReport& report) {
    const OperationCounts counts =
        count_operations(model_, contacts_, q_.col(0), v_.col(0), tau_.col(0));
    ContactDynamics single(model_, contacts_);
    const auto forward = [&](int i) {
      require(single.forward(q_.col(i), v_.col(i), tau_.col(i)), "the robot in contact");
    };
    BenchLine line = repeat("state", "dynamics, one at a time", spec_.seconds, ring, [&] {
      for (int i = 0; i < ring; ++i) forward(i);
    });
    add(report, line, counts.dynamics);
    line = repeat("state", "and derivatives, one at a time", spec_.seconds, ring, [&] {
      for (int i = 0; i < ring; ++i) {
        forward(i);
        require(single.forward_derivatives(), "the robot in contact");
      }
    });
    add(report, line, counts.derivatives);
    measure_batch(report, 1, counts);
    if (spec_.threads > 1) measure_batch(report, spec_.threads, counts);
  }

 private:
  void measure_batch(BenchReport& report, int threads, const OperationCounts& counts) {
    const int states = ring * threads;
    ContactDynamicsBatch batch(model_, contacts_, states, {}, threads, spec_.pin_threads);
    const Eigen::MatrixXd q = q_.replicate(1, threads), v = v_.replicate(1, threads),
                          tau = tau_.replicate(1, threads);
    const std::string name =
        "and derivatives, in packs" +
        (threads > 1 ? ", " + std::to_string(threads) + " threads" : std::string());
    add(report,
        repeat("state", name, spec_.seconds, states,
               [&] { require(batch.forward_with_derivatives(q, v, tau), "the robot in contact"); }),
        counts.derivatives);
    report.lines.back().peak_share /= threads;
  }

  /// Returns a configuration near q that closes the loops. If none is found, returns `otherwise`.
  Eigen::VectorXd closed(const Eigen::VectorXd& q, const Eigen::VectorXd& otherwise) const {
    const LoopProjection on = project_onto_loops(model_, q);
    return on.status == Status::Ok ? on.q : otherwise;
  }

  static void add(BenchReport& report, BenchLine line, const Operations& work) {
    line.peak_share =
        static_cast<double>(std::max(work.multiply, work.add)) / line.median / report.peak;
    report.lines.push_back(std::move(line));
  }

  const BenchSpec& spec_;
  const Model& model_;
  Eigen::MatrixXd q_, v_, tau_;
  std::vector<ContactSpec> contacts_;
};

/// Measures one solver iteration. All repetitions start from the same guess, as the updates of a
/// controller do.
void measure_iteration(BenchReport& report, const BenchSpec& spec, const ProblemSpec& problem_spec,
                       StepUpdate update, const std::string& name) {
  Problem problem(problem_spec);
  DdpSolver solver(problem, {.update = update,
                             .max_iterations = 1,
                             .threads = spec.threads,
                             .pin_threads = spec.pin_threads});
  const Eigen::Map<const Eigen::VectorXd> x0(problem.initial_state(), problem.state().nx);
  const RowMatrix xs = x0.transpose().replicate(spec.knots + 1, 1);
  const RowMatrix us = polishing::static_control(problem).transpose().replicate(spec.knots, 1);
  report.nx = problem.state().nx;
  report.nu = problem.max_controls();
  std::vector<PhaseTimes> phases;
  phases.reserve(200001);
  BenchLine line = repeat(
      "iteration", name, spec.seconds, 1,
      [&] {
        solver.set_guess({xs.data(), us.data()});
        solver.solve();
      },
      [&](std::size_t) { phases.push_back(solver.summary().seconds); });
  if (solver.summary().reason == StopReason::NotEvaluated)
    throw Error("bench: the horizon cannot be evaluated: " + solver.text());
  std::sort(phases.begin(), phases.end(),
            [](const PhaseTimes& a, const PhaseTimes& b) { return a.total < b.total; });
  const PhaseTimes& middle = phases[phases.size() / 2];
  line.expand = middle.expand;
  line.backward = middle.backward;
  line.trial = middle.trial;
  report.lines.push_back(std::move(line));
}

/// Measures a controller that computes a plan at every tick. The controller always receives the
/// measurements of a robot at rest.
void measure_ticks(BenchReport& report, const BenchSpec& spec, const ProblemSpec& problem) {
  const DdpOptions options{.threads = spec.threads, .pin_threads = spec.pin_threads};
  polishing::PressingController controller(problem, spec.tool, options);
  BenchLine line =
      repeat("tick", "MPC, a new plan at every tick", spec.seconds, 1, [&] { controller.tick(); });
  if (controller.fault().kind != FaultKind::None)
    throw Error("bench: the controller stopped with a fault: " + controller.fault().text());
  report.lines.push_back(std::move(line));
}

}  // namespace

BenchReport measure_speed(const BenchSpec& given) {
  BenchSpec spec = given;
  const Model& model = spec.robot.model;
  if (spec.tool.empty()) spec.tool = default_tool(model);
  std::string posture;
  const Eigen::VectorXd q0 = usable_posture(spec, posture);
  BenchReport report{.robot = model.name,
                     .tool = spec.tool,
                     .posture = posture,
                     .nq = model.nq,
                     .nv = model.nv,
                     .knots = spec.knots,
                     .threads = spec.threads,
                     .pack_width = pack_width()};
  report.peak = multiply_add_peak();
  States(spec, q0).measure(report);
  const ProblemSpec problem = polishing::reference_problem(model, spec.tool, q0, spec.knots);
  measure_iteration(report, spec, problem, StepUpdate::MultipleShooting, "multiple shooting");
  measure_iteration(report, spec, problem, StepUpdate::Rollout, "rollout");
  measure_ticks(report, spec, problem);
  return report;
}

}  // namespace burnish::app
