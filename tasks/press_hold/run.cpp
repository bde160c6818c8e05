#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "base/to_size.hpp"
#include "burnish/mpc/mpc.hpp"
#include "burnish/tasks/press_hold/press_hold.hpp"
#include "press_hold/measured.hpp"
#include "pressing/closed_run.hpp"

namespace burnish::press_hold {
namespace {

/// Returns the index of the first row that belongs to `phase` or to a later phase.
int first_row(const Trace& trace, int phase) {
  const Trace::Column phases = trace.column("phase");
  return static_cast<int>(
      std::find_if(phases.begin(), phases.end(), [&](double now) { return now >= phase; }) -
      phases.begin());
}

/// Measures force and slip between the end of the ramp and the end of the hold.
void measure_hold(RunResult& result) {
  const Trace& trace = result.trace;
  const Setting& setting = result.setting;
  const Model& model = setting.robot.model;
  const int begin = first_row(trace, 2), end = first_row(trace, 4);
  const Trace::Column time = trace.column("time");
  const double last = end - begin < 2 ? 0.0 : time[end - 1];
  if (!(last - time[begin] > min_measured - before_retreat)) return;
  MetricsSpec spec;
  spec.start = time[begin] + after_ramp;
  spec.end = last - before_retreat;
  result.metrics = measure(trace, model, spec);
  HoldFigures& hold = result.hold.emplace();
  for (int k = 0; k < model.nq; ++k) {
    const Trace::Column q = trace.column("q_" + model.q_name(k));
    hold.moved_aside = std::max(hold.moved_aside, std::abs(q[end - 1] - q[begin]));
  }
  const int tool = trace.index("tool_x_world");
  for (int row = begin; row < end; ++row) {
    const Eigen::Vector3d p(trace.at(row, tool), trace.at(row, tool + 1), trace.at(row, tool + 2));
    const Eigen::Vector3d off = setting.surface_axes.transpose() * (p - setting.p_hold);
    hold.slip = std::max(hold.slip, off.head<2>().norm());
  }
}

std::string outcome_of(const RunResult& result, const pressing::RunEnd& end) {
  const std::string& phase = phase_names()[to_size(end.phase)];
  if (const std::string trouble = pressing::trouble_of(result, end, phase); !trouble.empty())
    return trouble;
  if (!result.hold)
    return "the hold was not completed: the run ended at " + number(end.time) + " s, in phase " +
           phase;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "held: %.1f s, joints moved aside by up to %.2f rad, rms force error %.2f N, slip %.2f mm",
      end.time, result.hold->moved_aside, result.metrics->force_rmse, 1e3 * result.hold->slip);
  return text;
}

}  // namespace

void refuse_out_of_reach(const Task& task, const Setting& setting) {
  const ReachReport reach = check_reach(task, setting);
  if (!reach.ok()) throw Error("the task is out of reach: " + reach.text);
}

RunResult run_task(const RunSpec& spec) {
  const Task& task = spec.task;
  check_task(task);
  RunResult result;
  result.setting = spec.setting ? *spec.setting : make_setting(task);
  const Setting& setting = result.setting;
  if (spec.check_reach) refuse_out_of_reach(task, setting);
  MpcController mpc(make_mpc(task, setting));
  const double end = setting.hold_end + task.retreat_duration;
  const double max_duration = end + pressing::patience(task.tool_limits.late_contact_time);
  pressing::ClosedRun run{.controller = mpc,
                          .period = 1.0 / task.tick_rate,
                          .model = setting.robot.model,
                          .scene = setting.scene,
                          .disturbances = task.disturbances,
                          .q_start = setting.q_start,
                          .longest = max_duration,
                          .plant = spec.plant,
                          .mpc = &mpc,
                          .plan_step = 0.01,
                          .plan_rate = spec.plan_rate};
  // The run ends when the schedule's clock reaches `end`. The clock stops while contact is late.
  run.goes_on = [&](double now, const Command&) {
    return mpc.schedule().time() < end && now < max_duration;
  };
  run.end = [end] { return end; };
  run.progress = spec.progress;
  const pressing::RunEnd ended = pressing::run_closed_loop(run, result);
  measure_hold(result);
  result.outcome = outcome_of(result, ended);
  result.succeeded = is_usable(result.plant_status) && result.fault.kind == FaultKind::None &&
                     !result.interrupted && result.hold.has_value() && mpc.schedule().time() >= end;
  return result;
}

}  // namespace burnish::press_hold
