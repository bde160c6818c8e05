#include "bench_task.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <optional>
#include <thread>
#include <vector>

#include "base/allocation_guard.hpp"
#include "base/thread_pool.hpp"
#include "base/to_size.hpp"
#include "burnish/derivatives/contact_dynamics_batch.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/report/metrics.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/solver/ddp.hpp"
#include "burnish/tasks/polishing/run.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::app {
namespace {

using Clock = std::chrono::steady_clock;

double between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

Spread spread(std::vector<double> times) {
  Spread result{.count = static_cast<long>(times.size())};
  if (times.empty()) return result;
  std::sort(times.begin(), times.end());
  result.median = times[times.size() / 2];
  result.p99 = times[std::min(times.size() - 1, times.size() * 99 / 100)];
  result.maximum = times.back();
  return result;
}

/// Gives this thread real-time priority and locked memory for the lifetime of the object, if the
/// system permits it.
class Urgent {
 public:
  Urgent() {
    locked_ = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
    pthread_getschedparam(pthread_self(), &policy_, &usual_);
    sched_param urgent = usual_;
    urgent.sched_priority = 50;
    has_priority_ = pthread_setschedparam(pthread_self(), SCHED_FIFO, &urgent) == 0;
  }
  ~Urgent() {
    if (has_priority_) pthread_setschedparam(pthread_self(), policy_, &usual_);
    if (locked_) munlockall();
  }
  Urgent(const Urgent&) = delete;
  Urgent& operator=(const Urgent&) = delete;
  bool has_priority() const { return has_priority_; }

 private:
  int policy_ = SCHED_OTHER;
  sched_param usual_ = {};
  bool locked_ = false, has_priority_ = false;
};

/// Counter of the memory allocations in planning threads. A callback of the solver updates it.
class PlanAllocations {
 public:
  explicit PlanAllocations(std::thread::id ticking) : ticking_(ticking) {}
  bool look() noexcept {
    if (std::this_thread::get_id() == ticking_) return true;
    thread_local const AllocationGuard since_first;
    count_ = since_first.count();
    return true;
  }
  long count() const { return count_; }

 private:
  std::thread::id ticking_;
  std::atomic<long> count_ = 0;
};

/// Controller that runs the ticks of another controller and records their durations. The ticks
/// start periodically in real time, or as soon as possible.
class Pacer final : public ControllerWrapper {
 public:
  Pacer(MpcController& mpc, std::optional<EstimatedBase>& base, double period, double max_duration,
        bool is_paced)
      : ControllerWrapper(mpc), mpc_(&mpc), base_(&base), period_(period), is_paced_(is_paced) {
    const auto capacity = to_size(max_duration / period) + 2;
    for (std::vector<double>* times : {&tick_, &woken_, &plan_, &age_, &plant_})
      times->reserve(capacity);
  }
  const Command& tick(const Measurement& measurement) noexcept override;

  bool is_on_path() const { return on_path_; }
  RealTime times() const;

 private:
  void wait_until_due() noexcept;

  MpcController* mpc_;
  std::optional<EstimatedBase>* base_;
  double period_;
  bool is_paced_, on_path_ = false;
  long ticks_ = 0, missed_ = 0, allocations_ = 0;
  Clock::time_point first_ = {}, due_ = {}, ended_ = {};
  std::vector<double> tick_, woken_, plan_, age_, plant_;
};

/// Sleeps until the tick is due. On this platform, steady_clock is CLOCK_MONOTONIC.
void Pacer::wait_until_due() noexcept {
  if (ticks_ == 0) first_ = Clock::now();
  const auto ahead = std::chrono::duration<double>(period_ * static_cast<double>(ticks_));
  due_ = first_ + std::chrono::duration_cast<Clock::duration>(ahead);
  const auto since = std::chrono::duration_cast<std::chrono::nanoseconds>(due_.time_since_epoch());
  timespec at{};
  at.tv_sec = static_cast<time_t>(since.count() / 1'000'000'000);
  at.tv_nsec = static_cast<long>(since.count() % 1'000'000'000);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) == EINTR) {
  }
}

const Command& Pacer::tick(const Measurement& measurement) noexcept {
  const Clock::time_point back = Clock::now();
  if (is_paced_) wait_until_due();
  const Clock::time_point began = Clock::now();
  const AllocationGuard guard;
  const Command& command = mpc_->tick(*base_ ? (*base_)->update(measurement) : measurement);
  const long allocated = guard.count();
  const Clock::time_point ended = Clock::now();
  if (on_path_) {
    allocations_ += allocated;
    tick_.push_back(between(began, ended));
    woken_.push_back(between(due_, began));
    plant_.push_back(between(ended_, back));
    age_.push_back(mpc_->plan_age());
    if (command.solve_time > 0.0) plan_.push_back(command.solve_time);
    missed_ += between(due_, ended) > period_ ? 1 : 0;
  }
  ended_ = ended;
  on_path_ = command.phase == number_of(Phase::Track);
  ++ticks_;
  return command;
}

RealTime Pacer::times() const {
  RealTime real{.ticks = static_cast<long>(tick_.size()), .missed = missed_};
  real.tick = spread(tick_);
  real.woken = spread(woken_);
  real.plan = spread(plan_);
  real.age = spread(age_);
  const double time = period_ * static_cast<double>(std::max<std::size_t>(tick_.size(), 1));
  real.plans_per_second = static_cast<double>(plan_.size()) / time;
  real.tick_allocations = AllocationGuard::unavailable() != nullptr ? -1 : allocations_;
  for (const double took : plant_) real.plant_share += took / time;
  return real;
}

/// Closed-loop run of a task's controller on a plant, from the start until the end of the path.
class Run {
 public:
  Run(const polishing::Task& task, const MpcSpec& mpc, const polishing::Setting& setting,
      double max_duration)
      : setting_(setting),
        plant_(make_plant(has_mujoco() ? PlantKind::Mujoco : PlantKind::Ideal,
                          plant_model(setting.robot.model, task.disturbances),
                          plant_scene(setting.scene, task.disturbances),
                          plant_step(mpc.tick_period))),
        mpc_(mpc),
        pacer_(mpc_, base_, mpc.tick_period, max_duration, mpc.timing == PlanTiming::Thread) {
    ClosedLoopOptions options;
    options.control_period = mpc.tick_period;
    options.max_duration = max_duration;
    const auto estimator = pressing::base_estimator(task.standing);
    if (estimator) {
      base_.emplace(setting.robot.model, *estimator);
      options.imu_frame = estimator->imu_frame;
    }
    loop_.emplace(*plant_, pacer_, task.disturbances, options);
  }

  void start() {
    const Eigen::VectorXd rest = Eigen::VectorXd::Zero(setting_.robot.model.nv);
    if (base_ && !is_usable(base_->reset(setting_.q_start, rest)))
      throw Error("bench: the estimator of the floating base cannot start");
    if (!is_usable(loop_->reset(setting_.q_start, rest)))
      throw Error("bench: the plant cannot start");
  }
  /// Advances by one tick. Returns false at the end of the path and after a fault.
  bool step() {
    const bool was_on_path = pacer_.is_on_path();
    if (!is_usable(loop_->step())) throw Error("bench: the plant failed");
    return mpc_.fault().kind == FaultKind::None && (!was_on_path || pacer_.is_on_path());
  }
  MpcController& mpc() { return mpc_; }
  const Pacer& pacer() const { return pacer_; }
  const Command& command() const { return loop_->command(); }
  double time() const { return plant_->time(); }
  /// Returns the metrics on the path, without the first 0.5 s of the path.
  Metrics metrics() const {
    const Trace::Column phase = loop_->trace().column("phase"),
                        time = loop_->trace().column("time");
    MetricsSpec window{.start = time[time.size() - 1]};
    for (Eigen::Index i = time.size() - 1; i >= 0; --i)
      if (phase[i] == static_cast<double>(number_of(Phase::Track)))
        window.start = std::min(window.start, time[i] + 0.5);
    Trace buffer;
    return measure(seen_from_surface(loop_->trace(), buffer), setting_.robot.model, window);
  }

 private:
  const polishing::Setting& setting_;
  std::unique_ptr<Plant> plant_;
  MpcController mpc_;
  std::optional<EstimatedBase> base_;
  Pacer pacer_;
  std::optional<ClosedLoop> loop_;
};

/// Returns the longest simulated duration of a run, with 5 s of reserve for late contact [s].
double max_duration(const polishing::Task& task, const polishing::Setting& setting) {
  return setting.track_end + task.standing.settle + task.retreat_duration + 5.0;
}

/// Measures plans in simulated time. No other thread runs during a plan.
PlanTimes measure_plans(const polishing::Task& task, const polishing::Setting& setting,
                        MpcSpec mpc) {
  constexpr std::size_t max_plans = 500;
  mpc.timing = PlanTiming::Fixed;
  Run run(task, mpc, setting, max_duration(task, setting));
  run.start();
  std::vector<double> whole, expand, backward, trial;
  double recursions = 0.0, last = -1.0;
  while (run.step() && whole.size() < max_plans) {
    const Command& command = run.command();
    const DdpSummary& summary = run.mpc().solver().summary();
    const bool is_new = command.solve_time > 0.0 && command.solve_time != last;
    last = command.solve_time;
    if (!run.pacer().is_on_path() || !is_new) continue;
    whole.push_back(command.solve_time);
    expand.push_back(summary.seconds.expand);
    backward.push_back(summary.seconds.backward);
    trial.push_back(summary.seconds.trial);
    for (const DdpProgress& each : summary.log) recursions += each.factorizations;
  }
  if (run.mpc().fault().kind != FaultKind::None)
    throw Error("bench: the controller stopped with a fault: " + run.mpc().fault().text());
  const auto count = static_cast<double>(std::max<std::size_t>(whole.size(), 1));
  return {spread(whole), spread(expand), spread(backward), spread(trial), recursions / count};
}

RealTime measure_in_real_time(const polishing::Task& task, const polishing::Setting& setting,
                              MpcSpec mpc) {
  const auto allocations = std::make_shared<PlanAllocations>(std::this_thread::get_id());
  mpc.timing = PlanTiming::Thread;
  mpc.update_period = mpc.tick_period;  // plans as often as possible
  mpc.solver_delay = std::min(mpc.solver_delay, mpc.update_period);
  mpc.solver.callback = [allocations](const DdpProgress&) { return allocations->look(); };
  Run run(task, mpc, setting, max_duration(task, setting));
  const Urgent urgent;  // the planning threads exist already and keep normal priority
  run.start();
  while (run.time() < max_duration(task, setting) && run.step()) {
  }
  RealTime real = run.pacer().times();
  real.plan_allocations = real.tick_allocations < 0 ? -1 : allocations->count();
  real.has_priority = urgent.has_priority();
  real.fault = run.mpc().fault();
  if (real.ticks == 0) return real;
  const Metrics metrics = run.metrics();
  real.force_rmse = metrics.force_rmse;
  real.path_rmse = metrics.position_rmse;
  return real;
}

}  // namespace

TaskBenchReport measure_task(const TaskBenchSpec& spec) {
  polishing::Task task = spec.task;
  task.polish_duration = spec.seconds;
  polishing::check_task(task);
  const polishing::Setting setting = polishing::make_setting(task);
  MpcSpec mpc = polishing::make_mpc(task, setting);
  mpc.solver.threads = spec.threads;
  const Problem problem(mpc.problem);
  const KnotTimes knots(knot_steps(mpc.problem));
  TaskBenchReport report{.robot = setting.robot.model.name,
                         .nv = setting.robot.model.nv,
                         .nx = problem.layout().ndx(),
                         .nu = problem.layout().nu,
                         .knots = problem.knots(),
                         .threads = spec.threads,
                         .pack_width = pack_width(),
                         .cores = allowed_cores(),
                         .horizon = knots.after(knots.knots()),
                         .tick_period = mpc.tick_period};
  report.plans = measure_plans(task, setting, mpc);
  report.real = measure_in_real_time(task, setting, mpc);
  return report;
}

}  // namespace burnish::app
