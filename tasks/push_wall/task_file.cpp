#include <cmath>

#include "base/sentence.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"
#include "push_wall/descriptions.hpp"
#include "push_wall/measured.hpp"

namespace burnish::push_wall {
namespace {

/// Largest force of the search, as a fraction of limits.force, if the entry force_search.force_max
/// is `never`.
constexpr double search_fraction = 0.9;

[[noreturn]] void refuse(const std::string& entry, const std::string& sentence) {
  throw EntryError(entry, sentence);
}

void check_forces(const Task& task) {
  if (task.touch_force > task.force)
    refuse("phases.touch_force", "it is " + number(task.touch_force) +
                                     " N, more than the force of " + number(task.force) +
                                     " N; wanted at most " + number(task.force) + " N");
  if (!std::isfinite(force_max(task)))
    refuse(
        "force_search.force_max",
        "force_max and limits.force are both never; wanted a number for one of these keys, because "
        "the search for the largest force needs an upper limit");
  if (task.force_search.force_max <= task.force)
    refuse("force_search.force_max", "it is " + number(task.force_search.force_max) +
                                         " N; wanted more than the force of " + number(task.force) +
                                         " N");
  if (task.force_limit <= force_max(task) || force_max(task) <= task.force)
    refuse("limits.force",
           "the limit is " + number(task.force_limit) +
               " N, but the target of each hand rises to " +
               number(std::max(task.force, force_max(task))) + " N; wanted a limit above " +
               (std::isfinite(task.force_search.force_max)
                    ? number(force_max(task)) + " N"
                    : number(task.force / search_fraction) +
                          " N, because the search ends at nine tenths of the limit"));
}

}  // namespace

double force_max(const Task& task) {
  return std::isfinite(task.force_search.force_max) ? task.force_search.force_max
                                                    : search_fraction * task.force_limit;
}

const files::DescribedFile& file_of(const Task* /*of*/) {
  static const files::DescribedFile all = [] {
    files::DescribedFile form(
        description_of(static_cast<const Task*>(nullptr)),
        "Push with both hands against a wall, and search for the largest force: `burnish run`.\nSI "
        "units, angles in rad. A key that is left out has its default.",
        "push_wall");
    pressing::read_presets<Task>(form, "wall.friction");
    form.without("disturbances", {"surface_curvature", "surface_shape", "surface_motion"},
                 "the wall is plane and fixed")
        .without("model_error", {"sliding_bandwidth"}, "the forces of the hands are measured")
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
  if (task.hands.size() != 2 || task.hands[0] == task.hands[1])
    refuse("hands", (task.hands.size() == 2 ? "both hands are " + in_quotes(task.hands[0])
                                            : "the list has " + std::to_string(task.hands.size()) +
                                                  (task.hands.size() == 1 ? " frame" : " frames")) +
                        "; wanted two different frames, one for each hand");
  if (!task.standing.force_sensors)
    refuse("standing.force_sensors",
           "it is false; wanted true, because the task measures the forces of hands and feet");
  for (const auto& [entry, fraction] :
       {std::pair("force_search.hold_fraction", task.force_search.hold_fraction),
        {"standing.plan_sole", task.standing.plan_sole}})
    if (!(fraction > 0.0)) refuse(entry, "it is " + number(fraction) + "; wanted more than 0");
  check_forces(task);
  pressing::check_durations(
      {{"phases.settle_duration", task.settle_duration},
       {"phases.clearance", task.clearance / task.approach_speed},
       {"phases.ramp_duration", task.ramp_duration},
       {"phases.hold_duration", task.hold_duration},
       {"force_search.rate", (force_max(task) - task.force) / task.force_search.rate},
       {"force_search.hold_duration", task.force_search.hold_duration},
       {"phases.release_duration", task.release_duration},
       {"phases.retreat_duration", task.retreat_duration}});
  for (const auto& [entry, duration] :
       {std::pair("phases.hold_duration", task.hold_duration),
        {"force_search.hold_duration", task.force_search.hold_duration}})
    if (!(duration >= min_hold))
      refuse(entry, "it is " + number(duration) + " s; wanted at least " + number(min_hold) +
                        " s to measure the force");
  pressing::check_plan_times(pressing::plan_times_of(task));
  pressing::check_contact_step(task.step, "wall.contact_kd", task.wall.contact_kd);
  pressing::check_contact_step(task.step, "standing.contact_kd", task.standing.contact_kd);
}

std::vector<std::string> task_notes(const Task& task, bool ideal_is_meant) {
  std::vector<std::string> notes;
  if (!ideal_is_meant) pressing::note_ideal_world(task.disturbances, notes);
  pressing::note_delays({task.command_delay, task.measurement_delay}, task.disturbances, notes);
  pressing::note_friction("wall.friction", task.wall.friction, Wall{}.friction, task.disturbances,
                          notes);
  return notes;
}

}  // namespace burnish::push_wall
