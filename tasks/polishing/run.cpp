#include "burnish/tasks/polishing/run.hpp"

#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/dynamics/placement.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/tasks/polishing/margins.hpp"
#include "burnish/tasks/polishing/task_file.hpp"
#include "polishing/descriptions.hpp"
#include "polishing/figures.hpp"
#include "polishing/resting_hand.hpp"
#include "polishing/verdict.hpp"
#include "pressing/closed_run.hpp"
#include "pressing/home_move.hpp"
#include "pressing/standing_terms.hpp"

namespace burnish::polishing {
namespace {

/// Controller of a run, with the times of the run.
struct Pieces {
  std::unique_ptr<Controller> controller;
  MpcController* mpc = nullptr;  ///< The controller if it is an MpcController, else null.
  double period = 0.0;           ///< Period of the controller's ticks [s].
  double planned_end = 0.0;      ///< Planned end of the run [s].
  double patience = 0.0;         ///< Longest allowed delay of contact [s].
};

Pieces make_controller(const RunSpec& spec, const Setting& setting) {
  Pieces pieces;
  const Task& task = spec.task;
  const bool is_mpc = spec.controller == ControllerKind::Mpc;
  pieces.period = 1.0 / task.tick_rate;
  pieces.patience = pressing::patience(is_mpc ? task.tool_limits.late_contact_time : 0.0);
  if (is_mpc) {
    auto mpc = std::make_unique<MpcController>(make_mpc(task, setting));
    pieces.mpc = mpc.get();
    pieces.planned_end = setting.track_end + task.retreat_duration +
                         (task.standing.stands() ? task.standing.settle : 0.0);
    pieces.controller = std::move(mpc);
  } else {
    const bool is_baseline = spec.controller == ControllerKind::Baseline;
    const Model& model = setting.robot.model;
    pieces.controller = is_baseline
                            ? make_impedance_controller(model, make_baseline(task, setting))
                            : make_admittance_controller(model, make_admittance(task, setting));
    const double above = gap(setting.scene.tool(), setting.p_start);
    pieces.planned_end = above / task.approach_speed + task.ramp_duration + task.polish_duration;
  }
  pieces.planned_end += pressing::time_from_home(setting.home);
  return pieces;
}

/// Progress of a run: when its path started, and whether the run is over.
class Watch {
 public:
  Watch(const RunSpec& spec, const Pieces& pieces) : spec_(spec), pieces_(pieces) {}

  /// Returns the expected end of the run [s].
  double end() const {
    return track_begin_ < 0.0 ? pieces_.planned_end
                              : track_begin_ + spec_.task.polish_duration + after_path();
  }
  /// Returns whether the run continues after the time `now` [s].
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
  double track_begin_ = -1.0;  ///< Start of the path; negative before the start [s].
};

/// Returns whether the trace has a row from `start` to `end` [s]. Long runs have sparse rows.
bool has_rows(const Trace& trace, double start, double end) {
  const Trace::Column time = trace.column("time");
  return (time.array() >= start && time.array() <= end).any();
}

/// Computes the metrics on the path. Their time window excludes the start and the end of the path.
void measure_path(const RunSpec& spec, const pressing::RunEnd& end, const Watch& watch,
                  RunResult& result) {
  if (watch.track_begin() < 0.0) return;
  const PathSpec& path = spec.task.path;
  const bool grows = path.kind == PathKind::Circle || path.kind == PathKind::Spiral;
  const double path_end = watch.track_begin() + spec.task.polish_duration;
  MetricsSpec metrics;
  metrics.start = watch.track_begin() + (grows ? path.start_up : 0.0) + 0.2;
  metrics.end = std::min(end.time, path_end) - (watch.tracked(end.time) ? 0.2 : 0.01);
  // For a short run, the window begins at the start of the path.
  if (metrics.end - metrics.start < 0.5) {
    metrics.start = watch.track_begin();
    metrics.end = std::min(end.time, path_end) - 0.02;
  }
  if (!has_rows(result.trace, metrics.start, metrics.end)) return;
  const Setting& setting = result.setting;
  const Model& model = setting.robot.model;
  metrics.tool_axis = pressing_direction(spec.task, model);
  const Eigen::VectorXd& q_begin = setting.home ? setting.home->corners.front() : setting.q_start;
  metrics.tool_start_world =
      (surface_placement(model, q_begin, setting.scene.tool().surface).inverse() *
       frame_placement(model, q_begin, spec.task.tool))
          .linear();
  Trace buffer;
  result.metrics = measure(seen_from_surface(result.trace, buffer), model, metrics);
}

/// Computes the metrics of the verdict on the path, which begins after the force ramp.
void judge(const RunSpec& spec, const pressing::RunEnd& end, const Watch& watch,
           RunResult& result) {
  const double begin = watch.track_begin();
  const double last = std::min(end.time, begin + spec.task.polish_duration);
  if (begin < 0.0 || !has_rows(result.trace, begin, last)) return;
  Trace buffer;
  result.verdict = verdict_figures(spec.task, result.setting,
                                   seen_from_surface(result.trace, buffer), begin, last);
}

/// Computes the statistics of a resting hand on the path. Repeats the statistics of standing for
/// the feet alone, because the hand counts as a support too.
void measure_rest(const RunSpec& spec, const pressing::RunEnd& end, const Watch& watch,
                  RunResult& result) {
  if (!spec.task.rest.is_stated()) return;
  const Setting& setting = result.setting;
  if (result.standing)
    result.standing =
        measure_standing(result.trace, plant_model(setting.robot.model, spec.task.disturbances),
                         feet_in(spec.task, setting.scene));
  const double begin = watch.track_begin();
  const double last = std::min(end.time, begin + spec.task.polish_duration);
  if (begin < 0.0 || !has_rows(result.trace, begin, last)) return;
  result.rest = rest_figures(spec.task.rest, setting, result.trace, begin, last);
}

/// Returns the outcome of a run in one sentence. `failure`: reason why the run did not pass the
/// verdict; empty if the run passed.
std::string outcome_of(const Task& task, const RunResult& result, const Watch& watch,
                       const pressing::RunEnd& end, const std::string& failure) {
  const std::string when = " at " + number(end.time) + " s";
  const std::string phase = name_of(static_cast<Phase>(end.phase));
  if (const std::string trouble = pressing::trouble_of(result, end, phase); !trouble.empty())
    return trouble;
  if (watch.track_begin() < 0.0)
    return "no contact was made: the run was stopped" + when + ", in phase " + phase;
  if (!failure.empty()) return failure;
  if (!watch.tracked(end.time)) return "the path was not followed to its end: the run ended" + when;
  char text[80];
  std::snprintf(text, sizeof text, "polished: %.1f s, simulated in %.1f s", end.time,
                result.wall_time);
  const std::string cut_short =
      result.verdict ? cut_short_text(task, *result.verdict) : std::string();
  return text + (cut_short.empty() ? cut_short : "; " + cut_short);
}

void refuse_blocked_home(const Task& task, const Setting& setting, const ReachOptions& options) {
  const ReachReport move = check_home(task, setting, options);
  if (!move.ok()) throw Error("the motion from home to the start is not possible: " + move.text);
}

}  // namespace

std::string name_of(ControllerKind kind) { return words_of(kind).words[to_size(kind)].word; }

RunResult run_task(const RunSpec& spec) {
  check_task(spec.task);
  RunResult result;
  result.setting = make_setting(spec.task, spec.robot ? *spec.robot : load_task_robot(spec.task));
  const Setting& setting = result.setting;
  if (spec.check_reach) {
    result.reach = check_reach(spec.task, setting, spec.reach);
    if (!result.reach.ok()) throw Error("the task is out of reach: " + result.reach.text);
    refuse_blocked_home(spec.task, setting, spec.reach);
  }
  RunSpec fitted = spec;
  if (spec.controller == ControllerKind::Mpc)
    result.fitted = fit_gains(fitted.task, setting).changes;
  const Pieces pieces = make_controller(fitted, setting);
  Watch watch(spec, pieces);
  pressing::ClosedRun run{.controller = *pieces.controller,
                          .period = pieces.period,
                          .model = setting.robot.model,
                          .scene = setting.scene,
                          .disturbances = spec.task.disturbances,
                          .q_start = setting.q_start,
                          .home = setting.home ? &*setting.home : nullptr,
                          .longest = pieces.planned_end + pieces.patience + 1.0,
                          .plant = spec.plant,
                          .standing = &spec.task.standing,
                          .mpc = pieces.mpc,
                          .plan_step = spec.task.step,
                          .solver_delay = spec.task.solver_delay + spec.task.command_delay,
                          .plan_rate = spec.plan_rate};
  run.goes_on = [&](double now, const Command& command) { return watch.goes_on(now, command); };
  run.end = [&] { return watch.end(); };
  run.progress = spec.progress;
  const pressing::RunEnd end = pressing::run_closed_loop(run, result);
  measure_path(spec, end, watch, result);
  judge(spec, end, watch, result);
  measure_rest(spec, end, watch, result);
  std::string failure =
      result.verdict ? verdict_failure(spec.task, *result.verdict) : std::string();
  const auto add = [&](const std::string& more) {
    if (result.verdict && !more.empty())
      failure = failure.empty() ? "not polished: " + more : failure + "; " + more;
  };
  if (result.rest) add(rest_failure(spec.task, *result.rest));
  add(beyond_limits(setting.robot.model, result.trace, end.time));
  result.outcome = outcome_of(spec.task, result, watch, end, failure);
  result.succeeded = is_usable(result.plant_status) && result.fault.kind == FaultKind::None &&
                     !result.interrupted && watch.tracked(end.time) && failure.empty();
  return result;
}

}  // namespace burnish::polishing
