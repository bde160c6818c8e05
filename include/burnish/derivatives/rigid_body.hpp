// The door to what a robot's state alone says, without torques and contacts: frames, centre of
// mass, momentum, energy, gravity and friction torques, with their derivatives. One state at a
// time, Eigen in, Eigen out, nothing allocated after construction.
//
// What relates torques and accelerations (mass matrix, bias, forward and inverse dynamics) is in
// contact_dynamics.hpp: ContactDynamics without contacts is the free robot.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <string_view>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/dynamics/reference.hpp"
#include "burnish/model/inertia.hpp"
#include "burnish/model/model.hpp"

namespace burnish {

/// Derivatives of a frame's motion, (6, nv) each, linear rows first, in the axes that were asked
/// for.
/// @described derivatives @result
struct FrameDerivatives {
  RowMatrix jacobian;         ///< d(velocity)/dv, and d(acceleration)/da
  RowMatrix velocity_dq;      ///< d(velocity)/dq
  RowMatrix acceleration_dq;  ///< d(acceleration)/dq, v and a held
  RowMatrix acceleration_dv;  ///< d(acceleration)/dv, q and a held
};

/// Derivatives of a frame's placement, nv columns each.
/// @described derivatives @result
struct PlacementDerivatives {
  RowMatrix position;         ///< 3 x nv, world axes, m/rad (m/m)
  RowMatrix rotation;         ///< 3 x nv, R^T dR/dq_k = [column k x], the frame's own axes
  RowMatrix rotation_error;   ///< 3 x nv, of log(R_target^T R)
  RowMatrix placement_error;  ///< 6 x nv, of the SE(3) logarithm of the frame in the target
};

/// Conventions: linear part of motions and momenta first; d/dq is with respect to the right
/// increment q (+) dq of nv entries; views stay valid while the object lives and hold the result of
/// the last call that fills them.
///
/// A state that update() refuses changes nothing: all results stay those of the state before it, at
/// first the neutral configuration at rest. Functions that take a `FrameDerivatives` or
/// `PlacementDerivatives` resize it on first use.
class RigidBody {
 public:
  /// `slip_velocity` is the rate at which smoothed Coulomb friction reaches 76 %, rad/s or m/s: see
  /// dynamics/passive.hpp. Throws Error unless it is positive.
  explicit RigidBody(const Model& model, double slip_velocity = 0.01);
  ~RigidBody();
  RigidBody(RigidBody&&) noexcept;
  RigidBody& operator=(RigidBody&&) noexcept;

  int nq() const;
  int nv() const;
  /// Number of a frame of the model, for the functions below; "world" is always known. Throws Error
  /// with the nearest known name.
  int frame(const std::string& name) const;

  /// What the robot carries at a frame (any of the model's) from now on, in the frame's axes, in
  /// the place of what that frame's body carried before; results of the last accepted state are
  /// made anew, derivatives by update_derivatives(). Allocates nothing. Returns Ok, or NotFinite or
  /// NotPhysical as check_inertia() does, which changes nothing. Throws Error with the nearest
  /// known name for a frame that there is not, and for one that is fixed to the world.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);

  /// Evaluates the state: q has nq entries, v and a nv (rad/s, m/s; rad/s^2, m/s^2). Without `a`
  /// the joint accelerations are zero. Returns WrongSize, NotFinite, NotNormalized or Ok; throws
  /// nothing.
  [[nodiscard]] Status update(const ConstVectorRef& q, const ConstVectorRef& v);
  [[nodiscard]] Status update(const ConstVectorRef& q, const ConstVectorRef& v,
                              const ConstVectorRef& a);

  /// Of a frame in the world. `frame` is a number from frame().
  Eigen::Isometry3d placement(int frame) const;
  /// Motion of a frame in the world, written in a reference whose tool is the frame and whose base
  /// is the world: Reference::local(), centered(), world(), or in the axes of any frame. Throws
  /// Error with the nearest known name where that names no frame of the robot.
  Vector6 velocity(int frame, const Reference& reference) const;  ///< m/s, rad/s
  Vector6 acceleration(int frame,
                       const Reference& reference) const;  ///< d(velocity)/dt: m/s^2, rad/s^2
  void frame_derivatives(int frame, const Reference& reference, FrameDerivatives& out) const;
  /// SE(3) logarithm of the frame in the target: m, rad, target axes.
  Vector6 placement_error(int frame, const Eigen::Isometry3d& target) const;
  void placement_derivatives(int frame, const Eigen::Isometry3d& target,
                             PlacementDerivatives& out) const;

  double mass() const;                   ///< of all moving bodies, kg
  Eigen::Vector3d com() const;           ///< centre of mass, world, m
  Eigen::Vector3d com_velocity() const;  ///< m/s
  Vector6 momentum() const;              ///< about the world's origin: kg m/s, kg m^2/s
  Vector6 centroidal_momentum() const;   ///< about the centre of mass, world axes
  double kinetic_energy() const;         ///< v^T M v / 2, armature included, J
  double potential_energy() const;       ///< of gravity, zero at the world's origin, J
  VectorView gravity_torque() const;     ///< nv, holds the robot at rest: b(q, 0), Nm (N)
  /// Springs and tendons at q, damping and smoothed friction at v: nv, Nm (N).
  VectorView passive_torque() const;
  double spring_energy() const;  ///< in springs of joints and tendons, J

  /// Fills the views below, at the last accepted state. They stay what they are when update() or
  /// set_payload() changes it, until this is called again; Python refuses them.
  void update_derivatives();
  MatrixView com_dq() const;                  ///< 3 x nv; d(com_velocity)/dv too
  MatrixView com_velocity_dq() const;         ///< 3 x nv
  MatrixView momentum_dq() const;             ///< 6 x nv
  MatrixView momentum_dv() const;             ///< 6 x nv
  MatrixView centroidal_momentum_dq() const;  ///< 6 x nv
  MatrixView centroidal_momentum_dv() const;  ///< 6 x nv, the centroidal momentum matrix
  VectorView kinetic_energy_dq() const;       ///< nv
  VectorView kinetic_energy_dv() const;       ///< nv, M v
  VectorView potential_energy_dq() const;     ///< nv, the gravity torque
  MatrixView passive_torque_dq() const;       ///< nv x nv
  MatrixView passive_torque_dv() const;       ///< nv x nv, diagonal unless tendons have dampers

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
