// The plants that a task runs on, by name.
#pragma once

#include <memory>
#include <string>

#include "burnish/sim/plant.hpp"

namespace burnish {

enum class PlantKind {
  Mujoco,  ///< an engine that shares no code with this library
  Ideal,   ///< the library's own contact dynamics, a rigid surface
};
std::string name_of(PlantKind kind);  ///< "mujoco" or "ideal"
/// Whether PlantKind::Mujoco is there in this build.
bool has_mujoco();
/// dt: s. Throws Error for a plant that is not there, and as checked_scene() does.
std::unique_ptr<Plant> make_plant(PlantKind kind, const Model& model, const SceneSpec& scene,
                                  double dt);
/// Largest step up to the plants' usual one that control periods are a multiple of, s.
double plant_step(double control_period);

}  // namespace burnish
