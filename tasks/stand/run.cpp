#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/degrees.hpp"
#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/mpc/mpc.hpp"
#include "pressing/closed_run.hpp"
#include "pressing/standing_terms.hpp"
#include "report/foot_rows.hpp"
#include "stand/swaying.hpp"

namespace burnish::stand {
namespace {

/// Pose of the base in the rows of a trace, from the columns whose names begin with `prefix`.
class BaseRows {
 public:
  BaseRows(const Trace& trace, const Model& model, const std::string& prefix)
      : trace_(trace), first_(trace.index(prefix + model.q_name(0))) {}
  Eigen::Vector3d place(int row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }
  Eigen::Matrix3d axes(int row) const {
    return Eigen::Quaterniond(at(row, 6), at(row, 3), at(row, 4), at(row, 5))
        .normalized()
        .toRotationMatrix();
  }

 private:
  double at(int row, int entry) const { return trace_.at(row, first_ + entry); }

  const Trace& trace_;
  int first_;
};

/// Accumulator of the root mean square and the maximum of errors.
class Errors {
 public:
  void add(double error) {
    sum_ += error * error;
    ++count_;
    peak_ = std::max(peak_, error);
  }
  double rms() const { return count_ > 0 ? std::sqrt(sum_ / count_) : 0.0; }
  double peak() const { return peak_; }

 private:
  double sum_ = 0.0, peak_ = 0.0;
  int count_ = 0;
};

/// Evaluation of the rows of a run: statistics of the sway, and fall of the robot.
class SwayRows {
 public:
  SwayRows(const Task& task, RunResult& result)
      : task_(task),
        setting_(result.setting),
        trace_(result.trace),
        states_(trace_, setting_.robot.model),
        base_(states_.body().frame(setting_.base)),
        truth_(trace_, setting_.robot.model, "q_"),
        estimate_(trace_, setting_.robot.model, "measured_q_") {
    for (const std::string& foot : setting_.standing.feet)
      feet_.push_back(states_.body().frame(foot));
  }

  /// Returns the statistics of the rows up to `until` [s]; nothing if the sway did not begin.
  std::optional<SwayFigures> figures(double until) {
    const Trace::Column phase = trace_.column("phase"), time = trace_.column("time");
    const Trace::Column tick = trace_.column("tick");
    double begin = -1.0;  // start of the sway [s]; negative: it has not begun
    for (int row = 0; row < trace_.rows() && time[row] <= until; ++row) {
      if (!is_usable(states_.look(row))) break;
      if (row == 0)
        for (const int foot : feet_) start_.push_back(states_.body().placement(foot));
      if (begin < 0.0 && phase[row] < static_cast<double>(sway)) continue;
      if (begin < 0.0) begin = time[row];
      look(time[row] - begin);
      if (tick[row] > 0.0) compare(row);
    }
    if (begin < 0.0) return std::nullopt;
    figures_.com_rmse = com_.rms();
    figures_.com_peak = com_.peak();
    figures_.turn_rmse = turn_.rms();
    figures_.turn_peak = turn_.peak();
    figures_.position_estimate_rmse = position_estimate_.rms();
    figures_.orientation_estimate_rmse = orientation_estimate_.rms();
    return figures_;
  }
  /// Returns whether the robot lies on the ground in the last row with a valid state.
  bool fell() {
    // Deviations above which the robot has fallen: TrunkFall::sunk, and TrunkFall::turned [rad].
    // Chosen by hand.
    constexpr double max_sunk = 0.5, max_turn = 1.0;
    int row = trace_.rows() - 1;
    while (row >= 0 && !is_usable(states_.look(row))) --row;
    if (row < 0) return false;
    const RigidBody& body = states_.body();
    const TrunkFall lying = lying_at(setting_, trunk_at(task_, setting_, 0.0), body.com(),
                                     body.placement(base_).linear());
    return lying.sunk > max_sunk || lying.turned > max_turn;
  }

 private:
  /// Accumulates errors of the trunk and slip of the feet. `since`: time since the sway began [s].
  void look(double since) {
    const RigidBody& body = states_.body();
    const Trunk wanted = trunk_at(task_, setting_, task_.settle_duration + since);
    com_.add((body.com() - wanted.com).norm());
    turn_.add(turn_between(wanted.base, body.placement(base_).linear()));
    figures_.com_end = (body.com() - setting_.com).norm();
    for (std::size_t i = 0; i < feet_.size(); ++i)
      figures_.foot_slip = std::max(
          figures_.foot_slip, slip_of(start_[i], body.placement(feet_[i]), setting_.standing));
  }
  void compare(int row) {
    position_estimate_.add((truth_.place(row) - estimate_.place(row)).norm());
    orientation_estimate_.add(turn_between(truth_.axes(row), estimate_.axes(row)));
  }

  const Task& task_;
  const Setting& setting_;
  const Trace& trace_;
  StateRows states_;
  int base_;
  BaseRows truth_, estimate_;
  std::vector<int> feet_;
  std::vector<Eigen::Isometry3d> start_;
  Errors com_, turn_, position_estimate_, orientation_estimate_;
  SwayFigures figures_;
};

bool sways(const Sway& sway) { return !sway.shift.isZero(0.0) || !sway.turn.isZero(0.0); }

std::string outcome_of(const Task& task, const RunResult& result, const pressing::RunEnd& end) {
  const std::string& phase = phase_names()[to_size(end.phase)];
  const std::string trouble = pressing::trouble_of(result, end, phase);
  if (!trouble.empty()) return trouble;
  if (result.fell)
    return "the robot fell: the run ended at " + number(end.time) + " s, in phase " + phase;
  if (!result.sway)
    return "the sway did not begin: the run ended at " + number(end.time) + " s, in phase " + phase;
  constexpr double unloaded = 0.5;  // smaller loads are printed as 0 [N]
  const double load = result.standing->min_load;
  char text[200];
  std::snprintf(text, sizeof text,
                "stood: %.1f s, rms error of %.1f mm for the centre of mass and %.2f degrees for "
                "the base; load of each foot at least %.0f N, slip at most %.1f mm",
                end.time, 1e3 * result.sway->com_rmse, degrees_per_radian * result.sway->turn_rmse,
                load, 1e3 * result.sway->foot_slip);
  std::string outcome = text;
  if (load < unloaded) outcome += "; a foot lost contact with the ground for a time";
  if (sways(task.sway) && !sways(result.setting.sway))
    outcome += "; no direction of the sway was possible";
  return outcome;
}

}  // namespace

RunResult run_task(const RunSpec& spec) {
  const Task& task = spec.task;
  check_task(task);
  RunResult result;
  result.setting = spec.setting ? *spec.setting : make_setting(task);
  const Setting& setting = result.setting;
  const Model& model = setting.robot.model;
  if (spec.check_reach) refuse_out_of_reach(task, setting);
  MpcController mpc(make_mpc(task, setting));
  const double end = setting.sway_end + task.rest_duration;
  const double max_duration = setting.standing.settle + end;
  pressing::ClosedRun run{
      .controller = mpc,
      .period = 1.0 / task.tick_rate,
      .model = model,
      .scene = setting.scene,
      .disturbances = pressing::for_feet(model, setting.standing, task.disturbances),
      .q_start = setting.q_start,
      .longest = max_duration + 1.0,
      .plant = spec.plant,
      .standing = &setting.standing,
      .mpc = &mpc,
      .plan_step = task.step,
      .solver_delay = task.solver_delay + task.command_delay,
      .plan_rate = spec.plan_rate};
  run.goes_on = [&](double now, const Command&) {
    return mpc.schedule().time() < end && now < max_duration + 0.5;
  };
  run.end = [max_duration] { return max_duration; };
  run.progress = spec.progress;
  const pressing::RunEnd ended = pressing::run_closed_loop(run, result);
  if (result.trace.rows() > 0) {
    SwayRows measured(task, result);
    result.sway = measured.figures(ended.time);
    result.fell = measured.fell();
  }
  result.outcome = outcome_of(task, result, ended);
  result.succeeded = is_usable(result.plant_status) && result.fault.kind == FaultKind::None &&
                     !result.interrupted && !result.fell && mpc.schedule().time() >= end;
  return result;
}

}  // namespace burnish::stand
