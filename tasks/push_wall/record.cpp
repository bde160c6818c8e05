#include "push_wall/record.hpp"

#include "base/sentence.hpp"
#include "push_wall/figures.hpp"
#include "push_wall/pushing.hpp"

namespace burnish::push_wall {

pressing::RecordedRun recorded(const RunName& run, const RunResult& result) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  return {.task = "push_wall",
          .name = run.name,
          .command = run.command,
          .plant = run.spec.plant,
          .disturbances = task.disturbances,
          .robot_name = task.robot,
          .force = number(task.force) + " N of each hand",
          .task_file = task_text(task),
          .run = result,
          .done = result.done,
          .robot = setting.robot,
          .q_start = setting.q_start,
          .scene = setting.scene,
          .surface_axes = setting.wall_axes,
          .origin_world = setting.p_hands.col(1),
          .phase_names = phase_names(),
          .phase = hold,
          .phase_title = "while it holds",
          .update_period = 1.0 / task.update_rate,
          .deadline = task.limits.deadline,
          .has_estimate = false,
          .figures = pressing::own_figures("push", result.push,
                                           [](const auto& see) { each_push_figure(see); }),
          .more = {{"limit", name_of(result.limit)}, {"limited_by", result.limited_by}}};
}

}  // namespace burnish::push_wall
