#include "base/sentence.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"
#include "stand/descriptions.hpp"

namespace burnish::stand {

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Stand on feet, sway with the trunk and come back to rest: `burnish run`.\nSI units, "
        "angles in rad. A key that is left out has its default.",
        "stand");
    pressing::read_presets<Task>(form);
    const std::string nothing = "the task has no surface to press on";
    form.without("disturbances",
                 {"surface_tilt_deg", "surface_height", "surface_curvature", "surface_shape",
                  "surface_motion", "surface_friction"},
                 nothing)
        .without("model_error", {"sliding_bandwidth", "force_gain"}, nothing)
        .without("constraints", {"force_band"}, nothing)
        .without("constraints", {"joint_torque_rate"},
                 "plans of this task do not model the lag of torques");
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
  if (!task.standing.stands())
    throw EntryError("standing.feet",
                     "no feet are stated; wanted the frames that the robot stands on");
  pressing::check_durations({{"phases.settle_duration", task.settle_duration},
                             {"phases.sway_duration", task.sway_duration},
                             {"phases.rest_duration", task.rest_duration}});
  if (2.0 * task.sway.rise > task.sway_duration)
    throw EntryError("sway.rise",
                     "it is " + number(task.sway.rise) + " s and phases.sway_duration is " +
                         number(task.sway_duration) +
                         " s, which must contain one rise and one fall; wanted at most " +
                         number(0.5 * task.sway_duration) + " s");
  pressing::check_plan_times(pressing::plan_times_of(task));
  pressing::check_contact_step(task.step, "standing.contact_kd", task.standing.contact_kd);
}

std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant) {
  std::vector<std::string> notes;
  if (!ideal_is_meant) pressing::note_ideal_world(task.disturbances, notes);
  pressing::note_delays({task.command_delay, task.measurement_delay}, task.disturbances, notes);
  return notes;
}

}  // namespace burnish::stand
