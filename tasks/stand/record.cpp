#include "stand/record.hpp"

#include "stand/figures.hpp"
#include "stand/swaying.hpp"

namespace burnish::stand {

pressing::RecordedRun recorded(const RunName& run, const RunResult& result) {
  const Task& task = run.spec.task;
  const Setting& setting = result.setting;
  pressing::RecordedRun record = pressing::record_of("stand", run, result);
  record.surface_axes = setting.heading;
  record.origin_world = setting.p_base;
  record.phase = sway;
  record.phase_title = "while it sways";
  record.update_period = 1.0 / task.update_rate;
  record.has_estimate = false;
  record.figures =
      pressing::own_figures("sway", result.sway, [](const auto& see) { each_sway_figure(see); });
  record.more = {{"fell", result.fell}};
  record.phase_names = phase_names();
  return record;
}

}  // namespace burnish::stand
