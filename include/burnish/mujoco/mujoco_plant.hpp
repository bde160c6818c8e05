// MuJoCo as a plant: a simulator that shares no code with this library. The plant is available only
// if MuJoCo was found when the library was built (target burnish::mujoco). Torques act without
// delay.
//
// MuJoCo's own contact always computes the forces on supports, such as feet. The option `contact`
// selects how the forces on tools are computed.
//
// MujocoContact::Exact supports every shape. A spring K [N/m] and a damper D [Ns/m] act on the
// depth of the tool's tip below the exact surface. Coulomb friction acts along the surface. Normal
// force and friction force are computed implicitly, from the state at the end of the step.
//
// MujocoContact::Engine is MuJoCo's own contact. It supports planes, spheres, cylinders and
// ellipsoids, but no hollow shapes. The contact acts as a spring and a damper in series with an
// apparent mass. The stiffness K and the damping D are set by solref = (-K R d, -D R d). Here, d is
// the impedance, A is the inverse inertia of the tip in MuJoCo, and R = (1 - d) / d * A.
//
// MuJoCo's elliptic friction cones lift a sliding tip with the force mu * D * speed, where mu is
// the friction coefficient. Contact is lost if the lifting force exceeds the normal force.
#pragma once

#include <memory>

#include "burnish/sim/plant.hpp"

namespace burnish {

/// Contact model of tools in a MuJoCo plant.
/// @described sim
enum class MujocoContact {
  Exact,   ///< Spring, damper and Coulomb friction on the exact surface
  Engine,  ///< MuJoCo's own contact, for the shapes that it supports
};

/// Options of the plant that make_mujoco_plant() creates.
/// @described sim
struct MujocoPlantOptions {
  MujocoContact contact = MujocoContact::Exact;  ///< Contact model: exact or engine
  double dt = 5e-4;                              ///< Time step [s], > 0

  /// Impedance d of MuJoCo's own contact, between 0 and 1 @more The contact acts with an apparent
  /// mass of d / (1 - d) times the apparent mass of the tip.
  double impedance = 0.1;
  /// Ratio of frictional to normal impedance (MuJoCo's impratio), > 0
  double friction_ratio = 10.0;
  double tolerance = 1e-12;  ///< Tolerance of the constraint solver, >= 0
  int max_iterations = 100;  ///< Maximum number of iterations of the constraint solver, >= 1
  bool joint_stops = true;   ///< Whether revolute and prismatic joints stop at their limits
};

/// Creates a plant that simulates the robot and the scene with MuJoCo. Throws Error if
///  - checked_scene() rejects the scene, or the scene has more than 31 touches (tools and feet);
///  - `contact` is Engine and MuJoCo cannot simulate the surface of a tool;
///  - an option is out of range;
///  - a joint of the robot moves no mass;
///  - MuJoCo rejects the model; the Error then contains MuJoCo's message.
std::unique_ptr<Plant> make_mujoco_plant(const Model& model, const SceneSpec& scene,
                                         const MujocoPlantOptions& options = {});

}  // namespace burnish
