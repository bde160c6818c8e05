#include "polishing/experiments/experiment.hpp"

#include <algorithm>

#include "base/sentence.hpp"
#include "burnish/tasks/polishing/task_file.hpp"

namespace burnish::polishing {

// Each of these functions is defined in the file named after its experiment.
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
       "MPC, baseline and admittance on table and board, with three presets of disturbances",
       perform_paper},
      {"orientation", "one task on surfaces of all orientations", perform_orientation},
      {"frames",
       "contact and force in axes of the tool or of the surface, with several rotation weights",
       perform_frames},
      {"seeds", "all disturbances at once, drawn at random for each of many seeds", perform_seeds},
      {"tilt", "tilted surfaces at high speed with friction, with and without a torque loop",
       perform_tilt},
      {"surfaces", "curved, inaccurate, soft and stiff surfaces; without a force sensor",
       perform_surfaces},
      {"robots", "the default task with other robots, scaled from 3 to 30 kg, or public robots",
       perform_robots},
      {"force_test", "tests of force control: steps, sines, impacts, pushes, edges, motion",
       perform_force_test},
      {"standing", "a standing robot: all presets of disturbances over many seeds, and pushes",
       perform_standing},
      {"tick", "computing times at several numbers of plans per second", perform_tick}};
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
  throw Error("unknown experiment " + in_quotes(name) + "; wanted one of " + list +
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
