// The project's own contact dynamics as a plant: a rigid surface, exact torques. It separates the
// error of a controller from the error of its model, and needs no other program.
//
// Free motion and motion in contact: M a + b = tau + J^T lambda with one row along the surface's
// normal, integrated with Runge and Kutta's method of order four on the configuration's manifold
// (H. Munthe-Kaas, "High order Runge-Kutta methods on manifolds", 1999). Contact is made by a
// plastic impact at the moment when the tip reaches the surface, and broken when the surface would
// have to pull. Friction of joints and tip holds over a step, chosen so that the velocity at its
// end is one that Coulomb's law allows; the tip's law uses the normal force of the step before.
// Loops of the robot hold throughout, with the gains of the surface's gap against drift.
#pragma once

#include <memory>

#include "burnish/sim/plant.hpp"

namespace burnish {

/// How make_ideal_plant()'s plant steps.
/// @described sim
struct IdealPlantOptions {
  double dt = 5e-4;          ///< [s], > 0
  double tip_viscous = 0.0;  ///< {Ns/m}, against the contact point's sliding, besides Coulomb, >= 0
  double stabilize_kp = 1e4;  ///< [1/s^2], on the gap while in contact, and on loops, >= 0
  double stabilize_kd = 200;  ///< [1/s], on its rate, >= 0
};

/// Throws Error as checked_scene() does, and for options that are not finite, a dt that is not
/// positive and other options that are negative. Joint limits are not stops here. A reset with the
/// tip on the surface, or inside it by rounding, starts in contact.
std::unique_ptr<Plant> make_ideal_plant(const Model& model, const SceneSpec& scene,
                                        const IdealPlantOptions& options = {});

}  // namespace burnish
