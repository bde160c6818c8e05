// Quantities that depend on a robot's state alone, without torques and contacts: frames, centre of
// mass, momentum, energy, gravity and passive torques, with derivatives. One state is evaluated at
// a time, with Eigen types. Evaluations allocate nothing after construction.
//
// Relations between torques and accelerations (mass matrix, bias, forward and inverse dynamics) are
// in contact_dynamics.hpp. For a free robot, use ContactDynamics without contacts.
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

struct KinematicState;

/// Derivatives of a frame's velocity and acceleration, in the axes of the requested reference. Each
/// matrix is 6 x nv, with the linear rows first.
/// @described derivatives @result
struct FrameDerivatives {
  RowMatrix jacobian;         ///< d(velocity)/dv, which equals d(acceleration)/da
  RowMatrix velocity_dq;      ///< d(velocity)/dq
  RowMatrix acceleration_dq;  ///< d(acceleration)/dq at constant v and a
  RowMatrix acceleration_dv;  ///< d(acceleration)/dv at constant q and a
};

/// Derivatives of a frame's placement with respect to q. Each matrix has nv columns.
/// @described derivatives @result
struct PlacementDerivatives {
  RowMatrix position;  ///< Derivative of the position in world axes: 3 x nv, m/rad or m/m

  /// Derivative of the rotation R, in the frame's own axes: 3 x nv @more Column k is the vector w
  /// with R^T dR/dq_k = [w x].
  RowMatrix rotation;
  RowMatrix rotation_error;  ///< Derivative of log(R_target^T R), with the target R_target: 3 x nv

  /// Derivative of the pose error relative to a target: 6 x nv @more The pose error is the SE(3)
  /// logarithm of the frame's placement relative to the target.
  RowMatrix placement_error;
};

/// Quantities of a robot at one state, such as frame motions, momentum and energy, and their
/// derivatives.
///
/// Conventions: motions and momenta have the linear part first. d/dq is the derivative with respect
/// to a right increment dq with nv entries: q (+) dq. Views are valid while the object exists and
/// show the result of the last call that filled them.
///
/// A state that update() rejects changes no result. Before the first accepted state, all results
/// are those of the neutral configuration at rest. Functions that fill a FrameDerivatives or
/// PlacementDerivatives resize it on first use.
class RigidBody {
 public:
  /// Prepares computations for `model`. Smoothed Coulomb friction of a joint reaches 76 % of its
  /// full value at the joint velocity `slip_velocity` [rad/s or m/s]; see src/dynamics/passive.hpp.
  /// Throws Error unless `slip_velocity` is positive.
  explicit RigidBody(const Model& model, double slip_velocity = 0.01);
  ~RigidBody();
  RigidBody(RigidBody&&) noexcept;
  RigidBody& operator=(RigidBody&&) noexcept;

  int nq() const;
  int nv() const;
  /// Returns the index of a frame of the model, for the argument `frame` of other functions. The
  /// name "world" always exists. For an unknown name, throws Error with the nearest known name.
  int frame(const std::string& name) const;

  /// Sets the payload that the robot carries at a frame of the model. `payload` is written in the
  /// axes of the frame and replaces any earlier payload of the same body. Results are recomputed at
  /// the last accepted state. Derivatives are not recomputed; call update_derivatives(). Allocates
  /// nothing.
  ///
  /// Returns Ok. If check_inertia() returns NotFinite or NotPhysical for `payload`, returns this
  /// status and changes nothing. Throws Error if the frame is fixed to the world. For an unknown
  /// frame, throws Error with the nearest known name.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);

  /// Evaluates a state: `q` with nq entries, `v` [rad/s, m/s] and `a` [rad/s^2, m/s^2] with nv
  /// entries. Without `a`, the joint accelerations are zero. Returns Ok, WrongSize, NotFinite or
  /// NotNormalized; throws nothing.
  [[nodiscard]] Status update(const ConstVectorRef& q, const ConstVectorRef& v);
  [[nodiscard]] Status update(const ConstVectorRef& q, const ConstVectorRef& v,
                              const ConstVectorRef& a);

  /// Returns the placement of a frame in the world. `frame` is an index from frame().
  Eigen::Isometry3d placement(int frame) const;
  /// Returns the velocity of a frame relative to the world [m/s, rad/s], linear part first, written
  /// in `reference`. The tool of `reference` is this frame, and its base is the world. Allowed are
  /// Reference::local(), centered(), world(), and references with the axes of any frame. Throws
  /// Error with the nearest known name if `reference` names a frame that the robot does not have.
  Vector6 velocity(int frame, const Reference& reference) const;
  /// Returns the time derivative of velocity() [m/s^2, rad/s^2].
  Vector6 acceleration(int frame, const Reference& reference) const;
  /// Computes d(velocity)/dv of a frame, 6 x nv, linear rows first, written in `reference`. `out`
  /// is resized on first use. Throws Error in the same cases as velocity().
  void frame_jacobian(int frame, const Reference& reference, RowMatrix& out) const;
  void frame_derivatives(int frame, const Reference& reference, FrameDerivatives& out) const;
  /// Returns the pose error of a frame: the SE(3) logarithm of the frame's pose relative to the
  /// pose `target` [m, rad].
  Vector6 placement_error(int frame, const Eigen::Isometry3d& target) const;
  void placement_derivatives(int frame, const Eigen::Isometry3d& target,
                             PlacementDerivatives& out) const;

  double mass() const;                   ///< Mass of all moving bodies [kg]
  Eigen::Vector3d com() const;           ///< Position of the centre of mass in the world [m]
  Eigen::Vector3d com_velocity() const;  ///< Velocity of the centre of mass, world axes [m/s]
  Vector6 momentum() const;              ///< Momentum about the world's origin [kg m/s, kg m^2/s]
  Vector6 centroidal_momentum() const;   ///< Momentum about the centre of mass, world axes
  double kinetic_energy() const;         ///< v^T M v / 2, with the armature [J]
  double potential_energy() const;  ///< Potential energy of gravity, zero at the world's origin [J]
  VectorView gravity_torque() const;  ///< Joint torques that hold the robot at rest [Nm or N]

  /// Torques (nv) of springs and tendons at q, and of damping and smoothed friction at v [Nm or N].
  VectorView passive_torque() const;
  double spring_energy() const;  ///< Energy stored in springs of joints and tendons [J]

  /// Computes all derivatives, from com_dq() to passive_torque_dv(), at the last accepted state.
  /// After update() or set_payload(), these views are outdated until update_derivatives() is called
  /// again. Python rejects outdated views.
  void update_derivatives();
  MatrixView com_dq() const;                  ///< 3 x nv; equals d(com_velocity)/dv
  MatrixView com_velocity_dq() const;         ///< 3 x nv
  MatrixView momentum_dq() const;             ///< 6 x nv
  MatrixView momentum_dv() const;             ///< 6 x nv
  MatrixView centroidal_momentum_dq() const;  ///< 6 x nv
  MatrixView centroidal_momentum_dv() const;  ///< Centroidal momentum matrix, 6 x nv
  VectorView kinetic_energy_dq() const;       ///< nv entries
  VectorView kinetic_energy_dv() const;       ///< nv entries; equals M v
  VectorView potential_energy_dq() const;     ///< nv entries; equals the gravity torque
  MatrixView passive_torque_dq() const;       ///< nv x nv
  MatrixView passive_torque_dv() const;       ///< nv x nv; diagonal unless tendons have dampers

 private:
  friend class ContactDynamics;
  KinematicState state() const;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
