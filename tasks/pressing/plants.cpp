#include "burnish/tasks/pressing/plants.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/base/error.hpp"
#include "burnish/sim/ideal_plant.hpp"
#ifdef BURNISH_HAS_MUJOCO
#include "burnish/mujoco/mujoco_plant.hpp"
#endif

namespace burnish {

std::string name_of(PlantKind kind) { return kind == PlantKind::Mujoco ? "mujoco" : "ideal"; }

bool has_mujoco() {
#ifdef BURNISH_HAS_MUJOCO
  return true;
#else
  return false;
#endif
}

std::unique_ptr<Plant> make_plant(PlantKind kind, const Model& model, const SceneSpec& scene,
                                  double dt) {
  if (kind == PlantKind::Ideal) return make_ideal_plant(model, scene, {.dt = dt});
#ifdef BURNISH_HAS_MUJOCO
  return make_mujoco_plant(model, scene, {.dt = dt});
#else
  throw Error("this build has no MuJoCo; wanted the plant 'ideal', or a build with MuJoCo");
#endif
}

double plant_step(double control_period) {
  constexpr double max_step = 5e-4;  // largest integration step of a plant [s]
  return control_period / std::max(1.0, std::ceil(control_period / max_step - 1e-9));
}

}  // namespace burnish
