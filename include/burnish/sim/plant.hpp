// The plant: what a controller drives. It knows nothing of controllers; all that reaches it is a
// torque per joint, and all that leaves it is a state and a force.
#pragma once

#include <Eigen/Core>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/model/model.hpp"
#include "burnish/sim/scene.hpp"

namespace burnish {

/// A moment of a plant, to go back to. What it holds belongs to the kind of plant that saved it.
/// @described sim
struct PlantSnapshot {
  Eigen::VectorXd numbers;
};

/// A robot and a surface, advanced by a fixed step. reset() and step() allocate nothing and throw
/// nothing; a status above NotConverged means that the state is as it was before the call.
///
/// The plant's model carries its own joint friction: `damping` (viscous) and `friction` (Coulomb)
/// of the model act on the joints, and so do its springs and tendons.
class Plant {
 public:
  virtual ~Plant() = default;

  virtual const Model& model() const = 0;
  virtual const SceneSpec& scene() const = 0;  ///< normal of length one
  virtual double dt() const = 0;               ///< s

  /// Starts at the configuration q (nq) with the velocity v (nv), at time zero, without force.
  /// WrongSize, NotFinite or NotNormalized for a state that is none.
  [[nodiscard]] virtual Status reset(const ConstVectorRef& q, const ConstVectorRef& v) noexcept = 0;

  /// Advances by dt() with the torques tau (nv: Nm, N; entries of a floating base act as a wrench
  /// in its body axes) and a force on the tip (N, world axes, at the tip frame's origin), both held
  /// over the step. WrongSize or NotFinite for torques that are none, and NotFinite if the motion
  /// they cause is.
  [[nodiscard]] virtual Status step(const ConstVectorRef& tau,
                                    const Eigen::Vector3d& push_world) noexcept = 0;

  virtual double time() const = 0;               ///< s since reset()
  virtual const Eigen::VectorXd& q() const = 0;  ///< nq
  virtual const Eigen::VectorXd& v() const = 0;  ///< nv

  /// Force of the surface on the tip during the last step, N, world axes. Along the surface's
  /// normal it is never negative.
  virtual const Eigen::Vector3d& contact_force_world() const = 0;
  /// Whether the surface pushed during the last step.
  virtual bool in_contact() const = 0;
  /// Torque that joints felt without their motors during the last step, nv, Nm or N: of friction,
  /// against the motion, and of springs and tendons at its start.
  virtual const Eigen::VectorXd& friction_torque() const = 0;

  /// Of each of the scene's supports, during the last step: force (N) and moment (Nm) of its plane
  /// on it, at the origin of its frame, in the frame's axes. 6 x supports.
  virtual const Eigen::Matrix<double, 6, Eigen::Dynamic>& support_wrenches() const {
    return no_supports_;
  }

  /// Copies everything the future depends on, and the readings. Allocates on first use.
  virtual void save(PlantSnapshot& snapshot) const = 0;
  /// Goes back: the same torques then give the same bits. WrongSize for another plant's snapshot.
  [[nodiscard]] virtual Status restore(const PlantSnapshot& snapshot) noexcept = 0;

 protected:
  Plant() = default;
  Plant(const Plant&) = default;
  Plant& operator=(const Plant&) = default;

 private:
  Eigen::Matrix<double, 6, Eigen::Dynamic> no_supports_;
};

}  // namespace burnish
