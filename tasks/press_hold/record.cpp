#include "press_hold/record.hpp"

#include "base/sentence.hpp"
#include "press_hold/figures.hpp"

namespace burnish::press_hold {

pressing::RecordedRun recorded(const RunName& run, const RunResult& result) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  return {.task = "press_hold",
          .name = run.name,
          .command = run.command,
          .plant = run.spec.plant,
          .disturbances = task.disturbances,
          .robot_name = task.robot,
          .force = number(task.force) + " N",
          .task_file = task_text(task),
          .run = result,
          .done = result.done,
          .robot = setting.robot,
          .q_start = setting.q_start,
          .scene = setting.scene,
          .surface_axes = setting.surface_axes,
          .origin_world = setting.p_hold,
          .phase_names = phase_names(),
          .phase = 2,  // aside, of phase_names()
          .phase_title = "while it moves aside",
          .update_period = 1.0 / task.tick_rate,
          .deadline = task.limits.deadline,
          .metrics = result.metrics,
          .figures = pressing::own_figures("hold", result.hold,
                                           [](const auto& see) { each_hold_figure(see); }),
          .postures = {{"aside", setting.q_aside}}};
}

}  // namespace burnish::press_hold
