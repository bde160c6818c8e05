#include "burnish/tasks/polishing/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/verdict.hpp"

namespace burnish::polishing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Passes ticks through and notes how long they took: every nth where `ticks` of them are many.
class Stopwatch final : public Controller {
 public:
  Stopwatch(Controller& timed, double ticks)
      : timed_(&timed), every_(static_cast<long>(std::max(1.0, std::ceil(ticks / most)))) {
    times_.reserve(static_cast<std::size_t>(ticks / static_cast<double>(every_)) + 2);
  }
  int nv() const override { return timed_->nv(); }
  void reset() noexcept override {
    timed_->reset();
    times_.clear();
    ticks_ = 0;
  }
  const Command& tick(const Measurement& measurement) noexcept override {
    const bool noted = ticks_++ % every_ == 0 && times_.size() < times_.capacity();
    const Clock::time_point begin = Clock::now();
    const Command& command = timed_->tick(measurement);
    if (noted) times_.push_back(seconds_since(begin));
    return command;
  }
  const std::vector<double>& times() const { return times_; }

 private:
  static constexpr double most = 1e6;  ///< times that are kept, about: 8 MB

  Controller* timed_;
  long every_, ticks_ = 0;
  std::vector<double> times_;
};

TickTimes summarise(std::vector<double> times, double period) {
  TickTimes result{.period = period};
  if (times.size() < 2) return result;
  times.erase(times.begin());
  std::sort(times.begin(), times.end());
  const auto rank = [&](double share) {
    const auto n = static_cast<double>(times.size());
    return times[static_cast<std::size_t>(std::max(1.0, std::ceil(share * n))) - 1];
  };
  result.count = static_cast<int>(times.size());
  result.median = rank(0.5);
  result.p99 = rank(0.99);
  result.maximum = times.back();
  for (const double time : times) {
    result.mean += time / result.count;
    result.late += time > period ? 1 : 0;
  }
  return result;
}

/// The pieces of a run that live as long as it does.
struct Pieces {
  std::unique_ptr<Controller> controller;
  MpcController* mpc = nullptr;  ///< the same, where it is one
  std::unique_ptr<PlanRecorder> plans = nullptr;
  double period = 0.0;       ///< s between its ticks
  double planned_end = 0.0;  ///< s, of the run
  double patience = 0.0;     ///< s, see patience_of()
};

/// Rows of a trace: 100 s of the plants' usual steps, 130 MB for six joints.
constexpr double most_rows = 200e3;

/// Plans of a record: 1000 s of the usual 20 Hz.
constexpr double most_plans = 20e3;

/// s that contact may come later than planned: longer than the controller waits, if it has a limit.
double patience_of(const RunSpec& spec) {
  constexpr double usual = 3.0;
  const double limit = spec.task.tool_limits.late_contact_time;
  if (spec.controller != ControllerKind::Mpc || !std::isfinite(limit)) return usual;
  return std::max(usual, limit);
}

Pieces make_controller(const RunSpec& spec, const Setting& setting) {
  Pieces pieces;
  const Task& task = spec.task;
  pieces.patience = patience_of(spec);
  if (spec.controller == ControllerKind::Mpc) {
    auto mpc = std::make_unique<MpcController>(make_mpc(task, setting));
    pieces.mpc = mpc.get();
    pieces.planned_end = setting.track_end + task.retreat_duration;
    const double rate = std::min(spec.plan_rate, most_plans / pieces.planned_end);
    pieces.plans = std::make_unique<PlanRecorder>(*mpc, task.step, task.solver_delay, rate);
    pieces.controller = std::move(mpc);
    pieces.period = 1.0 / task.tick_rate;
  } else {
    const ImpedanceSpec baseline = make_baseline(task, setting);
    pieces.controller = make_impedance_controller(setting.robot.model, baseline);
    pieces.period = baseline.period;
    const double above = gap(setting.scene, setting.p_start);
    pieces.planned_end = above / baseline.approach_speed + baseline.ramp + task.polish_duration;
  }
  return pieces;
}

/// Follows a run: when its path began and whether it is over.
class Watch {
 public:
  Watch(const RunSpec& spec, const Pieces& pieces) : spec_(spec), pieces_(pieces) {}

  /// About when the run will be over, s.
  double end() const {
    return track_begin_ < 0.0 ? pieces_.planned_end
                              : track_begin_ + spec_.task.polish_duration + after_path();
  }
  /// Whether it goes on after `now`.
  bool goes_on(double now, const Command& command) {
    if (track_begin_ < 0.0 && command.phase == number_of(Phase::Track)) track_begin_ = now;
    if (track_begin_ < 0.0) return now < pieces_.planned_end + pieces_.patience;
    return now < end() - 1e-9;
  }
  bool tracked(double now) const {
    return track_begin_ >= 0.0 && now >= track_begin_ + spec_.task.polish_duration - 2e-3;
  }
  double track_begin() const { return track_begin_; }

 private:
  double after_path() const { return pieces_.mpc != nullptr ? spec_.task.retreat_duration : 0.0; }

  const RunSpec& spec_;
  const Pieces& pieces_;
  double track_begin_ = -1.0;  ///< s; negative: not yet
};

/// Steps until the run is over.
void advance(const RunSpec& spec, const Pieces& pieces, ClosedLoop& loop, const Plant& plant,
             Watch& watch, RunResult& result) {
  constexpr int between = 100;  // plant steps from one call of the progress function to the next
  for (long step = 0; watch.goes_on(plant.time(), loop.command()); ++step) {
    result.plant_status = worst(result.plant_status, loop.step());
    if (pieces.plans) pieces.plans->look(loop.measurement().time, loop.command());
    if (result.plant_status > Status::NotConverged) return;
    if (pieces.mpc != nullptr && pieces.mpc->fault().kind != FaultKind::None) return;
    if (step % between != 0 || !spec.progress) continue;
    result.interrupted = !spec.progress(plant.time(), watch.end());
    if (result.interrupted) return;
  }
}

/// Whether a window holds a row: those of long runs are far apart.
bool has_rows(const Trace& trace, double start, double end) {
  const Trace::Column time = trace.column("time");
  return (time.array() >= start && time.array() <= end).any();
}

/// From where the start of the path is over to a little before its end.
void measure_path(const RunSpec& spec, const Plant& plant, const Watch& watch, RunResult& result) {
  if (watch.track_begin() < 0.0) return;
  const PathSpec& path = spec.task.path;
  const bool grows = path.kind == PathKind::Circle || path.kind == PathKind::Spiral;
  const double path_end = watch.track_begin() + spec.task.polish_duration;
  MetricsSpec metrics;
  metrics.normal_world = plant.scene().surface.normal;
  metrics.start = watch.track_begin() + (grows ? path.start_up : 0.0) + 0.2;
  metrics.end = std::min(plant.time(), path_end) - (watch.tracked(plant.time()) ? 0.2 : 0.01);
  // A run that is too short for all of this is measured from the start of its path.
  if (metrics.end - metrics.start < 0.5) {
    metrics.start = watch.track_begin();
    metrics.end = std::min(plant.time(), path_end) - 0.02;
  }
  if (!has_rows(result.trace, metrics.start, metrics.end)) return;
  result.metrics = measure(result.trace, result.setting.robot.model, metrics);
}

/// All of the path that there was, from the ramp's end on.
void judge(const RunSpec& spec, const Plant& plant, const Watch& watch, RunResult& result) {
  const double begin = watch.track_begin();
  const double end = std::min(plant.time(), begin + spec.task.polish_duration);
  if (begin < 0.0 || !has_rows(result.trace, begin, end)) return;
  result.verdict = verdict_figures(spec.task, result.setting, result.trace,
                                   plant.scene().surface.normal, begin, end);
}

/// `failure`: what the verdict says, empty if nothing.
std::string outcome_of(const RunResult& result, const Watch& watch, double now, Phase phase,
                       const std::string& failure) {
  const std::string when = " at " + number(now) + " s";
  if (result.plant_status > Status::NotConverged)
    return "the plant failed" + when + ": " + std::string(describe(result.plant_status));
  if (result.fault.kind != FaultKind::None) return result.fault.text();
  if (result.interrupted) return "interrupted" + when + ", in phase " + name_of(phase);
  if (watch.track_begin() < 0.0)
    return "no contact was made: the run was given up" + when + ", in phase " + name_of(phase);
  if (!failure.empty()) return failure;
  if (!watch.tracked(now)) return "the path was not followed to its end: the run ended" + when;
  char text[80];
  std::snprintf(text, sizeof text, "polished: %.1f s, simulated in %.1f s", now, result.wall_time);
  return text;
}

}  // namespace

std::string name_of(ControllerKind kind) {
  return kind == ControllerKind::Mpc ? "mpc" : "baseline";
}
RunResult run_task(const RunSpec& spec) {
  check_task(spec.task);
  RunResult result;
  result.setting = make_setting(spec.task, spec.robot ? *spec.robot : load_task_robot(spec.task));
  const Setting& setting = result.setting;
  if (spec.check_reach) {
    result.reach = check_reach(spec.task, setting, spec.reach);
    if (!result.reach.ok()) throw Error("the task is out of reach: " + result.reach.text);
  }
  const Disturbances& disturbances = spec.task.disturbances;
  const Pieces pieces = make_controller(spec, setting);
  const double dt = plant_step(pieces.period);
  const auto plant = make_plant(spec.plant, plant_model(setting.robot.model, disturbances),
                                plant_scene(setting.scene, disturbances), dt);
  ClosedLoopOptions options;
  options.control_period = pieces.period;
  options.max_duration = pieces.planned_end + pieces.patience + 1.0;
  options.record_every = static_cast<int>(std::ceil(options.max_duration / dt / most_rows));
  Stopwatch stopwatch(*pieces.controller, options.max_duration / pieces.period);
  ClosedLoop loop(*plant, stopwatch, disturbances, options);
  Watch watch(spec, pieces);
  const Clock::time_point begin = Clock::now();
  result.plant_status = loop.reset(setting.q_start, Eigen::VectorXd::Zero(setting.robot.model.nv));
  if (result.plant_status <= Status::NotConverged)
    advance(spec, pieces, loop, *plant, watch, result);
  result.wall_time = seconds_since(begin);
  if (pieces.mpc != nullptr) result.fault = pieces.mpc->fault();
  if (pieces.plans) result.plans = pieces.plans->take();
  result.trace = loop.trace();
  if (!stopwatch.times().empty()) result.first_tick = stopwatch.times().front();
  result.ticks = summarise(stopwatch.times(), pieces.period);
  measure_path(spec, *plant, watch, result);
  judge(spec, *plant, watch, result);
  const std::string failure =
      result.verdict ? verdict_failure(spec.task, *result.verdict) : std::string();
  result.outcome =
      outcome_of(result, watch, plant->time(), static_cast<Phase>(loop.command().phase), failure);
  result.polished = result.plant_status <= Status::NotConverged &&
                    result.fault.kind == FaultKind::None && !result.interrupted &&
                    watch.tracked(plant->time()) && failure.empty();
  return result;
}

}  // namespace burnish::polishing
