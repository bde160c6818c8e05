#include <cmath>

#include "base/sentence.hpp"
#include "press_hold/descriptions.hpp"
#include "press_hold/measured.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"

namespace burnish::press_hold {

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Press at a point and hold the force while the rest of the arm moves aside: `burnish "
        "run`.\nSI units, angles in rad. A key that is left out has its default.",
        "press_hold");
    pressing::read_presets<Task>(form, "surface.friction");
    const std::string fixed = "the robot's base is fixed";
    form.without("disturbances", pressing::disturbances_of_standing(), fixed)
        .without("limits", {"base_lost", "support_slip"}, fixed)
        .without("constraints", {"joint_torque_rate"},
                 "plans of this task do not model the lag of torques");
    form.first("limits", {"force", "slip"});
    return form;
  }();
  return all;
}

Task read_task(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return pressing::read_task_file<Task>(file, overrides);
}

Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides) {
  return pressing::parse_task_text<Task>(text, name, overrides);
}

void override_task(Task& task, const std::vector<std::string>& overrides) {
  pressing::change_task(task, overrides);
}

std::string task_text(const Task& task) { return file_of(&task).text(&task); }

void check_task(const Task& task) {
  check_ranges(description_of(&task), &task,
               [](const std::string& entry) { return "the task: " + entry; });
  if (task.touch_force > task.force)
    throw EntryError("phases.touch_force", "it is " + number(task.touch_force) +
                                               " N, more than the force of " + number(task.force) +
                                               " N; wanted at most " + number(task.force) + " N");
  if (task.tool_limits.force <= task.force)
    throw EntryError("force", "it is " + number(task.force) +
                                  " N; wanted less than limits.force, " +
                                  number(task.tool_limits.force) + " N");
  constexpr double max_duration = 1e4;  // longest duration [s]
  for (const auto& [key, time] : {std::pair("ramp_duration", task.ramp_duration),
                                  std::pair("aside_duration", task.aside_duration),
                                  std::pair("hold_duration", task.hold_duration),
                                  std::pair("retreat_duration", task.retreat_duration),
                                  std::pair("clearance", task.clearance / task.approach_speed)})
    if (!(time <= max_duration))
      throw EntryError(
          std::string("phases.") + key,
          "it takes " + number(time) + " s; wanted at most " + number(max_duration) + " s");
  const double measured = task.aside_duration + task.hold_duration;
  if (!(measured >= min_measured))
    throw EntryError("phases.hold_duration",
                     "it is " + number(task.hold_duration) + " s, and " + number(measured) +
                         " s together with phases.aside_duration; wanted at least " +
                         number(min_measured) + " s together, to measure the force");
}

std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant) {
  std::vector<std::string> notes;
  if (!ideal_is_meant) pressing::note_ideal_world(task.disturbances, notes);
  pressing::note_delays({task.command_delay, task.measurement_delay}, task.disturbances, notes);
  pressing::note_friction("surface.friction", task.friction, Task{}.friction, task.disturbances,
                          notes);
  return notes;
}

}  // namespace burnish::press_hold
