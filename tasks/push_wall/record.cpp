#include "base/sentence.hpp"
#include "pressing/recorded_run.hpp"
#include "push_wall/descriptions.hpp"
#include "push_wall/pushing.hpp"

namespace burnish::push_wall {

pressing::RecordedRun recorded(const pressing::NamedRun<RunSpec>& run, const RunResult& result) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  pressing::RecordedRun record = pressing::record_of("push_wall", run, result);
  record.facts.insert(record.facts.begin() + 2, {"force", number(task.force) + " N of each hand"});
  record.surface = setting.scene.touches.back().surface;
  record.origin_world = setting.p_hands.col(1);
  record.update_period = 1.0 / task.update_rate;
  record.figures =
      pressing::own_figures("push", result.push, [](const auto& see) { each_push_figure(see); });
  record.more = {{"limit", name_of(result.limit)}, {"limited_by", result.limited_by}};
  record.phase_names = phase_names();
  return record;
}

}  // namespace burnish::push_wall
