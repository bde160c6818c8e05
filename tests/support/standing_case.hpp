// Shipped task of whole Talos on its feet, with a short path, in MuJoCo.
#pragma once

#include "burnish/tasks/polishing/task_file.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "support/mpc_run.hpp"

namespace burnish::test {

inline MpcCase standing_case(const std::vector<Push>& pushes = {}) {
  MpcCase result;
  result.task = polishing::read_task(std::string(BURNISH_TASKS_DIR) + "/polishing/standing.yaml");
  result.task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos";
  result.task.reach_duration = 0.2;
  result.task.standing.settle = 0.2;
  result.task.polish_duration = 1.0;
  result.task.path.start_up = 0.5;
  result.task.disturbances.pushes = pushes;
  result.make_plant = [](const Model& model, const SceneSpec& scene) {
    return make_plant(PlantKind::Mujoco, model, scene, 5e-4);
  };
  return result;
}

}  // namespace burnish::test
