// Interface of simulated plants. The input is joint torques; the output is the robot's state and
// the contact wrenches. A plant does not depend on controllers.
#pragma once

#include <Eigen/Core>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// Saved state of a plant, from which the plant can continue later. The meaning of the numbers
/// depends on the kind of plant.
/// @described sim
struct PlantSnapshot {
  Eigen::VectorXd numbers;
};

/// A robot and its scene, simulated with a fixed time step. reset() and step() allocate nothing and
/// throw nothing. If reset() or step() returns a status more severe than NotConverged, the call has
/// failed and the state is unchanged.
///
/// The plant simulates the joint friction, springs and tendons of model(). In this model, `damping`
/// is viscous joint friction and `friction` is Coulomb joint friction.
class Plant {
 public:
  virtual ~Plant() = default;

  virtual const Model& model() const = 0;
  virtual const SceneSpec& scene() const = 0;  ///< Scene, with normals of length one
  virtual double dt() const = 0;               ///< Time step [s]

  /// Sets the state to configuration q (nq) and velocity v (nv), at time zero and without contact
  /// force. Returns WrongSize, NotFinite or NotNormalized if (q, v) is not a valid state.
  [[nodiscard]] virtual Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept = 0;

  /// Advances by dt(), with constant torques. `tau` (nv entries) are the torques [Nm or N]; the
  /// entries of a floating base are a wrench in the base's axes. Returns WrongSize or NotFinite for
  /// an invalid `tau`, and NotFinite if the resulting motion is not finite.
  [[nodiscard]] virtual Status step(const ConstVectorRef& tau) noexcept = 0;

  virtual double time() const = 0;               ///< Time since reset() [s]
  virtual const Eigen::VectorXd& q() const = 0;  ///< Configuration, nq entries
  virtual const Eigen::VectorXd& v() const = 0;  ///< Velocity, nv entries

  /// Returns the wrenches on the touches of the scene during the last step, 6 x touches. Each
  /// column is the force [N] and the moment [Nm] that the surface exerts on the robot. Moments are
  /// about the origin of the touch's frame. Axes are those of this frame at the start of the step.
  /// Without contact, the column is zero.
  virtual const Wrenches& wrenches() const = 0;
  /// Returns the sum of friction, spring and tendon torques in the joints during the last step, nv
  /// entries [Nm or N]. Friction torques oppose the motion. Spring and tendon torques are computed
  /// at the start of the step.
  virtual const Eigen::VectorXd& friction_torque() const = 0;

  /// Saves the state in `snapshot`: all data on which future steps depend, and the forces of the
  /// last step. Allocates on first use.
  virtual void save(PlantSnapshot& snapshot) const = 0;
  /// Restores a saved state. From a restored state, equal torques give bitwise equal motion.
  /// Returns WrongSize for a snapshot of another plant.
  [[nodiscard]] virtual Status restore(const PlantSnapshot& snapshot) noexcept = 0;

 protected:
  Plant() = default;
  Plant(const Plant&) = default;
  Plant& operator=(const Plant&) = default;
};

}  // namespace burnish
