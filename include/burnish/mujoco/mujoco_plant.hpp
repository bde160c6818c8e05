// MuJoCo as a plant: an engine that shares no code with this library. Only where it was found when
// the library was built (target burnish::mujoco).
//
// The contact is a spring and damper in series with an apparent mass: with d the impedance and A
// MuJoCo's inverse inertia of the tip, R = (1 - d)/d A and solref = (-K R d, -D R d) give stiffness
// K and damping D in N/m and Ns/m. Elliptic friction cones; torques enter without delay.
#pragma once

#include <memory>

#include "burnish/sim/plant.hpp"

namespace burnish {

struct MujocoPlantOptions {
  double dt = 5e-4;              ///< s
  double impedance = 0.1;        ///< d in (0, 1): 1/R is an apparent mass at the contact
  double friction_ratio = 10.0;  ///< how much harder friction is than the normal ("impratio")
  double tolerance = 1e-12;      ///< of the constraint solver
  int max_iterations = 100;      ///< of the constraint solver
  bool joint_stops = true;       ///< revolute and prismatic joints stop at their limits
};

/// Throws Error as checked_scene() does, for options out of range, and with MuJoCo's own words if
/// it refuses the model.
std::unique_ptr<Plant> make_mujoco_plant(const Model& model, const SceneSpec& scene,
                                         const MujocoPlantOptions& options = {});

}  // namespace burnish
