#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/degrees.hpp"
#include "base/sentence.hpp"
#include "pressing/closed_run.hpp"
#include "pressing/standing_terms.hpp"
#include "report/foot_rows.hpp"
#include "stand/swaying.hpp"

namespace burnish::stand {
namespace {

/// Where the base is in a row of a trace, by the columns of that prefix.
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

/// Root mean square and largest of what is added.
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

/// The run's rows up to `until` (s), from where the sway begins.
class Measured {
 public:
  Measured(const Task& task, RunResult& result)
      : task_(task),
        setting_(result.setting),
        trace_(result.trace),
        states_(trace_, setting_.robot.model),
        base_(states_.body().frame(setting_.base)),
        truth_(trace_, setting_.robot.model, "q_"),
        belief_(trace_, setting_.robot.model, "measured_q_") {
    for (const std::string& foot : setting_.standing.feet)
      feet_.push_back(states_.body().frame(foot));
  }

  std::optional<SwayFigures> figures(double until) {
    const Trace::Column phase = trace_.column("phase"), time = trace_.column("time");
    const Trace::Column tick = trace_.column("tick");
    double begin = -1.0;  // s, of the sway
    for (int row = 0; row < trace_.rows() && time[row] <= until; ++row) {
      if (states_.look(row) > Status::NotConverged) break;
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
    figures_.believed_place = place_.rms();
    figures_.believed_turn = believed_.rms();
    return figures_;
  }
  /// Whether it lies in the last row that is a state.
  bool fell() {
    constexpr double half = 0.5, most = 1.0;  // of its height; rad
    int row = trace_.rows() - 1;
    while (row >= 0 && states_.look(row) > Status::NotConverged) --row;
    if (row < 0) return false;
    const RigidBody& body = states_.body();
    const Lying lying = lying_at(setting_, trunk_at(task_, setting_, 0.0), body.com(),
                                 body.placement(base_).linear());
    return lying.sunk > half || lying.turned > most;
  }

 private:
  /// `since`: s since the sway began.
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
    place_.add((truth_.place(row) - belief_.place(row)).norm());
    believed_.add(turn_between(truth_.axes(row), belief_.axes(row)));
  }

  const Task& task_;
  const Setting& setting_;
  const Trace& trace_;
  StateRows states_;
  int base_;
  BaseRows truth_, belief_;
  std::vector<int> feet_;
  std::vector<Eigen::Isometry3d> start_;
  Errors com_, turn_, place_, believed_;
  SwayFigures figures_;
};

bool sways(const Sway& sway) { return !sway.shift.isZero(0.0) || !sway.turn.isZero(0.0); }

std::string outcome_of(const Task& task, const RunResult& result, const pressing::RunEnd& end) {
  const std::string& phase = phase_names()[static_cast<std::size_t>(end.phase)];
  const std::string trouble = pressing::trouble_of(result, end, phase);
  if (!trouble.empty()) return trouble;
  if (result.fell) return "it fell: the run ended at " + number(end.time) + " s, in phase " + phase;
  if (!result.sway)
    return "it did not come to sway: the run ended at " + number(end.time) + " s, in phase " +
           phase;
  constexpr double unloaded = 0.5;  // N, less is written as 0
  const double load = result.standing->least_load;
  char text[200];
  std::snprintf(text, sizeof text,
                "stood: %.1f s, the centre of mass %.1f mm and the base %.2f degrees rms off their "
                "way; each foot bore %.0f N or more and slid %.1f mm at most",
                end.time, 1e3 * result.sway->com_rmse, degrees_per_radian * result.sway->turn_rmse,
                load, 1e3 * result.sway->foot_slip);
  std::string outcome = text;
  if (load < unloaded) outcome += "; a foot came off the ground for a time";
  if (sways(task.sway) && !sways(result.setting.sway))
    outcome += "; no direction could be swayed in";
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
  const double longest = setting.standing.settle + end;
  pressing::ClosedRun run{
      .controller = mpc,
      .period = 1.0 / task.tick_rate,
      .model = model,
      .scene = setting.scene,
      .disturbances = pressing::for_feet(model, setting.standing, task.disturbances),
      .q_start = setting.q_start,
      .longest = longest + 1.0,
      .plant = spec.plant,
      .standing = &setting.standing,
      .mpc = &mpc,
      .plan_step = task.step,
      .solver_delay = task.solver_delay + task.command_delay,
      .plan_rate = spec.plan_rate};
  run.goes_on = [&](double now, const Command&) {
    return mpc.schedule().time() < end && now < longest + 0.5;
  };
  run.end = [longest] { return longest; };
  run.progress = spec.progress;
  const pressing::RunEnd ended = pressing::run_closed_loop(run, result);
  if (result.trace.rows() > 0) {
    Measured measured(task, result);
    result.sway = measured.figures(ended.time);
    result.fell = measured.fell();
  }
  result.outcome = outcome_of(task, result, ended);
  result.done = result.plant_status <= Status::NotConverged &&
                result.fault.kind == FaultKind::None && !result.interrupted && !result.fell &&
                mpc.schedule().time() >= end;
  return result;
}

}  // namespace burnish::stand
