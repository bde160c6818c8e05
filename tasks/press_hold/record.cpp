#include "base/sentence.hpp"
#include "press_hold/descriptions.hpp"
#include "pressing/recorded_run.hpp"

namespace burnish::press_hold {

pressing::RecordedRun recorded(const pressing::NamedRun<RunSpec>& run, const RunResult& result) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  pressing::RecordedRun record = pressing::record_of("press_hold", run, result);
  record.facts.insert(record.facts.begin() + 2, {"force", number(task.force) + " N"});
  record.surface = setting.scene.tool().surface;
  record.surface_axes = setting.surface_axes;
  record.origin_world = setting.p_hold;
  record.phase = 2;  // phase "aside", see phase_names()
  record.phase_title = "while it moves aside";
  record.update_period = 1.0 / task.tick_rate;
  record.metrics = result.metrics;
  record.figures =
      pressing::own_figures("hold", result.hold, [](const auto& see) { each_hold_figure(see); });
  record.postures = {{"aside", setting.q_aside}};
  record.phase_names = phase_names();
  return record;
}

}  // namespace burnish::press_hold
