// MuJoCo as a plant: an engine that shares no code with this library. Only where it was found when
// the library was built (target burnish::mujoco).
//
// Torques enter without delay. The contact is one of two.
//
// Exact, for every shape: a spring and damper of K and D, N/m and Ns/m, over how deep the tip is in
// the exact surface, and Coulomb friction, both solved for at the end of the step.
//
// Engine, MuJoCo's own, of planes, spheres, cylinders and ellipsoids that are not hollow: a spring
// and damper in series with an apparent mass. With d the impedance and A MuJoCo's inverse inertia
// of the tip, R = (1 - d)/d A and solref = (-K R d, -D R d) give K and D. Its elliptic friction
// cones lift a sliding tip by mu * damping * speed: contact is lost unless that is below the force.
#pragma once

#include <memory>

#include "burnish/sim/plant.hpp"

namespace burnish {

/// What the tip meets in make_mujoco_plant()'s plant.
/// @described sim
enum class MujocoContact {
  Exact,   ///< a spring, a damper and Coulomb friction on the exact surface
  Engine,  ///< MuJoCo's own contact, of shapes that it has
};

/// How make_mujoco_plant()'s plant steps.
/// @described sim
struct MujocoPlantOptions {
  MujocoContact contact = MujocoContact::Exact;  ///< exact or engine
  double dt = 5e-4;                              ///< [s], > 0
  double impedance = 0.1;  ///< d in (0, 1): 1/R is an apparent mass at the contact, between 0 and 1
  double friction_ratio = 10.0;  ///< how much harder friction is than the normal ("impratio"), > 0
  double tolerance = 1e-12;      ///< of the constraint solver, >= 0
  int max_iterations = 100;      ///< of the constraint solver, >= 1
  bool joint_stops = true;       ///< revolute and prismatic joints stop at their limits
};

/// Throws Error as checked_scene() does, for options out of range, and with MuJoCo's own words if
/// it refuses the model.
std::unique_ptr<Plant> make_mujoco_plant(const Model& model, const SceneSpec& scene,
                                         const MujocoPlantOptions& options = {});

}  // namespace burnish
