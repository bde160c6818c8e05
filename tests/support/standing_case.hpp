// The shipped task of whole Talos on its feet, the path short, on MuJoCo.
#pragma once

#include "burnish/tasks/polishing/task_file.hpp"
#include "burnish/tasks/pressing/plants.hpp"
#include "support/mpc_run.hpp"

namespace burnish::test {

inline MpcCase standing_case(const std::vector<Push>& pushes = {}) {
  MpcCase wanted;
  wanted.task = polishing::read_task(std::string(BURNISH_TASKS_DIR) + "/polishing/standing.yaml");
  wanted.task.robot = std::string(BURNISH_ROBOTS_DIR) + "/talos";
  wanted.task.reach_duration = 0.2;
  wanted.task.standing.settle = 0.2;
  wanted.task.polish_duration = 1.0;
  wanted.task.path.start_up = 0.5;
  wanted.task.disturbances.pushes = pushes;
  wanted.make_plant = [](const Model& model, const SceneSpec& scene) {
    return make_plant(PlantKind::Mujoco, model, scene, 5e-4);
  };
  return wanted;
}

}  // namespace burnish::test
