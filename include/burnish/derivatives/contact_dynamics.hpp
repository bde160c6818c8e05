// Contact dynamics of one state at a time, with Eigen types. Evaluations allocate nothing after
// construction.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/base/status.hpp"
#include "burnish/base/views.hpp"
#include "burnish/contact/contact_force.hpp"
#include "burnish/contact/contact_set.hpp"
#include "burnish/model/inertia.hpp"

namespace burnish {

class RigidBody;

/// Derivatives of a contact wrench, written in a chosen Reference. Each matrix is 6 x nv, with the
/// force rows first.
/// @described derivatives @result
struct WrenchDerivatives {
  /// Derivative with respect to a right tangent increment of q @more Units are N/rad and Nm/rad for
  /// revolute joints, N/m and Nm/m for prismatic joints.
  RowMatrix dq;
  RowMatrix dv;
  /// Derivative with respect to joint torques @more For revolute joints, force rows are in 1/m and
  /// moment rows have no unit.
  RowMatrix dtau;
};

/// Derivatives with respect to the inertia parameters of selected bodies. Each matrix has ten
/// columns per body. Bodies are in the requested order, and parameters are in the order of
/// inertia_parameter_names.
struct InertiaDerivatives {
  RowMatrix a;       ///< Derivatives of the joint accelerations, nv rows
  RowMatrix lambda;  ///< Derivatives of the contact forces, rows() rows
};

/// Dynamics of a robot in contact, with all derivatives (eqs. 1 to 6 and 30 to 32 of Kleff et al.,
/// see docs/frames.md).
///
/// Equation of motion: M a + b = tau + J^T lambda, with the mass matrix M, joint accelerations a,
/// bias torques b, joint torques tau, contact Jacobian J and contact forces lambda. Motions and
/// forces have the linear part first. d/dq is the derivative with respect to a right increment dq
/// with nv entries: q (+) dq. lambda, J and the contact accelerations alpha have one row per
/// constrained direction of each active contact, in the order of contacts(). Views are valid while
/// the object exists and show the result of the last call that filled them.
///
/// The functions update(), forward(), inverse() and acceleration() evaluate a state, and each fills
/// some of the views. The other views are then outdated: they may show another state, with other
/// active contacts. For example, lambda() is outdated after acceleration(), and tau() and dtau_dq()
/// are outdated after forward(). Derivatives are outdated until they are computed again. If
/// outdated results are needed, derivative functions return NotEvaluated, wrench_derivatives()
/// throws Error, and force() and wrench() return zero. Python rejects all outdated results.
///
/// Evaluations return a Status and throw nothing. An evaluation that returns WrongSize or
/// NotEvaluated leaves all results unchanged. If a state cannot be evaluated for another reason,
/// all results are set to zero.
class ContactDynamics {
 public:
  /// Compiles `contacts` for `model`. Throws Error for contacts that ContactSet rejects.
  explicit ContactDynamics(const Model& model, const std::vector<ContactSpec>& contacts = {},
                           const ContactSolver& solver = {});
  ~ContactDynamics();
  ContactDynamics(ContactDynamics&&) noexcept;
  ContactDynamics& operator=(ContactDynamics&&) noexcept;

  const ContactSet& contacts() const;
  int nv() const;
  int rows() const;  ///< Number of rows of the active contacts

  /// Activates or deactivates a contact. Does not allocate. Throws Error for an unknown index.
  void set_active(int contact, bool active);
  bool is_active(int contact) const;
  /// Replaces the rotation of a contact's reference; later evaluations use the new rotation. Does
  /// not allocate. Returns Ok. If `rotation` differs from a rotation matrix by more than 1e-6,
  /// returns NotNormalized and changes nothing. Throws Error for an unknown index.
  Status set_reference_rotation(int contact, const Eigen::Matrix3d& rotation);
  /// Replaces the surface that a contact's reference follows (Reference::on); later evaluations use
  /// the new surface. `surface` is written in the base's axes. Does not allocate. Returns Ok. If
  /// `surface` contains a NaN or an infinity, returns NotFinite and changes nothing. Throws Error
  /// for an unknown index and for a reference without a surface.
  Status set_surface(int contact, const Quadric& surface);
  /// Replaces the friction coefficient of a contact; later evaluations use the new coefficient.
  /// Does not allocate. Returns Ok. If `coefficient` is negative or not finite, returns NotFinite
  /// and changes nothing. Throws Error for an unknown index and for a contact without friction.
  Status set_friction(int contact, double coefficient);
  /// Sets the payload that the robot carries at a frame; later evaluations include the payload.
  /// `payload` is written in the axes of the frame. The payload is added to the inertia of the body
  /// that carries the frame, and replaces an earlier payload of the same body. A mass of 0 removes
  /// the payload. Does not allocate.
  ///
  /// Returns Ok. If check_inertia() returns NotFinite or NotPhysical for `payload`, returns this
  /// status and changes nothing. Throws Error if the frame is fixed to the world. For an unknown
  /// frame, throws Error with the nearest known name.
  Status set_payload(std::string_view frame, const InertiaSpec& payload);
  /// Returns the names of the active rows, such as "pad/z".
  std::vector<std::string> row_names() const;

  /// Computes joint accelerations and contact forces from `q` (nq), `v` (nv) and the joint torques
  /// `tau` (nv) [Nm or N]. Fills a(), lambda(), mass_matrix(), bias() and jacobian().
  Status forward(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& tau);
  /// Loads the state `q` (nq) and `v` (nv), and fills mass_matrix(), bias() and jacobian(). Returns
  /// Ok, WrongSize, NotFinite or NotNormalized.
  Status update(const ConstVectorRef& q, const ConstVectorRef& v);
  /// Does what update(q, v) does, at the last accepted state of `body`, and reuses the kinematics
  /// of `body`. `body` must have the same model; its payload has no effect. Before its first
  /// update(), the state of `body` is the neutral configuration at rest. Returns WrongSize if the
  /// joint trees have different sizes; other differences of the models are not detected.
  Status update(const RigidBody& body);
  /// Computes joint accelerations and contact forces at the state of the last update() or other
  /// evaluation, without computing kinematics and mass matrix again. Active contacts, references,
  /// surfaces and friction may have changed since that evaluation. Returns NotEvaluated if no state
  /// was evaluated, or if a payload was set since that evaluation.
  Status forward(const ConstVectorRef& tau);
  /// Computes the six derivatives of a and lambda with respect to q, v and tau, at the state of the
  /// last forward().
  Status forward_derivatives();

  /// Computes the joint torques tau = M a + b - J^T lambda from joint accelerations `a` (nv) and
  /// contact forces `lambda` (rows()).
  Status inverse(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& a,
                 const ConstVectorRef& lambda);
  /// Computes dtau_dq() and dtau_dv() at the state of the last inverse(). The other two derivatives
  /// are dtau/da = mass_matrix() and dtau/dlambda = -jacobian()^T (Proposition 4 of Kleff et al.).
  Status inverse_derivatives();

  /// Computes alpha() from the joint accelerations `a` (nv): alpha = J a + alpha_0 + kd nu + kp e.
  /// J a + alpha_0 is the contact acceleration. kd nu + kp e is the Baumgarte stabilization, with
  /// the contact velocity nu and the pose error e.
  Status acceleration(const ConstVectorRef& q, const ConstVectorRef& v, const ConstVectorRef& a);
  /// Computes dalpha_dq() and dalpha_dv() at the state of the last acceleration(). The derivative
  /// dalpha/da is jacobian() (Proposition 3 of Kleff et al.).
  Status acceleration_derivatives();

  /// Computes columns of the regressor Y of inverse dynamics, at the state of the last forward() or
  /// inverse():
  ///   M a + b = Y theta + diag(armature) a.
  /// The vector theta holds the inertia parameters of all bodies (inertia_parameters). `bodies`
  /// selects bodies by the indices of their joints in the model. `out` has nv rows and ten columns
  /// per selected body, and is resized on first use. Throws Error for an unknown body.
  Status regressor(std::span<const int> bodies, RowMatrix& out);
  /// Computes the derivatives of a and lambda with respect to the inertia parameters theta of
  /// `bodies`: d(a, lambda)/dtheta = -d(a, lambda)/dtau Y, with the regressor Y. The joint torques
  /// stay at their values in the last forward(). Returns NotEvaluated unless forward_derivatives()
  /// was called after the last forward().
  Status inertia_derivatives(std::span<const int> bodies, InertiaDerivatives& out);

  VectorView a() const;            ///< Joint accelerations, nv [rad/s^2 or m/s^2]
  VectorView lambda() const;       ///< Contact forces, one per active row [N or Nm]
  VectorView tau() const;          ///< Joint torques, nv [Nm or N]
  VectorView alpha() const;        ///< Result of acceleration(), per active row [m/s^2 or rad/s^2]
  VectorView bias() const;         ///< Bias torques b(q, v), nv [Nm or N]
  MatrixView mass_matrix() const;  ///< Mass matrix with the armature, nv x nv
  MatrixView jacobian() const;     ///< Contact Jacobian, rows x nv

  MatrixView da_dq() const;         ///< nv x nv
  MatrixView da_dv() const;         ///< nv x nv
  MatrixView da_dtau() const;       ///< nv x nv
  MatrixView dlambda_dq() const;    ///< rows x nv
  MatrixView dlambda_dv() const;    ///< rows x nv
  MatrixView dlambda_dtau() const;  ///< rows x nv
  MatrixView dtau_dq() const;       ///< nv x nv
  MatrixView dtau_dv() const;       ///< nv x nv
  MatrixView dalpha_dq() const;     ///< rows x nv
  MatrixView dalpha_dv() const;     ///< rows x nv

  /// Contact velocity nu, one entry per active row, at the last state
  VectorView contact_velocity() const;
  VectorView contact_error() const;  ///< Pose error e, one entry per active row, at the last state

  /// Returns a sentence about the status of the last evaluation and its cause. Possible causes are
  /// joints that move no mass, and contact rows that cannot be satisfied independently. Allocates
  /// memory.
  std::string explanation() const;

  int proximal_iterations() const;  ///< Number of proximal iterations of the last forward()

  /// Contact acceleration error after proximal iterations [m/s^2]
  double proximal_residual() const;

  /// Contact acceleration that no contact force can cancel, one entry per active row, at the last
  /// forward() [m/s^2 or rad/s^2]. This acceleration is not zero if redundant contact rows
  /// contradict each other. Only proximal iterations detect such rows. The status is then
  /// NotConverged, and lambda() is the least-squares solution of smallest norm. All derivatives are
  /// derivatives of this solution.
  VectorView unmet() const;

  /// Returns the force of an active contact, written in the contact's own reference. The force is
  /// the result of the last forward(), or the lambda that was passed to the last inverse(). After
  /// any other evaluation, the force is zero, and Python rejects the call. Allocates memory. In
  /// control loops, use wrench() instead.
  ContactForce force(int contact) const;
  ContactForce force(const std::string& contact) const;
  /// Returns the force of an active contact, written in `reference`. Throws Error with the nearest
  /// known name if `reference` names a frame that the robot does not have.
  ContactForce force(int contact, const Reference& reference) const;
  /// Returns the wrench of an active contact, force before moment, written in `reference` [N, Nm].
  /// Throws Error with the nearest known name if `reference` names a frame that the robot does not
  /// have.
  Vector6 wrench(int contact, const Reference& reference) const;
  /// Computes the derivatives of wrench() from the result of forward_derivatives(). `out` is
  /// resized on first use. Throws Error unless forward_derivatives() was called after the last
  /// evaluation. Also throws Error if `reference` names a frame that the robot does not have.
  void wrench_derivatives(int contact, const Reference& reference, WrenchDerivatives& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
