#include "polishing/experiments/experiment.hpp"

#include <algorithm>

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/task_file.hpp"

namespace burnish::polishing {

// Each in a file of its name.
ExperimentReport perform_paper(const ExperimentSpec& spec);
ExperimentReport perform_orientation(const ExperimentSpec& spec);
ExperimentReport perform_frames(const ExperimentSpec& spec);
ExperimentReport perform_seeds(const ExperimentSpec& spec);
ExperimentReport perform_tilt(const ExperimentSpec& spec);
ExperimentReport perform_surfaces(const ExperimentSpec& spec);
ExperimentReport perform_robots(const ExperimentSpec& spec);
ExperimentReport perform_force_test(const ExperimentSpec& spec);
ExperimentReport perform_standing(const ExperimentSpec& spec);
ExperimentReport perform_tick(const ExperimentSpec& spec);

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all{
      {"paper",
       "MPC, baseline and admittance on table and board, three kinds of disturbances, beside the "
       "aims",
       perform_paper},
      {"orientation", "surfaces from horizontal to vertical and around; only the surface changes",
       perform_orientation},
      {"frames", "contact and force in the tool's axes or the surface's, as the wrist gets freer",
       perform_frames},
      {"seeds", "every disturbance at once, drawn anew for each of many seeds", perform_seeds},
      {"tilt", "surfaces that lean, fast and with friction, with a torque loop and without",
       perform_tilt},
      {"surfaces", "bent surfaces, known and not; soft and stiff ones; without a force sensor",
       perform_surfaces},
      {"robots", "the shipped task with other robots, and one of them from 3 to 30 kg; public ones",
       perform_robots},
      {"force_test", "how well a force is controlled: steps, sines, impacts, pushes, edges, motion",
       perform_force_test},
      {"standing", "a robot on its feet: every preset of disturbances over many seeds, and pushes",
       perform_standing},
      {"tick", "computing times at several rates of new plans", perform_tick}};
  return all;
}

const Experiment& experiment_named(const std::string& name) {
  std::vector<std::string> names;
  std::string list;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    list += (names.empty() ? "" : ", ") + experiment.name;
    names.push_back(experiment.name);
  }
  throw Error("experiment " + in_quotes(name) + " is not known; wanted one of " + list +
              did_you_mean(name, names));
}

Task experiment_task(const ExperimentSpec& spec, const std::string& surface,
                     const std::string& disturbances, double duration) {
  Task task;
  put_on(task, surface);
  task.disturbances = disturbance_preset(disturbances);
  task.polish_duration = duration;
  if (spec.quick) {
    task.polish_duration = std::min(duration, 0.8);
    task.path.start_up = 0.4;
    task.path.radius = 0.02;
    task.reach_duration = 0.2;
    task.update_rate = 200.0;
  }
  override_task(task, spec.overrides);
  return task;
}

int seeds_of(const ExperimentSpec& spec, int own) {
  if (spec.seeds > max_seeds)
    throw Error("the experiment has " + std::to_string(spec.seeds) + " seeds; wanted at most " +
                std::to_string(max_seeds));
  return spec.seeds > 0 ? spec.seeds : own;
}

Task check_experiment_task(const ExperimentSpec& spec, const std::string& surface) {
  Task task = experiment_task(spec, surface, "mismatch", 1.0);
  check_task(task);
  return task;
}

}  // namespace burnish::polishing
