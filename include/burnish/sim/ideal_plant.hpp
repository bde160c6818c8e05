// Plant with burnish's own contact dynamics, a rigid surface and exact torques. If the controller's
// model equals the plant's model, the error of a run is the controller's own error.
//
// The acceleration a obeys M a + b = tau + J^T lambda, with mass matrix M, bias torques b and joint
// torques tau. lambda is the contact force along the surface's normal, and J its Jacobian. The
// motion is integrated by the fourth-order method of Runge and Kutta on the manifold of
// configurations (H. Munthe-Kaas, "High order Runge-Kutta methods on manifolds", 1999).
//
// Contact begins with a plastic impact when the tip reaches the surface. Contact ends when the
// normal force would become a pull.
//
// Friction forces at joints and tip are constant over a step. They are computed such that the
// velocity at the end of the step satisfies Coulomb's law. At the tip, friction is limited to mu
// times the normal force at the start of the step. This normal force is computed with the friction
// of the previous step.
//
// Kinematic loops of the robot are always closed. The gains that correct drift of the gap to the
// surface also correct drift of the loops.
#pragma once

#include <memory>

#include "burnish/sim/plant.hpp"

namespace burnish {

/// Time step, friction and drift correction of the ideal plant.
/// @described sim
struct IdealPlantOptions {
  /// Time step [s], > 0
  double dt = 5e-4;
  /// Viscous friction of the sliding tip [Ns/m], >= 0
  /// @more Viscous friction acts in addition to Coulomb friction
  double tip_viscous = 0.0;
  /// Gain of the drift correction on position errors [1/s^2], >= 0
  /// @more Position errors are the gap to the surface during contact, and the errors of kinematic
  /// loops
  double stabilize_kp = 1e4;
  /// Gain of the drift correction on velocity errors [1/s], >= 0
  /// @more Velocity errors are the velocity of the gap during contact, and the velocity errors of
  /// kinematic loops
  double stabilize_kd = 200;
};

/// Creates a plant with burnish's own contact dynamics. Joint limits do not stop the joints. If the
/// tip is on the surface at reset(), or inside it by a rounding error, the plant starts in contact.
///
/// The scene has at most one touch, which must be a tool. Throws Error if checked_scene() rejects
/// the scene, if the scene has a support or more than one touch, and if an option is out of range.
/// Also throws Error for a surface that moves, is curved or is carried by the robot.
std::unique_ptr<Plant> make_ideal_plant(const Model& model, const SceneSpec& scene,
                                        const IdealPlantOptions& options = {});

}  // namespace burnish
