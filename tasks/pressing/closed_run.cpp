#include "pressing/closed_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/entry_error.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "pressing/arm.hpp"
#include "pressing/foot_posture.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::pressing {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Controller that forwards ticks to another controller and measures how long each takes. `ticks`:
/// expected number of ticks. Above a million ticks, only every nth tick is measured.
class Stopwatch final : public ControllerWrapper {
 public:
  Stopwatch(Controller& timed, double ticks)
      : ControllerWrapper(timed),
        every_(static_cast<long>(std::max(1.0, std::ceil(ticks / max_times)))) {
    times_.reserve(to_size(ticks / static_cast<double>(every_)) + 2);
  }
  void reset() noexcept override {
    ControllerWrapper::reset();
    times_.clear();
    ticks_ = 0;
  }
  const Command& tick(const Measurement& measurement) noexcept override {
    const bool noted = ticks_++ % every_ == 0 && times_.size() < times_.capacity();
    const Clock::time_point begin = Clock::now();
    const Command& command = ControllerWrapper::tick(measurement);
    if (noted) times_.push_back(seconds_since(begin));
    return command;
  }
  const std::vector<double>& times() const { return times_; }

 private:
  static constexpr double max_times = 1e6;  ///< Approximate largest number of stored times, 8 MB.

  long every_, ticks_ = 0;
  std::vector<double> times_;
};

TickTimes summarise(std::vector<double> times, double period) {
  TickTimes result{.period = period};
  if (times.size() < 2) return result;
  times.erase(times.begin());
  std::sort(times.begin(), times.end());
  const auto quantile = [&](double fraction) {
    const auto n = static_cast<double>(times.size());
    return times[to_size(std::max(1.0, std::ceil(fraction * n))) - 1];
  };
  result.count = static_cast<int>(times.size());
  result.median = quantile(0.5);
  result.p99 = quantile(0.99);
  result.maximum = times.back();
  for (const double time : times) {
    result.mean += time / result.count;
    result.late += time > period ? 1 : 0;
  }
  return result;
}

std::optional<BaseEstimatorOptions> estimator_of(const ClosedRun& run) {
  return run.standing != nullptr ? base_estimator(*run.standing) : std::nullopt;
}

/// Returns how long the simulation continues after a fault [s].
double after_fault_of(const ClosedRun& run) {
  constexpr double arm_stops = 0.3;  // time in which an arm comes to rest [s]
  if (run.mpc == nullptr) return 0.0;
  return run.standing != nullptr && run.standing->stands() ? run.standing->after_fault : arm_stops;
}

/// Largest number of rows in a trace: 100 s at the usual plant step, and 130 MB for six joints.
constexpr double max_rows = 200e3;

/// Largest number of recorded plans: 1000 s at the usual 20 Hz.
constexpr double max_plans = 20e3;

/// Steps the closed loop until the run ends.
RunEnd advance(const ClosedRun& run, ClosedLoop& loop, const Plant& plant, PlanRecorder* plans,
               TaskRun& result) {
  // Number of plant steps between two calls of the progress function.
  constexpr int progress_every = 100;
  std::optional<RunEnd> fault;
  const auto here = [&] { return RunEnd{plant.time(), loop.command().phase}; };
  const auto goes_on = [&] {
    return fault ? plant.time() < fault->time + after_fault_of(run)
                 : run.goes_on(plant.time(), loop.command());
  };
  for (long step = 0; goes_on(); ++step) {
    const Status status = loop.step();
    // Ignores failures of the plant after a fault, because the fault causes them.
    if (!fault) result.plant_status = worst(result.plant_status, status);
    if (plans != nullptr) plans->look(loop.measurement().time, loop.command());
    if (!is_usable(status)) break;
    if (!fault && run.mpc != nullptr && run.mpc->fault().kind != FaultKind::None) {
      fault = here();
      continue;
    }
    if (step % progress_every != 0 || !run.progress) continue;
    result.interrupted = !run.progress(plant.time(), run.end());
    if (result.interrupted) break;
  }
  return fault.value_or(here());
}

}  // namespace

std::vector<Push> with_frames(std::vector<Push> pushes, const Model& model,
                              const SceneSpec& scene) {
  for (Push& push : pushes)
    if (push.frame.empty())
      push.frame = scene.tool_index() >= 0 ? scene.tool().frame : base_frame(model);
  return pushes;
}

void check_disturbances(const Model& model, const SceneSpec& scene,
                        const Disturbances& disturbances) {
  for (const Push& push : disturbances.pushes)
    if (!push.frame.empty() && !model.has_frame(push.frame))
      throw EntryError("disturbances.pushes", "frame " + none_of(model, push.frame));
  about("disturbances", [&] {
    burnish::check_disturbances(model, disturbances);
    (void)checked_scene(model, plant_scene(scene, disturbances));
  });
}

RunEnd run_closed_loop(const ClosedRun& run, TaskRun& result) {
  const double dt = plant_step(run.period);
  const Model model = plant_model(run.model, run.disturbances);
  SceneSpec scene = plant_scene(run.scene, run.disturbances);
  if (run.standing != nullptr) scene.hoist = hoist_of(model, *run.standing);
  Disturbances disturbances = run.disturbances;
  disturbances.pushes = with_frames(disturbances.pushes, model, scene);
  const auto plant = make_plant(run.plant, model, scene, dt);
  std::optional<PlanRecorder> plans;
  if (run.mpc != nullptr)
    plans.emplace(*run.mpc, run.plan_step, run.solver_delay,
                  std::min(run.plan_rate, max_plans / run.end()));
  ClosedLoopOptions options;
  options.control_period = run.period;
  options.max_duration = run.longest + after_fault_of(run);
  options.record_every = static_cast<int>(std::ceil(options.max_duration / dt / max_rows));
  Stopwatch stopwatch(run.controller, options.max_duration / run.period);
  std::unique_ptr<Controller> from_home;
  if (run.home != nullptr)
    from_home = make_home_controller(run.model, *run.home, scene.tool().frame,
                                     scene.tool().surface.normal, stopwatch);
  Controller& controller = from_home ? *from_home : stopwatch;
  ClosedLoop loop(*plant, controller, disturbances, options);
  if (const auto estimator = estimator_of(run))
    loop.estimate_base(run.model, *estimator, foot_contact_options(run.model));
  const Clock::time_point begin = Clock::now();
  result.plant_status = loop.reset(from_home ? run.home->corners.front() : run.q_start,
                                   Eigen::VectorXd::Zero(run.model.nv));
  RunEnd end{plant->time(), loop.command().phase};
  if (is_usable(result.plant_status))
    end = advance(run, loop, *plant, plans ? &*plans : nullptr, result);
  result.wall_time = seconds_since(begin);
  if (run.mpc != nullptr) result.fault = run.mpc->fault();
  if (plans) result.plans = plans->take();
  result.trace = loop.trace();
  if (const std::vector<TouchSpec> supports = scene.supports();
      !supports.empty() && result.trace.rows() > 0)
    result.standing = measure_standing(result.trace, model, supports);
  if (!stopwatch.times().empty()) result.first_tick = stopwatch.times().front();
  result.ticks = summarise(stopwatch.times(), run.period);
  return end;
}

namespace {

/// Returns the fastest joint in the last row with finite velocities, as "; the fastest joint
/// before: 'knee', 120 rad/s".
std::string fastest_joint(const Trace& trace) {
  for (int row = trace.rows() - 1; row >= 0; --row) {
    std::string joint, unit;
    double fastest = 0.0;
    bool finite = true;
    for (std::size_t c = 0; c < trace.columns().size(); ++c) {
      const TraceColumn& column = trace.columns()[c];
      if (!column.name.starts_with("v_")) continue;
      const double speed = std::abs(trace.at(row, static_cast<int>(c)));
      finite = finite && std::isfinite(speed);
      if (!(speed > fastest)) continue;
      fastest = speed;
      joint = column.name.substr(2);
      unit = column.unit;
    }
    if (finite && !joint.empty())
      return "; the fastest joint before: " + in_quotes(joint) + ", " + number(fastest) + " " +
             unit;
  }
  return "";
}

}  // namespace

std::string trouble_of(const TaskRun& result, const RunEnd& end, const std::string& phase) {
  const std::string when = " at " + number(end.time) + " s";
  if (!is_usable(result.plant_status))
    return "the plant failed" + when + ": " + std::string(describe(result.plant_status)) +
           fastest_joint(result.trace);
  if (result.fault.kind != FaultKind::None)
    return result.fault.text() +
           (result.standing ? fell(*result.standing) ? "; the robot fell" : "; the robot stands"
                            : "");
  if (result.interrupted) return "interrupted" + when + ", in phase " + phase;
  return "";
}

double patience(double limit) {
  constexpr double usual = 3.0;  // usual limit [s]; chosen by hand
  return std::isfinite(limit) ? std::max(usual, limit) : usual;
}

}  // namespace burnish::pressing
