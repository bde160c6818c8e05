#include <cmath>

#include "base/sentence.hpp"
#include "pressing/task_checks.hpp"
#include "pressing/task_form.hpp"
#include "push_wall/descriptions.hpp"
#include "push_wall/measured.hpp"

namespace burnish::push_wall {
namespace {

[[noreturn]] void refuse(const std::string& entry, const std::string& sentence) {
  throw EntryError(entry, sentence);
}

void check_forces(const Task& task) {
  if (task.touch_force > task.force)
    refuse("phases.touch_force", "it is " + number(task.touch_force) +
                                     " N, more than the force of " + number(task.force) +
                                     " N; wanted at most that");
  if (!std::isfinite(force_max(task)))
    refuse("lean.force_max",
           "it is never, as limits.force is; wanted a number in one of the two, where the search "
           "for the largest force ends at the latest");
  if (task.lean.force_max <= task.force)
    refuse("lean.force_max", "it is " + number(task.lean.force_max) + " N and the force " +
                                 number(task.force) + " N; wanted more than that");
  if (task.force_limit <= force_max(task) || force_max(task) <= task.force)
    refuse("limits.force", "it is " + number(task.force_limit) + " N and hands are to reach " +
                               number(std::max(task.force, force_max(task))) +
                               " N; wanted more than that, and where lean.force_max is never nine "
                               "tenths of it");
}

}  // namespace

double force_max(const Task& task) {
  constexpr double below = 0.9;
  return std::isfinite(task.lean.force_max) ? task.lean.force_max : below * task.force_limit;
}

Task read_task(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return parse_task(read_text(file, "YAML file"), file.string(), overrides);
}

Task parse_task(const std::string& text, const std::string& name,
                const std::vector<std::string>& overrides) {
  const files::Said<Task> said = files::parse_said<Task>(text, name, overrides);
  files::placed(said.texts, [&] { check_task(said.spec); });
  return said.spec;
}

void override_task(Task& task, const std::vector<std::string>& overrides) {
  files::Said<Task> said{.spec = task};
  files::change(said, overrides);
  task = said.spec;
}

std::string task_text(const Task& task) { return file_of(&task).text(&task); }

void check_task(const Task& task) {
  check_ranges(description_of(&task), &task,
               [](const std::string& entry) { return "the task: " + entry; });
  if (task.hands.size() != 2 || task.hands[0] == task.hands[1])
    refuse("hands", "there are " + std::to_string(task.hands.size()) +
                        (task.hands.size() == 2 ? " of one name" : "") +
                        "; wanted two frames that are not the same");
  if (!task.standing.force_sensors)
    refuse("standing.force_sensors",
           "it is false; wanted true: what hands and feet press with is to be measured");
  for (const auto& [entry, share] :
       {std::pair("lean.share", task.lean.share), {"standing.plan_sole", task.standing.plan_sole}})
    if (!(share > 0.0)) refuse(entry, "it is " + number(share) + "; wanted more than 0");
  check_forces(task);
  pressing::check_durations({{"phases.settle_duration", task.settle_duration},
                             {"phases.clearance", task.clearance / task.approach_speed},
                             {"phases.ramp_duration", task.ramp_duration},
                             {"phases.hold_duration", task.hold_duration},
                             {"lean.rate", (force_max(task) - task.force) / task.lean.rate},
                             {"lean.hold_duration", task.lean.hold_duration},
                             {"phases.release_duration", task.release_duration},
                             {"phases.retreat_duration", task.retreat_duration}});
  for (const auto& [entry, duration] : {std::pair("phases.hold_duration", task.hold_duration),
                                        {"lean.hold_duration", task.lean.hold_duration}})
    if (!(duration >= least_hold))
      refuse(entry, "it is " + number(duration) + " s; wanted at least " + number(least_hold) +
                        " s, over which the force is judged");
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
