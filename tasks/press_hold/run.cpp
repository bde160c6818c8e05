#include <algorithm>
#include <cmath>

#include "base/sentence.hpp"
#include "burnish/sim/closed_loop.hpp"
#include "burnish/tasks/press_hold/press_hold.hpp"

namespace burnish::press_hold {
namespace {

/// First row of a phase or of a later one.
int first_row(const Trace& trace, int phase) {
  const Trace::Column phases = trace.column("phase");
  int row = 0;
  while (row < trace.rows() && phases[row] < phase) ++row;
  return row;
}

/// While the posture goes aside and stays there.
void measure_hold(RunResult& result) {
  const Trace& trace = result.trace;
  const Setting& setting = result.setting;
  const Model& model = setting.robot.model;
  const int begin = first_row(trace, 2), end = first_row(trace, 4);
  const Trace::Column time = trace.column("time");
  if (end - begin < 2 || !(time[end - 1] - time[begin] > 0.5)) return;
  MetricsSpec spec;
  spec.normal_world = setting.scene.surface.normal;
  spec.start = time[begin] + 0.2;
  spec.end = time[end - 1] - 0.02;
  result.metrics = measure(trace, model, spec);
  for (int k = 0; k < model.nq; ++k) {
    const Trace::Column q = trace.column("q_" + model.q_name(k));
    result.moved = std::max(result.moved, std::abs(q[end - 1] - q[begin]));
  }
  const int tool = trace.index("tool_x_world");
  for (int row = begin; row < end; ++row) {
    const Eigen::Vector3d p(trace.at(row, tool), trace.at(row, tool + 1), trace.at(row, tool + 2));
    const Eigen::Vector3d off = setting.surface_axes.transpose() * (p - setting.p_hold);
    result.slip = std::max(result.slip, off.head<2>().norm());
  }
}

std::string outcome_of(const RunResult& result, double now, bool stopped) {
  const std::string when = " at " + number(now) + " s";
  if (result.plant_status > Status::NotConverged)
    return "the plant failed" + when + ": " + std::string(describe(result.plant_status));
  if (result.fault.kind != FaultKind::None) return result.fault.text();
  if (stopped) return "interrupted" + when;
  if (!result.metrics) return "the point was not held to the end: the run ended" + when;
  char text[120];
  std::snprintf(text, sizeof text, "held: %.1f s, %.2f rad aside, %.2f N rms off, %.2f mm of slip",
                now, result.moved, result.metrics->force_rmse, 1e3 * result.slip);
  return text;
}

}  // namespace

RunResult run_task(const Task& task, PlantKind kind,
                   const std::function<bool(double time, double end)>& progress) {
  RunResult result;
  result.setting = make_setting(task);
  const Setting& setting = result.setting;
  const MpcSpec spec = make_mpc(task, setting);
  MpcController mpc(spec);
  const Disturbances disturbances{.mass_scale = task.mass_scale,
                                  .surface_height = task.surface_height,
                                  .surface_friction = task.friction};
  const auto plant =
      make_plant(kind, plant_model(setting.robot.model, disturbances),
                 plant_scene(setting.scene, disturbances), plant_step(spec.tick_period));
  constexpr double patience = 3.0;  // s that contact may be late
  const double end = setting.hold_end + task.retreat_duration;
  ClosedLoop loop(*plant, mpc, disturbances,
                  {.control_period = spec.tick_period, .max_duration = end + patience});
  result.plant_status = loop.reset(setting.q_start, Eigen::VectorXd::Zero(setting.robot.model.nv));
  bool stopped = false;
  // The schedule's clock stands still while contact is late.
  for (long step = 0; result.plant_status <= Status::NotConverged && !stopped &&
                      mpc.fault().kind == FaultKind::None && mpc.schedule().time() < end &&
                      plant->time() < end + patience;
       ++step) {
    result.plant_status = worst(result.plant_status, loop.step());
    stopped = progress && step % 100 == 0 && !progress(plant->time(), end);
  }
  result.fault = mpc.fault();
  result.trace = loop.trace();
  measure_hold(result);
  result.outcome = outcome_of(result, plant->time(), stopped);
  result.done = result.plant_status <= Status::NotConverged &&
                result.fault.kind == FaultKind::None && !stopped && result.metrics.has_value() &&
                mpc.schedule().time() >= end;
  return result;
}

}  // namespace burnish::press_hold
