#include "pressing/recorded_run.hpp"
#include "stand/descriptions.hpp"

namespace burnish::stand {

pressing::RecordedRun recorded(const pressing::NamedRun<RunSpec>& run, const RunResult& result) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  pressing::RecordedRun record = pressing::record_of("stand", run, result);
  record.surface = setting.ground;
  record.origin_world = setting.p_base;
  record.update_period = 1.0 / task.update_rate;
  record.figures =
      pressing::own_figures("sway", result.sway, [](const auto& see) { each_sway_figure(see); });
  record.more = {{"fell", result.fell}};
  record.phase_names = phase_names();
  return record;
}

}  // namespace burnish::stand
